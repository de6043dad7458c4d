//! Holding a tree of TOML values against the schema: keys, types, ranges and lengths.

use super::error::{Fault, Problem};
use super::renamed;
use super::schema::{Kind, Shape};
use crate::suggest::nearest;
use toml::{Table, Value};

/// Checks that `table`, found at `path`, has only keys that `shape` has, with valid values.
pub(super) fn check_table(shape: Shape<'_>, table: &Table, path: &mut Vec<String>) -> Result<(), Fault> {
    for (key, value) in table {
        let Some(child) = shape.child(key) else {
            return Err(unknown_key(shape, path, key));
        };
        path.push(key.clone());
        check_value(child, value, path)?;
        path.pop();
    }
    for key in shape.required() {
        if !table.contains_key(key) {
            path.push(key.to_owned());
            let expected = shape.child(key).map_or_else(|| "a value".to_owned(), Shape::expected);
            return Err(Fault::at(path, Problem::MissingKey { expected }));
        }
    }
    Ok(())
}

/// Checks that `value`, found at `path`, is one that `shape` allows.
pub(super) fn check_value(shape: Shape<'_>, value: &Value, path: &mut Vec<String>) -> Result<(), Fault> {
    let valid = match (shape.kind(), value) {
        (Kind::Table, Value::Table(table)) => return check_table(shape, table, path),
        (Kind::List { least, most }, Value::Array(items)) => {
            for (index, item) in items.iter().enumerate() {
                path.push(index.to_string());
                check_value(shape.item(), item, path)?;
                path.pop();
            }
            (least..=most).contains(&items.len())
        }
        (Kind::List { .. }, Value::Table(members)) => return Err(table_for_list(members, path)),
        (Kind::Number, Value::Float(number)) => in_range(shape, *number),
        (Kind::Number | Kind::WholeNumber, Value::Integer(number)) => in_range(shape, *number as f64),
        (Kind::Choice(choices), Value::String(text)) => choices.contains(&text.as_str()),
        (Kind::Switch, Value::Boolean(_)) | (Kind::Text, Value::String(_)) => true,
        _ => false,
    };
    if valid { Ok(()) } else { Err(wrong_value(shape, path, value)) }
}

/// Numbers are compared as the f32 that they become, so that 0.02 is not below 0.02.
fn in_range(shape: Shape<'_>, number: f64) -> bool {
    let number = number as f32;
    let (least, most, excluded) = shape.range();
    number.is_finite() && number >= least && number <= most && !(excluded && number == least)
}

/// One table where a list of them is expected.
fn table_for_list(members: &Table, path: &[String]) -> Fault {
    let old = members.keys().find_map(|key| Some((key, renamed::key(path, key)?)));
    old.map_or_else(
        || {
            let key = path.join(".");
            Fault::contradiction(
                &key,
                "found a table, expected a list",
                format!("write `[[{key}]]`, once for each item"),
            )
        },
        |(key, new)| renamed_key(path, key, new),
    )
}

pub(super) fn renamed_key(path: &[String], key: &str, new: &str) -> Fault {
    Fault::at(&[path, &[key.to_owned()]].concat(), Problem::RenamedKey { new: new.to_owned() })
}

pub(super) fn unknown_key(shape: Shape<'_>, path: &[String], key: &str) -> Fault {
    if let Some(new) = renamed::key(path, key) {
        return renamed_key(path, key, new);
    }
    // Of a list's items the first stands for all.
    let (known, item) = match shape.kind() {
        Kind::List { .. } => (shape.item().keys(), Some("0")),
        _ => (shape.keys(), None),
    };
    let full = |name: &str| path.iter().map(String::as_str).chain(item).chain([name]).collect::<Vec<_>>().join(".");
    let near = nearest(key, known.iter().copied());
    let nearest = near.map(full).or_else(|| elsewhere(path, key));
    let known = known.into_iter().map(|key| item.map_or_else(|| key.to_owned(), |item| format!("{item}.{key}")));
    let problem = Problem::UnknownKey { nearest, known: known.collect() };
    Fault { path: [path, &[key.to_owned()]].concat(), problem }
}

/// The key of that name in another table; where there are several, that in the table that is declared first.
fn elsewhere(path: &[String], name: &str) -> Option<String> {
    let keys = super::describe_keys();
    let inside =
        |key: &&super::KeyDescription| path.first().is_none_or(|first| key.path.split('.').next() == Some(first));
    let same = |key: &&super::KeyDescription| key.name == name;
    let found = keys.iter().filter(same).find(inside).or_else(|| keys.iter().find(same));
    found.map(|key| key.path.clone())
}

fn wrong_value(shape: Shape<'_>, path: &[String], value: &Value) -> Fault {
    let near = match (shape.kind(), value) {
        (Kind::Choice(choices), Value::String(text)) => nearest(text, choices),
        _ => None,
    };
    let new = value.as_str().and_then(|text| renamed::value(path, text));
    Fault::at(
        path,
        Problem::WrongValue {
            found: found(value),
            expected: shape.expected(),
            nearest: new.or(near).map(str::to_owned),
            default: shape.default(),
        },
    )
}

/// The value as a message shows it: short ones in full, lists and tables by their size.
fn found(value: &Value) -> String {
    const LONGEST: usize = 60;
    match value {
        Value::Array(items) if items.len() == 1 => "a list of 1 item".to_owned(),
        Value::Array(items) => format!("a list of {} items", items.len()),
        Value::Table(_) => "a table".to_owned(),
        Value::String(text) if text.chars().count() > LONGEST => {
            format!("the text \"{}…\"", text.chars().take(LONGEST).collect::<String>())
        }
        other => other.to_string(),
    }
}

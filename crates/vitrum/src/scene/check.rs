//! Holding a tree of TOML values against the schema: keys, types, ranges and lengths.

use super::error::{Fault, Problem};
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

pub(super) fn unknown_key(shape: Shape<'_>, path: &[String], key: &str) -> Fault {
    let full = |name: &str| path.iter().map(String::as_str).chain([name]).collect::<Vec<_>>().join(".");
    let mut path = path.to_vec();
    let known = shape.keys();
    let near = nearest(key, known.iter().copied());
    let problem =
        Problem::UnknownKey { nearest: near.map(full), known: known.into_iter().map(str::to_owned).collect() };
    path.push(key.to_owned());
    Fault { path, problem }
}

fn wrong_value(shape: Shape<'_>, path: &[String], value: &Value) -> Fault {
    let near = match (shape.kind(), value) {
        (Kind::Choice(choices), Value::String(text)) => nearest(text, choices),
        _ => None,
    };
    Fault::at(
        path,
        Problem::WrongValue {
            found: found(value),
            expected: shape.expected(),
            nearest: near.map(str::to_owned),
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

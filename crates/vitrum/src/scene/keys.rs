//! The description of every scene key, out of the schema: for the documentation, and for people who ask the program.

use super::schema::SCHEMA;
use serde_json::Value;

/// The description of a scene key. Names of keys and values stand in backticks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyDescription {
    /// Dotted path of the key, with 0 for the items of lists, such as `light.0.azimuth`.
    pub path: String,
    /// Dotted path of the table that holds the key, without the indices of lists; empty for keys of the scene itself.
    pub table: String,
    /// Name of the key in its table.
    pub name: String,
    /// Unit of the value; empty where it has none.
    pub unit: String,
    /// Valid values.
    pub range: String,
    /// The value of a key that is left out; `—` where there is none, `required` where it must not be left out.
    pub default: String,
    /// Meaning of the key, and of each of its choices.
    pub meaning: String,
}

/// The descriptions of all keys, in the order in which the scene declares them.
#[must_use]
pub fn describe_keys() -> Vec<KeyDescription> {
    let mut keys = Vec::new();
    gather(&SCHEMA, "", "", &mut keys);
    keys
}

/// Describes the keys of a table: first those that hold values, then those of tables and lists of tables inside.
fn gather(shape: &'static Value, table: &str, path: &str, keys: &mut Vec<KeyDescription>) {
    let Some(members) = shape["properties"].as_object() else { return };
    let join = |parent: &str, name: &str| if parent.is_empty() { name.to_owned() } else { format!("{parent}.{name}") };
    let required = |key: &str| shape["required"].as_array().is_some_and(|all| all.iter().any(|one| one == key));
    for (name, outer) in members {
        let inner = resolved(outer);
        let is_section = table.is_empty() && resolved(&inner["items"]).get("properties").is_some();
        if inner.get("properties").is_some() || is_section {
            continue;
        }
        keys.push(KeyDescription {
            path: join(path, name),
            table: table.to_owned(),
            name: name.clone(),
            unit: outer["x-unit"].as_str().unwrap_or_default().to_owned(),
            range: outer["x-range"].as_str().map_or_else(|| range(outer, inner), str::to_owned),
            default: if required(name) { "required".to_owned() } else { default(outer.get("default")) },
            meaning: meaning(outer, inner),
        });
    }
    for (name, outer) in members {
        let inner = resolved(outer);
        let item = resolved(&inner["items"]);
        if inner.get("properties").is_some() {
            gather(inner, &join(table, name), &join(path, name), keys);
        } else if item.get("properties").is_some() {
            gather(item, &join(table, name), &join(path, &format!("{name}.0")), keys);
        }
    }
}

/// The schema of a key's values, with references resolved; for an optional key, the schema of a value that is present.
fn resolved(value: &'static Value) -> &'static Value {
    let some = value["anyOf"].as_array().and_then(|all| all.iter().find(|one| one["type"] != "null"));
    let value = some.unwrap_or(value);
    match value["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/")) {
        Some(name) => &SCHEMA["$defs"][name],
        None => value,
    }
}

fn range(outer: &Value, shape: &'static Value) -> String {
    if let Some(choices) = shape["oneOf"].as_array() {
        return choices.iter().map(|choice| format!("`{}`", words(&choice["const"]))).collect::<Vec<_>>().join(", ");
    }
    let is = |name: &str| match &shape["type"] {
        Value::Array(types) => types.iter().any(|one| one == name),
        one => one == name,
    };
    if is("array") {
        let items = resolved(&shape["items"]);
        let count = if shape["minItems"] == 2 { "two" } else { "three" };
        if shape["minItems"].is_null() && items["type"] == "number" && bounds(items).is_none() {
            return "a list of numbers".to_owned();
        }
        return match bounds(items) {
            _ if items.get("properties").is_some() => "a list of points".to_owned(),
            None => format!("{count} numbers"),
            Some(bounds) if outer["x-color"] == true => format!("{count} numbers, each {bounds}, or a colour"),
            Some(bounds) => format!("{count} numbers, each {bounds}"),
        };
    }
    match bounds(shape) {
        Some(bounds) => bounds,
        None if is("boolean") => "`true`, `false`".to_owned(),
        None if is("string") => "a text".to_owned(),
        None => "any".to_owned(),
    }
}

fn bounds(shape: &Value) -> Option<String> {
    let bound = |name: &str| shape.get(name).map(words);
    match (bound("exclusiveMinimum"), bound("minimum"), bound("maximum")) {
        (Some(least), _, None) => Some(format!("above {least}")),
        (Some(least), _, Some(most)) => Some(format!("above {least}, to {most}")),
        (None, Some(least), Some(most)) => Some(format!("{least} to {most}")),
        (None, Some(least), None) => Some(format!("{least} or more")),
        (None, None, _) => None,
    }
}

fn default(value: Option<&Value>) -> String {
    match value {
        None | Some(Value::Null) => "—".to_owned(),
        Some(Value::String(text)) => format!("`{text}`"),
        Some(other) => words(other),
    }
}

/// A value as the tables show it: 1000000.0 is 1e6, 1.0 is 1.
fn words(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => match number.as_f64() {
            Some(large) if number.is_f64() && large.abs() >= 1e6 => format!("{large:e}"),
            Some(number) => number.to_string(),
            None => number.to_string(),
        },
        Value::Array(items) => format!("[{}]", items.iter().map(words).collect::<Vec<_>>().join(", ")),
        other => other.to_string(),
    }
}

/// The description of the key, followed by the descriptions of its choices.
fn meaning(outer: &Value, inner: &Value) -> String {
    let text = |value: &Value| value["description"].as_str().unwrap_or_default().replace('\n', " ");
    let mut meaning = text(outer);
    for choice in inner["oneOf"].as_array().into_iter().flatten() {
        meaning += &format!(" `{}`: {}", words(&choice["const"]), uncapitalized(&text(choice)));
    }
    meaning
}

/// The sentence as it stands behind a colon.
fn uncapitalized(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

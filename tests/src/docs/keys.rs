//! Tables of scene keys, out of the scene's JSON schema.
//!
//! A page marks the place of the table of the keys in `light`, say, by the lines `<!-- keys of light -->` and `<!-- end -->`; keys of
//! the scene itself are those `of the scene`.

use serde_json::Value;

use super::sections;

const HEAD: &str = "| key | unit | range | default | meaning |\n|---|---|---|---|---|\n";

/// The page with its tables of keys made anew.
pub(super) fn filled(page: &str, schema: &Value) -> Result<String, String> {
    sections::filled(page, "keys", |path| table(schema, if path == "the scene" { "" } else { path }))
}

/// The table of the keys at a dotted path.
fn table(schema: &Value, path: &str) -> Result<String, String> {
    let mut place = schema;
    for segment in path.split('.').filter(|segment| !segment.is_empty()) {
        place = match resolved(schema, &place["properties"][segment]) {
            list if list.get("items").is_some() => resolved(schema, &list["items"]),
            table => table,
        };
    }
    let keys = place["properties"].as_object().ok_or_else(|| format!("the scene has no table `{path}`"))?;
    let required = |key: &str| place["required"].as_array().is_some_and(|all| all.iter().any(|one| one == key));
    let rows = keys.iter().filter(|(_, outer)| {
        let inner = resolved(schema, outer);
        let section = path.is_empty() && resolved(schema, &inner["items"]).get("properties").is_some();
        inner.get("properties").is_none() && !section
    });
    let rows = rows.map(|(key, outer)| {
        let inner = resolved(schema, outer);
        let unit = outer["x-unit"].as_str().unwrap_or_default();
        let range = outer["x-range"].as_str().map_or_else(|| range(schema, inner), str::to_owned);
        let default = if required(key) { "required".to_owned() } else { default(outer.get("default")) };
        let meaning = meaning(outer, inner);
        let row = format!("| `{key}` | {unit} | {range} | {default} | {meaning} |\n");
        row.replace("|  |", "| |").replace("|  |", "| |")
    });
    Ok(HEAD.chars().chain(rows.collect::<String>().chars()).collect())
}

/// The schema of a key's values, with references resolved; for an optional key, the schema of a value that is present.
fn resolved<'a>(schema: &'a Value, value: &'a Value) -> &'a Value {
    let some = value["anyOf"].as_array().and_then(|all| all.iter().find(|one| one["type"] != "null"));
    let value = some.unwrap_or(value);
    match value["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/")) {
        Some(name) => &schema["$defs"][name],
        None => value,
    }
}

fn range(schema: &Value, shape: &Value) -> String {
    if let Some(choices) = shape["oneOf"].as_array() {
        return choices.iter().map(|choice| format!("`{}`", words(&choice["const"]))).collect::<Vec<_>>().join(", ");
    }
    let is = |name: &str| match &shape["type"] {
        Value::Array(types) => types.iter().any(|one| one == name),
        one => one == name,
    };
    if is("array") {
        let items = resolved(schema, &shape["items"]);
        let count = if shape["minItems"] == 2 { "two" } else { "three" };
        return match bounds(items) {
            _ if items.get("properties").is_some() => "a list of points".to_owned(),
            None => format!("{count} numbers"),
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
    meaning.replace('|', "\\|")
}

/// The sentence as it stands behind a colon.
fn uncapitalized(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn schema() -> Value {
        serde_json::from_str(&vitrum::scene::Scene::json_schema()).unwrap()
    }

    #[test]
    fn tables_stand_between_their_marks_and_the_rest_stays() {
        let page = "before\n<!-- keys of ground -->\nold\n<!-- end -->\nafter\n";
        let text = filled(page, &schema()).unwrap();
        assert!(
            text.starts_with(&format!("before\n<!-- keys of ground -->\n{HEAD}| `height` | world units | any | — |"))
        );
        assert!(text.ends_with("|\n<!-- end -->\nafter\n") && !text.contains("old"), "{text}");
        assert_eq!(filled(&text, &schema()), Ok(text), "once more changes nothing");
    }

    #[test]
    fn marks_that_are_wrong_are_refused() {
        assert!(filled("<!-- keys of grond -->\n<!-- end -->\n", &schema()).unwrap_err().contains("`grond`"));
        assert!(filled("<!-- keys of ground -->\n", &schema()).unwrap_err().contains("<!-- end -->"));
    }

    #[test]
    fn rows_say_choices_ranges_and_defaults() {
        let text = table(&schema(), "light").unwrap();
        assert!(text.contains("| `kind` | | `distant`, `point`, `spot` | `distant` |"), "{text}");
        assert!(text.contains("| `color` | radiance | three numbers, each 0 to 1e6 | [1, 1, 1] |"), "{text}");
        assert!(table(&schema(), "transfer.ior").unwrap().contains("| `ior` | | 0.2 to 5 | required |"));
        assert!(
            table(&schema(), "").unwrap().contains("| `method` |") && !table(&schema(), "").unwrap().contains("`clip`")
        );
    }
}

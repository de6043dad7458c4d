//! `docs/scene.md` documents every key of the scene with its range and its default, and no key that does not exist.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use vitrum::scene::Scene;

/// The entry of a key on the page, or in the schema.
#[derive(Debug, PartialEq)]
struct Entry {
    range: String,
    default: String,
}

/// The page's tables, by dotted path: the heading's key and the row's.
fn documented() -> BTreeMap<String, Entry> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/scene.md");
    let page = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut section = None;
    let mut entries = BTreeMap::new();
    for line in page.lines() {
        if let Some(heading) = line.strip_prefix("## ").or_else(|| line.strip_prefix("### ")) {
            section = heading.strip_prefix('`').and_then(|heading| heading.strip_suffix('`'));
        }
        let cells: Vec<_> = line.trim_matches('|').split('|').map(str::trim).collect();
        if let [key, _, range, default, _] = &cells[..]
            && let Some(key) = key.strip_prefix('`').and_then(|key| key.strip_suffix('`'))
        {
            let entry = Entry { range: (*range).to_owned(), default: default.trim_matches('`').to_owned() };
            // Keys of the scene itself stand before the first heading.
            let path = section.map_or(key.to_owned(), |section: &str| format!("{section}.{key}"));
            assert!(entries.insert(path, entry).is_none(), "{key} stands twice in {section:?}");
        }
    }
    entries
}

/// The entries of the schema, whose words the page has to use.
fn declared() -> BTreeMap<String, Entry> {
    let schema: Value = serde_json::from_str(&Scene::json_schema()).expect("the schema is JSON");
    let mut entries = BTreeMap::new();
    collect(&schema, &schema, "", &mut entries);
    entries
}

fn collect(schema: &Value, table: &Value, path: &str, entries: &mut BTreeMap<String, Entry>) {
    let required: BTreeSet<_> = table["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    for (key, outer) in table["properties"].as_object().expect("a table has keys") {
        let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
        let inner = resolved(schema, outer);
        let items = resolved(schema, &inner["items"]);
        if inner.get("properties").is_some() {
            collect(schema, inner, &path, entries);
            continue;
        }
        if items.get("properties").is_some() {
            collect(schema, items, &path, entries);
            if !path.contains('.') {
                continue;
            }
        }
        let default = if required.contains(key.as_str()) { "required".to_owned() } else { words(outer.get("default")) };
        entries.insert(path, Entry { range: range(inner, items), default });
    }
}

fn resolved<'a>(schema: &'a Value, value: &'a Value) -> &'a Value {
    let some = value["anyOf"].as_array().and_then(|all| all.iter().find(|one| one["type"] != "null"));
    let value = some.unwrap_or(value);
    match value["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/")) {
        Some(name) => &schema["$defs"][name],
        None => value,
    }
}

/// The range in the page's words; empty where the page is free to choose its own.
fn range(shape: &Value, items: &Value) -> String {
    if let Some(choices) = shape["oneOf"].as_array() {
        let choices: Vec<_> = choices.iter().map(|choice| words(choice.get("const"))).collect();
        return format!("`{}`", choices.join("`, `"));
    }
    let bounds = |shape: &Value| match (shape.get("minimum"), shape.get("maximum"), shape.get("exclusiveMinimum")) {
        (None, None, None) => String::new(),
        (_, Some(most), Some(least)) => format!("above {}, to {}", words(Some(least)), words(Some(most))),
        (_, None, Some(least)) => format!("above {}", words(Some(least))),
        (Some(least), None, None) => format!("{} or more", words(Some(least))),
        (least, most, None) => format!("{} to {}", words(least), words(most)),
    };
    match bounds(items) {
        inner if inner.is_empty() => bounds(shape),
        inner => format!("{} numbers, each {inner}", if shape["minItems"] == 2 { "two" } else { "three" }),
    }
}

fn words(value: Option<&Value>) -> String {
    match value {
        None | Some(Value::Null) => "—".to_owned(),
        Some(Value::String(text)) => text.clone(),
        Some(Value::Number(number)) => match number.as_f64() {
            Some(large) if number.is_f64() && large >= 1e6 => format!("{large:e}"),
            Some(number) => number.to_string(),
            None => number.to_string(),
        },
        Some(Value::Array(items)) => {
            format!("[{}]", items.iter().map(|item| words(Some(item))).collect::<Vec<_>>().join(", "))
        }
        Some(other) => other.to_string(),
    }
}

#[test]
fn every_key_is_documented_and_every_documented_key_exists() {
    let (documented, declared) = (documented(), declared());
    assert!(declared.len() > 60, "the schema was not understood: {declared:?}");
    let keys = |entries: &BTreeMap<String, Entry>| entries.keys().cloned().collect::<BTreeSet<_>>();
    let missing: Vec<_> = keys(&declared).difference(&keys(&documented)).cloned().collect();
    let invented: Vec<_> = keys(&documented).difference(&keys(&declared)).cloned().collect();
    assert!(missing.is_empty(), "docs/scene.md lacks {missing:?}");
    assert!(invented.is_empty(), "docs/scene.md has keys that do not exist: {invented:?}");
}

#[test]
fn defaults_and_ranges_are_those_of_the_code() {
    let documented = documented();
    for (key, declared) in declared() {
        let page = &documented[&key];
        assert_eq!(page.default, declared.default, "default of {key}");
        assert!(!page.range.is_empty(), "{key} has no range");
        if !declared.range.is_empty() {
            // Colours have names, too.
            assert_eq!(page.range.trim_end_matches(", or a colour"), declared.range, "range of {key}");
        }
    }
}

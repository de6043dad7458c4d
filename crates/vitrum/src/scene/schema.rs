//! The scene's JSON schema, and the questions that checking asks it.
//!
//! Ranges stand once, as `#[schemars(…)]` attributes on the scene's fields: the published schema, the checks of scene
//! files and settings, and the test that holds `docs/scene.md` against the code all read them from here.

use super::{Scene, colors};
use schemars::schema_for;
use serde_json::{Map, Value, json};
use std::sync::LazyLock;

pub(super) static SCHEMA: LazyLock<Value> = LazyLock::new(|| {
    let mut schema = schema_for!(Scene).to_value();
    shorten_defaults(&mut schema, false);
    allow_names_of_colors(&mut schema);
    schema
});

impl Scene {
    /// The JSON schema (draft 2020-12) of scene files, for editors and other programs.
    #[must_use]
    pub fn json_schema() -> String {
        format!("{:#}", *SCHEMA)
    }
}

/// Turns 0.30000001192092896, an f32 default widened to f64, back into 0.3.
fn shorten_defaults(value: &mut Value, inside_default: bool) {
    match value {
        Value::Number(number) if inside_default && number.is_f64() => {
            let narrow = number.as_f64().map(|wide| (wide as f32).to_string());
            if let Some(short) = narrow.and_then(|text| text.parse().ok()).and_then(serde_json::Number::from_f64) {
                *number = short;
            }
        }
        Value::Array(items) => items.iter_mut().for_each(|item| shorten_defaults(item, inside_default)),
        Value::Object(members) => {
            for (name, member) in members {
                shorten_defaults(member, inside_default || name == "default");
            }
        }
        _ => {}
    }
}

/// Lets keys that hold colours hold their names as well.
fn allow_names_of_colors(value: &mut Value) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(allow_names_of_colors),
        Value::Object(members) => {
            members.values_mut().for_each(allow_names_of_colors);
            let is_of_color =
                members.get("x-unit").and_then(Value::as_str).is_some_and(|unit| colors::UNITS.contains(&unit));
            if !is_of_color || members.get("maxItems") != Some(&json!(3)) {
                return;
            }
            let mut list = Map::new();
            let is_optional = members.get("type").is_some_and(Value::is_array);
            for name in ["items", "minItems", "maxItems"] {
                list.extend(members.shift_remove(name).map(|value| (name.to_owned(), value)));
            }
            list.insert("type".to_owned(), json!("array"));
            let name = json!({ "type": "string", "description": "A colour of CSS, such as `white` or `#fff`." });
            let alternatives =
                [Value::Object(list), name].into_iter().chain(is_optional.then(|| json!({ "type": "null" })));
            let alternatives: Vec<Value> = alternatives.collect();
            members.shift_remove("type");
            members.insert("x-color".to_owned(), json!(true));
            members.insert("anyOf".to_owned(), alternatives.into());
        }
        _ => {}
    }
}

/// Whether two values are the same to the scene, whose numbers are f32.
fn equal(one: &Value, other: &toml::Value) -> bool {
    let number = |other: &toml::Value| other.as_float().or(other.as_integer().map(|whole| whole as f64));
    match (one, other) {
        (Value::Array(items), toml::Value::Array(others)) => {
            items.len() == others.len() && items.iter().zip(others).all(|(item, other)| equal(item, other))
        }
        (Value::Object(members), toml::Value::Table(others)) => {
            let given = members.iter().filter(|(_, value)| !value.is_null());
            given.clone().count() == others.len()
                && given.into_iter().all(|(name, value)| others.get(name).is_some_and(|other| equal(value, other)))
        }
        (Value::String(text), toml::Value::String(other)) => text == other,
        (Value::Bool(switch), toml::Value::Boolean(other)) => switch == other,
        (Value::Number(_), other) => one.as_f64().zip(number(other)).is_some_and(|(a, b)| a as f32 == b as f32),
        _ => false,
    }
}

/// The type of a value.
pub(super) enum Kind<'a> {
    Table,
    List { least: usize, most: usize },
    Choice(Vec<&'a str>),
    Number,
    WholeNumber,
    Switch,
    Text,
}

/// The schema of one key.
#[derive(Clone, Copy)]
pub(super) struct Shape<'a> {
    /// The schema as it stands at the key: default, and for optional keys the alternative null.
    outer: &'a Value,
    /// The schema of its values, with references followed.
    inner: &'a Value,
}

impl Shape<'static> {
    /// The whole scene.
    pub fn scene() -> Self {
        Self::new(&SCHEMA)
    }
}

impl<'a> Shape<'a> {
    fn new(outer: &'a Value) -> Self {
        let mut inner = outer;
        loop {
            let alternatives = inner["anyOf"].as_array();
            if let Some(name) = inner["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/")) {
                inner = &SCHEMA["$defs"][name];
            } else if let Some(some) = alternatives.and_then(|all| all.iter().find(|one| one["type"] != "null")) {
                inner = some;
            } else {
                return Self { outer, inner };
            }
        }
    }

    pub fn kind(self) -> Kind<'a> {
        let types = &self.inner["type"];
        let is = |name: &str| types == name || types.as_array().is_some_and(|all| all.iter().any(|one| one == name));
        let length = |name: &str| self.inner[name].as_u64().map(|length| length as usize);
        if let Some(choices) = self.inner["oneOf"].as_array() {
            Kind::Choice(choices.iter().filter_map(|choice| choice["const"].as_str()).collect())
        } else if is("object") {
            Kind::Table
        } else if is("array") {
            Kind::List { least: length("minItems").unwrap_or(0), most: length("maxItems").unwrap_or(usize::MAX) }
        } else if is("integer") {
            Kind::WholeNumber
        } else if is("number") {
            Kind::Number
        } else if is("boolean") {
            Kind::Switch
        } else {
            Kind::Text
        }
    }

    /// Whether the key can be left out for good, such as `ground`.
    pub fn optional(self) -> bool {
        let null = |one: &Value| one == "null" || one["type"] == "null";
        ["anyOf", "type"].iter().any(|name| self.outer[name].as_array().is_some_and(|all| all.iter().any(null)))
    }

    /// Whether the value is the one that the key has where it is left out.
    pub fn has_default(self, value: &toml::Value) -> bool {
        self.outer.get("default").is_some_and(|default| equal(default, value))
    }

    /// Whether the key holds a colour, which may be a text.
    pub fn is_color(self) -> bool {
        self.outer["x-color"] == true
    }

    /// What the key means.
    pub fn description(self) -> String {
        let text = self.outer["description"].as_str().or(self.inner["description"].as_str());
        text.unwrap_or_default().replace('\n', " ")
    }

    /// The values that a key chooses from, and what each means.
    pub fn choices(self) -> Vec<(&'a str, &'a str)> {
        let choices = self.inner["oneOf"].as_array().into_iter().flatten();
        let described = |choice: &'a Value| {
            let name = choice["const"].as_str()?;
            Some((name, choice["description"].as_str().unwrap_or_default()))
        };
        choices.filter_map(described).collect()
    }

    /// The names of a table's keys, in their order of declaration.
    pub fn keys(self) -> Vec<&'a str> {
        self.inner["properties"].as_object().map_or_else(Vec::new, |keys| keys.keys().map(String::as_str).collect())
    }

    /// The keys of a table that have no default.
    pub fn required(self) -> impl Iterator<Item = &'a str> {
        self.inner["required"].as_array().into_iter().flatten().filter_map(Value::as_str)
    }

    /// The schema of a table's key, or of a list's item by its index.
    pub fn child(self, segment: &str) -> Option<Self> {
        match self.kind() {
            Kind::Table => self.inner["properties"].get(segment).map(Self::new),
            Kind::List { .. } => segment.parse::<usize>().ok().map(|_| self.item()),
            _ => None,
        }
    }

    /// The items of a list.
    pub fn item(self) -> Self {
        Self::new(&self.inner["items"])
    }

    /// Least value, greatest value, and whether the least is excluded.
    pub fn range(self) -> (f32, f32, bool) {
        let bound = |name: &str| self.inner[name].as_f64().map(|bound| bound as f32);
        let excluded = bound("exclusiveMinimum");
        let least = excluded.or(bound("minimum")).unwrap_or(f32::NEG_INFINITY);
        (least, bound("maximum").unwrap_or(f32::INFINITY), excluded.is_some())
    }

    /// The value of a key that is left out, in words; `None` where that has no short name.
    pub fn default(self) -> Option<String> {
        match self.outer.get("default")? {
            Value::Null | Value::Object(_) => None,
            Value::Array(items) if items.iter().any(|item| !item.is_number()) => None,
            default => Some(default.to_string()),
        }
    }

    /// The valid values, in words.
    pub fn expected(self) -> String {
        let numbers = |noun: &str| match self.range() {
            (f32::NEG_INFINITY, f32::INFINITY, _) => format!("a finite {noun}"),
            (least, f32::INFINITY, true) => format!("a finite {noun} above {least}"),
            (least, f32::INFINITY, false) => format!("a finite {noun} of at least {least}"),
            (least, most, true) => format!("a {noun} above {least}, {most} at most"),
            (least, most, false) => format!("a {noun} from {least} to {most}"),
        };
        match self.kind() {
            Kind::Table => format!("a table of the keys {}", self.keys().join(", ")),
            Kind::List { least, most } if least == most => {
                let colors = if self.is_color() { ", or a colour such as \"white\" or \"#fff\"" } else { "" };
                format!("a list of {least} items, each {}{colors}", self.item().expected())
            }
            Kind::List { most: usize::MAX, .. } => format!("a list, each item {}", self.item().expected()),
            Kind::List { most, .. } => format!("a list of at most {most} items, each {}", self.item().expected()),
            Kind::Choice(choices) => format!("one of {}", choices.join(", ")),
            Kind::Number => numbers("number"),
            Kind::WholeNumber => numbers("whole number"),
            Kind::Switch => "true or false".to_owned(),
            Kind::Text => "a text in quotes".to_owned(),
        }
    }
}

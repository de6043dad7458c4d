//! A scene as a tree of values, and values as texts.

use toml::{Table, Value};
use vitrum::scene::{Bounds, Control, Field, Scene};

/// The scene as a table; empty where the name of a file is not valid Unicode.
pub fn table(scene: &Scene) -> Table {
    Table::try_from(scene).unwrap_or_default()
}

/// A number as TOML. The scene's are f32: 0.3 is not 0.30000001192092896.
pub fn float(number: f32) -> String {
    format!("{number:?}")
}

/// A list of numbers as TOML.
pub fn floats(numbers: &[f32]) -> String {
    format!("[{}]", numbers.iter().copied().map(float).collect::<Vec<_>>().join(", "))
}

/// A text as TOML, in quotes.
pub fn quoted(text: &str) -> String {
    Value::String(text.to_owned()).to_string()
}

/// The number in a value.
pub fn number(value: &Value) -> Option<f32> {
    value.as_float().map(|number| number as f32).or(value.as_integer().map(|whole| whole as f32))
}

/// The numbers in a list.
pub fn numbers(value: &Value) -> Vec<f32> {
    value.as_array().into_iter().flatten().filter_map(number).collect()
}

/// Whether two values are the same to a scene, whose numbers are f32.
pub fn are_equal(one: &Value, other: &Value) -> bool {
    match (one, other) {
        (Value::Array(items), Value::Array(others)) => {
            items.len() == others.len() && items.iter().zip(others).all(|(item, other)| are_equal(item, other))
        }
        _ => number(one).zip(number(other)).map_or(one == other, |(one, other)| one == other),
    }
}

/// Whether a key has a value that is not its default.
pub fn differs(field: &Field, value: Option<&Value>) -> bool {
    let default = field.default.as_ref().and_then(|text| text.parse::<Value>().ok());
    match (value, default) {
        (Some(value), Some(default)) => !are_equal(value, &default),
        (Some(_), None) => field.is_optional,
        (None, _) => false,
    }
}

/// The setting that gives a key its default; `None` where it has none.
pub fn reset(field: &Field, path: &str) -> Option<String> {
    match &field.default {
        Some(default) => Some(format!("{path}={default}")),
        None if field.is_optional => Some(format!("{path}=none")),
        None => None,
    }
}

/// A value to begin with, for a key that is given for the first time.
pub fn first_value(field: &Field) -> String {
    match &field.control {
        Control::Section(fields) | Control::Sections { item: fields, .. } => first_table(fields),
        Control::Number(bounds) => first_number(*bounds),
        Control::Numbers { each, count } => {
            let mut numbers = vec![first_number(*each); count.unwrap_or(0)];
            // A direction must have a length.
            if let Some(last) = numbers.last_mut().filter(|last| *last == "0.0") {
                "1.0".clone_into(last);
            }
            format!("[{}]", numbers.join(", "))
        }
        Control::Color(_) => "[1.0, 1.0, 1.0]".to_owned(),
        Control::Switch => "true".to_owned(),
        Control::Choice(choices) => choices.first().map_or_else(String::new, |(name, _)| quoted(name)),
        Control::Text => quoted(""),
    }
}

/// A table with the keys that have no default.
pub fn first_table(fields: &[Field]) -> String {
    let required = fields.iter().filter(|field| field.is_required);
    let members: Vec<String> = required.map(|field| format!("{} = {}", field.name, first_value(field))).collect();
    format!("{{ {} }}", members.join(", "))
}

fn first_number(bounds: Bounds) -> String {
    let Bounds { least, most, above_least, whole } = bounds;
    let number = if above_least && least >= 0.0 { least + 1.0 } else { 0.0 };
    let number = number.max(least).min(most);
    if whole { (number as i64).to_string() } else { float(number) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum::scene::{field, form};

    #[test]
    fn every_key_has_a_first_value_that_its_own_range_allows() {
        fn check(fields: &[Field], path: &str, around: &Scene) {
            for field in fields {
                let path = if path.is_empty() { field.name.clone() } else { format!("{path}.{}", field.name) };
                let mut scene = around.clone();
                let mut set = |setting: String| {
                    scene.set(&setting).unwrap_or_else(|error| panic!("{setting}: {error}"));
                    scene.clone()
                };
                let first = first_value(field);
                match &field.control {
                    Control::Section(inner) => check(inner, &path, &set(format!("{path}={first}"))),
                    Control::Sections { item, .. } => {
                        check(item, &format!("{path}.0"), &set(format!("{path}=[{first}]")));
                    }
                    _ => drop(set(format!("{path}={first}"))),
                }
                if let Some(setting) = reset(field, &path) {
                    set(setting);
                }
            }
        }
        check(form(), "", &Scene::default());
    }

    #[test]
    fn defaults_do_not_differ() {
        let table = table(&Scene::default());
        for (name, section) in &table {
            let Some(Control::Section(fields)) = field(name).map(|field| &field.control) else { continue };
            for field in fields.iter().filter(|field| !matches!(field.control, Control::Sections { .. })) {
                assert!(!differs(field, section.get(&field.name)), "{name}.{}", field.name);
            }
        }
        let azimuth = field("light.0.azimuth").expect("a key");
        assert!(differs(azimuth, Some(&Value::Float(3.0))));
    }
}

//! Writing scenes as TOML.

use super::Scene;
use super::error::{Origin, SceneError};
use std::fmt::Write;
use toml::{Table, Value};

impl Scene {
    /// The scene as the text of a scene file without comments, with every key that has a value, in the order of `docs/scene.md`.
    ///
    /// [`Scene::from_toml`] gives an equal scene back. Sections are tables, and lists of tables a section for each; lists in
    /// sections stand with an item a line.
    ///
    /// # Errors
    ///
    /// Where the name of a file is not valid Unicode.
    pub fn to_toml(&self) -> Result<String, SceneError> {
        let table = self.to_table().map_err(|fault| fault.from(Origin::Memory))?;
        let mut text = String::new();
        let (values, sections): (Vec<_>, Vec<_>) = table.iter().partition(|(_, value)| tables(value).is_empty());
        // Plain values come first: what follows a section's head would belong to the section.
        for (key, value) in values {
            push_line(&mut text, key, value);
        }
        for (key, section) in sections {
            for table in tables(section) {
                let separator = if text.is_empty() { "" } else { "\n" };
                let head = if section.is_array() { format!("[[{key}]]") } else { format!("[{key}]") };
                // Writing to a String cannot fail.
                let _ = writeln!(text, "{separator}{head}");
                for (key, value) in table {
                    push_line(&mut text, key, value);
                }
            }
        }
        Ok(text)
    }
}

/// The tables that a value of the scene stands for as sections: itself, or the items of a list.
pub(super) fn tables(value: &Value) -> Vec<&Table> {
    match value {
        Value::Array(items) => items.iter().filter_map(Value::as_table).collect(),
        _ => value.as_table().into_iter().collect(),
    }
}

/// Writes a key with its value, and the end of the line.
pub(super) fn push_line(text: &mut String, key: &str, value: &Value) {
    let _ = match value {
        Value::Array(items) if items.iter().any(Value::is_table) => {
            let lines: String = items.iter().map(|item| format!("  {},\n", inline(item))).collect();
            writeln!(text, "{key} = [\n{lines}]")
        }
        _ => writeln!(text, "{key} = {}", inline(value)),
    };
}

/// The value on one line. Nearly all of the scene's floats are f32: written as such, 0.3 is not 0.30000001192092896.
pub(super) fn inline(value: &Value) -> String {
    match value {
        Value::Float(number) if f64::from(*number as f32) == *number => format!("{:?}", *number as f32),
        Value::Float(number) => format!("{number:?}"),
        Value::Array(items) => format!("[{}]", items.iter().map(inline).collect::<Vec<_>>().join(", ")),
        Value::Table(table) => {
            let members = table.iter().map(|(key, value)| format!("{key} = {}", inline(value)));
            format!("{{ {} }}", members.collect::<Vec<_>>().join(", "))
        }
        other => other.to_string(),
    }
}

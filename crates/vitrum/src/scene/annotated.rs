//! Writing scenes for people: what differs from the defaults, and what each key means.

use super::error::{Origin, SceneError};
use super::schema::Shape;
use super::write::{push_line, tables};
use super::{KeyDescription, Scene, describe_keys};
use toml::{Table, Value};

/// Keys that a scene to start from shows even where they have their defaults: where one looks from, and how large the picture is.
const START: [&str; 5] = ["method", "camera.azimuth", "camera.elevation", "film.width", "film.height"];

const HEAD: &str = "# A scene of Vitrum. Keys that are left out have their defaults: `vitrum keys` describes them, `vitrum scene --all`\n\
                    # writes all of them.\n\n";

impl Scene {
    /// The scene as the text of a scene file with comments: the keys that differ from their defaults, and those that are most often
    /// changed; with `every_key` all that have a value.
    ///
    /// [`Scene::from_toml`] gives an equal scene back.
    ///
    /// # Errors
    ///
    /// Where the name of a file is not valid Unicode.
    pub fn to_annotated_toml(&self, every_key: bool) -> Result<String, SceneError> {
        let table = self.to_table().map_err(|fault| fault.from(Origin::Memory))?;
        let writer = Writer { keys: describe_keys(), every_key };
        let mut text = if every_key { String::new() } else { HEAD.to_owned() };
        let (values, sections): (Vec<_>, Vec<_>) = table.iter().partition(|(_, value)| tables(value).is_empty());
        // Plain values come first: what follows a section's head would belong to the section.
        for (key, value) in values {
            if let Some(shape) = Shape::scene().child(key) {
                writer.push(&mut text, shape, "", key, value);
            }
        }
        for (key, section) in sections {
            if let Some(shape) = Shape::scene().child(key) {
                writer.push_section(&mut text, shape, key, section);
            }
        }
        match Self::from_toml(&text, "scene") {
            Ok(read) if read == *self => Ok(text),
            // A scene that is not valid by itself, or that a comment does not fit: it is written as it is.
            _ => self.to_toml(),
        }
    }
}

struct Writer {
    keys: Vec<KeyDescription>,
    every_key: bool,
}

impl Writer {
    /// Writes a section, or a list of them, where it has something to say.
    fn push_section(&self, text: &mut String, shape: Shape<'_>, key: &str, section: &Value) {
        let is_list = section.is_array();
        if is_list && !self.every_key && shape.has_default(section) {
            return;
        }
        let (inner, path) = if is_list { (shape.item(), format!("{key}.0")) } else { (shape, key.to_owned()) };
        for table in tables(section) {
            let mut lines = String::new();
            self.push_keys(&mut lines, inner, &path, table);
            // That an optional section is there says something by itself.
            if lines.is_empty() && !is_list && !shape.optional() {
                continue;
            }
            let separator = if text.is_empty() || text.ends_with("\n\n") { "" } else { "\n" };
            let head = if is_list { format!("[[{key}]]") } else { format!("[{key}]") };
            *text += &format!("{separator}{head}\n{lines}");
        }
    }

    fn push_keys(&self, text: &mut String, shape: Shape<'_>, path: &str, table: &Table) {
        for (key, value) in table {
            if let Some(child) = shape.child(key) {
                self.push(text, child, path, key, value);
            }
        }
    }

    /// Writes a key below its comment, if it counts.
    fn push(&self, text: &mut String, shape: Shape<'_>, table: &str, key: &str, value: &Value) {
        let path = if table.is_empty() { key.to_owned() } else { format!("{table}.{key}") };
        if !self.every_key && shape.has_default(value) && !START.contains(&path.as_str()) {
            return;
        }
        if let Some(described) = self.keys.iter().find(|described| described.path == path) {
            *text += &comment(described);
        }
        push_line(text, key, value);
    }
}

/// A line that says what a key means: the first sentence of its description, its unit and its range.
fn comment(key: &KeyDescription) -> String {
    let sentence = key.meaning.split_once(". ").map_or(key.meaning.as_str(), |(first, _)| first).trim_end_matches('.');
    let facts: Vec<&str> =
        [&key.unit, &key.range].into_iter().map(String::as_str).filter(|fact| !fact.is_empty()).collect();
    format!("# {sentence} ({})\n", facts.join("; ").replace('`', ""))
}

#[cfg(all(test, feature = "builtin"))]
mod tests {
    use super::*;
    use crate::builtin;

    #[test]
    fn every_built_in_scene_is_read_back_from_either_form() {
        for (name, _) in builtin::names() {
            let scene = builtin::scene(name).expect("listed");
            let [brief, all] = [false, true].map(|every_key| scene.to_annotated_toml(every_key).expect("Unicode"));
            for text in [&brief, &all] {
                assert_eq!(Scene::from_toml(text, name).expect(name), scene, "{name}");
                assert!(text.contains("\n# ") && text.contains("azimuth"), "{name}: there are comments\n{text}");
            }
            assert!(brief.lines().count() < all.lines().count(), "{name}");
        }
    }

    #[test]
    fn keys_with_their_defaults_are_left_out_and_those_that_differ_stay() {
        let mut scene = builtin::scene("ball").expect("listed");
        for setting in ["sweep.sample_distance=0.7", "wall={}", "light.0.intensity=2"] {
            // Whether the settings fit each other is not asked here.
            let _ = scene.set(setting);
        }
        let text = scene.to_annotated_toml(false).expect("Unicode");
        assert!(text.contains("[wall]") || scene.wall.is_none(), "{text}");
        assert!(!text.contains("supersampling"), "{text}");
        assert!(text.contains("film") && text.contains("(pixels; 1 to 16384)"), "{text}");
        let all = scene.to_annotated_toml(true).expect("Unicode");
        assert!(all.contains("supersampling = 1"), "{all}");
    }
}

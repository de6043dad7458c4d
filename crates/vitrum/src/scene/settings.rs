//! The difference of two scenes as settings, which `--set KEY=VALUE` takes.

use super::Scene;
use super::error::{Fault, Origin, SceneError};
use super::schema::{Kind, Shape};
use super::write::inline;
use toml::{Table, Value};

/// More passes than any difference takes: a new kind of a light resets keys, which the second pass sets.
const MOST_PASSES: usize = 4;

impl Scene {
    /// The settings, as [`Scene::set`] takes them, that turn `base` into this scene, in every key.
    ///
    /// # Errors
    ///
    /// Where the name of a file is not valid Unicode, or a value is none that a scene may have.
    pub fn settings_from(&self, base: &Self) -> Result<Vec<String>, SceneError> {
        let in_memory = |fault: Fault| fault.from(Origin::Memory);
        let wanted = self.to_table().map_err(in_memory)?;
        let mut reached = base.clone();
        let mut settings = Vec::new();
        for _ in 0..MOST_PASSES {
            if reached == *self {
                return Ok(settings);
            }
            let mut found = Vec::new();
            differences_of_tables(Shape::scene(), "", &reached.to_table().map_err(in_memory)?, &wanted, &mut found);
            for setting in found {
                reached.set(&setting)?;
                settings.push(setting);
            }
        }
        let problem = "no settings lead to this scene";
        Err(in_memory(Fault::contradiction("", problem, "save the scene, and render its file")))
    }
}

/// Settings for the keys that differ between two tables at `path`.
fn differences_of_tables(shape: Shape<'_>, path: &str, from: &Table, to: &Table, settings: &mut Vec<String>) {
    for key in shape.keys() {
        if let Some(child) = shape.child(key) {
            let path = if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
            differences(child, &path, from.get(key), to.get(key), settings);
        }
    }
}

fn differences(shape: Shape<'_>, path: &str, from: Option<&Value>, to: Option<&Value>, settings: &mut Vec<String>) {
    if from == to {
        return;
    }
    match (from, to) {
        (_, None) => settings.push(format!("{path}={}", left_out(shape))),
        (Some(Value::Table(from)), Some(Value::Table(to))) => differences_of_tables(shape, path, from, to, settings),
        (Some(Value::Array(from)), Some(Value::Array(to)))
            if to.iter().any(Value::is_table) && from.len() <= to.len() =>
        {
            let mut pieces = Vec::new();
            for (index, item) in to.iter().enumerate() {
                differences(shape.item(), &format!("{path}.{index}"), from.get(index), Some(item), &mut pieces);
            }
            let whole = format!("{path}={}", inline(&Value::Array(to.clone())));
            let shorter = pieces.iter().map(String::len).sum::<usize>() <= whole.len();
            settings.extend(if shorter { pieces } else { vec![whole] });
        }
        (_, Some(to)) => settings.push(format!("{path}={}", text(shape, to))),
    }
}

/// The value that a key has where a scene's file does not name it.
fn left_out(shape: Shape<'_>) -> String {
    match shape.kind() {
        _ if shape.optional() => "none".to_owned(),
        Kind::List { .. } => "[]".to_owned(),
        _ => shape.default().unwrap_or_default(),
    }
}

/// The value behind the `=` of a setting: texts that need no quotes have none.
fn text(shape: Shape<'_>, value: &Value) -> String {
    match value {
        Value::String(text) if matches!(shape.kind(), Kind::Text | Kind::Choice(_)) && is_plain(text) => text.clone(),
        value => inline(value),
    }
}

fn is_plain(text: &str) -> bool {
    !text.is_empty()
        && text != "none"
        && text.trim() == text
        && !text.starts_with(['"', '\''])
        && !text.contains(char::is_control)
}

#[cfg(all(test, feature = "builtin"))]
mod tests {
    use super::*;
    use crate::builtin;
    use crate::scene::{Annotation, AnnotationKind, Clip, ColorPoint, Isosurface, Light, LightKind, OpacityPoint};

    fn replayed(base: &Scene, wanted: &Scene) -> Vec<String> {
        let settings = wanted.settings_from(base).expect("it can be written");
        let mut reached = base.clone();
        for setting in &settings {
            reached.set(setting).expect(setting);
        }
        assert_eq!(reached, *wanted, "{settings:?}");
        settings
    }

    #[test]
    fn settings_lead_from_every_built_in_scene_to_every_other() {
        let scenes: Vec<Scene> = builtin::names().iter().filter_map(|(name, _)| builtin::scene(name)).collect();
        for pair in scenes.windows(2) {
            replayed(&pair[0], &pair[1]);
            replayed(&pair[1], &pair[0]);
            replayed(&pair[0], &Scene::default());
        }
        assert_eq!(replayed(&scenes[0], &scenes[0]), [""; 0]);
    }

    #[test]
    fn one_key_that_differs_is_one_short_setting() {
        let mut scene = builtin::scene("ball").expect("listed");
        let base = scene.clone();
        scene.camera.azimuth = 0.3;
        assert_eq!(replayed(&base, &scene), ["camera.azimuth=0.3"]);
        scene = base.clone();
        scene.light.push(Light { azimuth: 12.5, ..Light::default() });
        let added = replayed(&base, &scene);
        assert!(added.len() == 1 && added[0].starts_with("light.1={"), "{added:?}");
        assert!(replayed(&scene, &base)[0].starts_with("light=["), "a list that gets shorter is written as a whole");
    }

    #[test]
    fn lists_texts_and_absent_keys_come_back() {
        let mut base = builtin::scene("ball").expect("listed");
        base.ground = Some(crate::scene::Ground::default());
        base.light[0].azimuth = 77.0;
        let mut scene = base.clone();
        scene.ground = None;
        scene.light[0] = Light { position: Some([5.0, 0.1, -7.0]), ..Light::of_kind(LightKind::Point) };
        scene.transfer.opacity =
            [0.1, 0.25, 1e-7].map(|opacity| OpacityPoint { value: 100.0 * opacity, opacity }).to_vec();
        scene.transfer.filter = vec![ColorPoint { value: -3.0, color: [0.1, 0.2, 0.3] }];
        scene.isosurface = vec![Isosurface::new(40.0), Isosurface { opacity: 0.3, ..Isosurface::new(1.5) }];
        scene.clip = vec![Clip::default()];
        for words in ["none", "two\nlines, \"quoted\" and 'so'", " edges ", "ä = é", ""] {
            let text = Some(words.to_owned());
            scene.annotation.push(Annotation { kind: AnnotationKind::Caption, text, ..Annotation::default() });
        }
        scene.volume.seconds = Some(0.123_456_789_012);
        replayed(&base, &scene);
        replayed(&scene, &base);
        scene.annotation[0].text = None;
        replayed(&base, &scene);
    }
}

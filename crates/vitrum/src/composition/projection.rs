//! Keys that a projection leaves out.

use crate::scene::{BlendMode, Scene};

/// The keys of all that a projection does without.
const UNSEEN: [&str; 6] = ["light", "ground", "wall", "shadow", "sweep.light", "environment.lights"];

/// A statement about what `scene` was asked for, by a scene file or by `settings`, and a projection does not show; none of a preset's keys.
pub(super) fn left_out(scene: &Scene, of_file: Option<&Scene>, settings: &[String]) -> Option<String> {
    if scene.shading.blend_mode == BlendMode::Composite {
        return None;
    }
    let usual = Scene::default();
    let in_file = of_file.map(|scene| {
        let light = !scene.light.is_empty() && scene.light != usual.light;
        [("light", light), ("ground", scene.ground.is_some()), ("wall", scene.wall.is_some())]
    });
    let in_file = in_file.into_iter().flatten().filter(|(_, given)| *given).map(|(key, _)| key);
    let surfaces = (!scene.isosurface.is_empty()).then_some("isosurface");
    let set = settings.iter().filter_map(|setting| {
        let key = setting.split('=').next()?.trim();
        UNSEEN
            .iter()
            .any(|unseen| key.strip_prefix(unseen).is_some_and(|rest| rest.is_empty() || rest.starts_with('.')))
            .then_some(key)
    });
    let mut keys: Vec<String> = in_file.chain(surfaces).chain(set).map(|key| format!("`{key}`")).collect();
    keys.dedup();
    let are = if keys.len() == 1 { "is" } else { "are" };
    let told = || {
        format!(
            "a projection (`shading.blend_mode`) has no light, receivers and isosurfaces: {} {are} left out",
            keys.join(", ")
        )
    };
    (!keys.is_empty()).then(told)
}

//! The look of a scene: what presets and the editor change, and undo brings back.

use vitrum::scene::Scene;

/// A scene with the look of `look`, and the subject, the view, the cuts and the film of `scene`.
pub fn with_look_of(look: &Scene, scene: &Scene) -> Scene {
    Scene {
        method: scene.method,
        volume: scene.volume.clone(),
        ior_volume: scene.ior_volume.clone(),
        mesh: scene.mesh.clone(),
        camera: scene.camera.clone(),
        clip: scene.clip.clone(),
        crop: scene.crop.clone(),
        film: scene.film.clone(),
        annotation: scene.annotation.clone(),
        ..look.clone()
    }
}

/// The look of a scene by itself, for comparison.
pub fn look_of(scene: &Scene) -> Scene {
    with_look_of(scene, &Scene::default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_look_leaves_the_view_alone() {
        let mut scene = Scene::default();
        scene.camera.azimuth = 33.0;
        let mut look = Scene::default();
        look.light[0].azimuth = 5.0;
        look.camera.azimuth = 1.0;
        let made = with_look_of(&look, &scene);
        assert_eq!((made.camera.azimuth, made.light[0].azimuth), (33.0, 5.0));
        assert_eq!(look_of(&scene), look_of(&Scene::default()));
        assert_ne!(look_of(&scene), look_of(&look));
    }
}

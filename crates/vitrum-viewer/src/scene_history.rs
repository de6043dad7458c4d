//! Undo and redo of scenes.

use crate::history::History;
use vitrum::scene::Scene;

/// The states of a scene, before and after the present one. The size of the picture, which a window changes by itself, is none of it.
#[derive(Debug, Clone)]
pub struct SceneHistory(History<Scene>);

impl SceneHistory {
    /// A history that begins with `scene`.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self(History::new(scene.clone()))
    }

    /// Takes note of the scene as it is now, once a change is finished: a drag is one change.
    pub fn note(&mut self, scene: &Scene) {
        let state = sized(scene, self.0.present());
        self.0.record(state, None);
    }

    /// Whether there is something to undo.
    #[must_use]
    pub fn can_undo(&self) -> bool {
        self.0.can_undo()
    }

    /// Whether there is something to do again.
    #[must_use]
    pub fn can_redo(&self) -> bool {
        self.0.can_redo()
    }

    /// Puts the scene back into the state before the present one.
    pub fn undo(&mut self, scene: &mut Scene) {
        if let Some(earlier) = self.0.undo() {
            *scene = sized(earlier, scene);
        }
    }

    /// Puts the scene into the state that was undone last.
    pub fn redo(&mut self, scene: &mut Scene) {
        if let Some(later) = self.0.redo() {
            *scene = sized(later, scene);
        }
    }
}

/// A scene with the picture's size of another one.
fn sized(scene: &Scene, like: &Scene) -> Scene {
    let mut scene = scene.clone();
    (scene.film.width, scene.film.height) = (like.film.width, like.film.height);
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_are_undone_and_done_again() {
        let mut scene = Scene::default();
        let mut history = SceneHistory::new(&scene);
        history.note(&scene);
        assert!(!history.can_undo());
        for azimuth in [1.0, 2.0] {
            scene.camera.azimuth = azimuth;
            history.note(&scene);
        }
        history.undo(&mut scene);
        assert_eq!(scene.camera.azimuth, 1.0);
        history.undo(&mut scene);
        assert_eq!(scene, Scene::default());
        history.redo(&mut scene);
        assert_eq!((scene.camera.azimuth, history.can_redo()), (1.0, true));
        scene.camera.azimuth = 7.0;
        history.note(&scene);
        assert!(!history.can_redo());
    }

    #[test]
    fn the_windows_size_is_no_change() {
        let mut scene = Scene::default();
        let mut history = SceneHistory::new(&scene);
        scene.film.width = 999;
        history.note(&scene);
        assert!(!history.can_undo());
        scene.camera.zoom = 2.0;
        history.note(&scene);
        history.undo(&mut scene);
        assert_eq!((scene.film.width, scene.camera.zoom), (999, 1.0));
    }
}

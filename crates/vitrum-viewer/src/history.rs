//! Undo and redo: a stack of whole scenes.

use vitrum::scene::Scene;

/// The most states that are kept; a scene takes a few kilobytes.
const MOST: usize = 200;

/// The states of a scene, before and after the present one.
#[derive(Debug, Clone)]
pub struct History {
    before: Vec<Scene>,
    after: Vec<Scene>,
    present: Scene,
}

impl History {
    /// A history that begins with `scene`.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self { before: Vec::new(), after: Vec::new(), present: scene.clone() }
    }

    /// Takes note of the scene as it is now, once a change is finished: a drag is one change. The size of the picture, which a window changes by itself, is
    /// none.
    pub fn note(&mut self, scene: &Scene) {
        let (width, height) = (scene.film.width, scene.film.height);
        (self.present.film.width, self.present.film.height) = (width, height);
        if *scene == self.present {
            return;
        }
        self.before.push(std::mem::replace(&mut self.present, scene.clone()));
        self.after.clear();
        if self.before.len() > MOST {
            self.before.remove(0);
        }
    }

    /// Whether there is something to undo.
    #[must_use]
    pub fn can_undo(&self) -> bool {
        !self.before.is_empty()
    }

    /// Whether there is something to do again.
    #[must_use]
    pub fn can_redo(&self) -> bool {
        !self.after.is_empty()
    }

    /// Puts the scene back into the state before the present one.
    pub fn undo(&mut self, scene: &mut Scene) {
        if let Some(earlier) = self.before.pop() {
            self.after.push(std::mem::replace(&mut self.present, earlier));
            self.show(scene);
        }
    }

    /// Puts the scene into the state that was undone last.
    pub fn redo(&mut self, scene: &mut Scene) {
        if let Some(later) = self.after.pop() {
            self.before.push(std::mem::replace(&mut self.present, later));
            self.show(scene);
        }
    }

    fn show(&mut self, scene: &mut Scene) {
        (self.present.film.width, self.present.film.height) = (scene.film.width, scene.film.height);
        *scene = self.present.clone();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_are_undone_and_done_again() {
        let mut scene = Scene::default();
        let mut history = History::new(&scene);
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
        let mut history = History::new(&scene);
        scene.film.width = 999;
        history.note(&scene);
        assert!(!history.can_undo());
        scene.camera.zoom = 2.0;
        history.note(&scene);
        history.undo(&mut scene);
        assert_eq!((scene.film.width, scene.camera.zoom), (999, 1.0));
    }
}

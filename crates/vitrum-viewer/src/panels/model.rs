//! The model of the panels: settings that are taken, and settings that wait.

use vitrum::scene::{Scene, SceneError};

/// The panels' state.
///
/// A setting that does not fit the rest of the scene, such as a light's kind whose position is missing, waits until another one makes it fit.
#[derive(Debug, Clone, Default)]
pub struct Panels {
    /// The words that keys have to have in their names or meanings.
    pub filter: String,
    /// Settings that wait, in the order in which they were made.
    pending: Vec<String>,
    /// The scene with those settings, where there are some.
    draft: Option<Scene>,
    /// The key that is refused, and why.
    refused: Option<(String, String)>,
}

impl Panels {
    /// The scene with the settings that wait.
    #[must_use]
    pub fn shown<'a>(&'a self, scene: &'a Scene) -> &'a Scene {
        self.draft.as_ref().unwrap_or(scene)
    }

    /// The key that is refused, and why; the key is empty where it is the scene as a whole.
    #[must_use]
    pub fn refusal(&self) -> Option<(&str, &str)> {
        self.refused.as_ref().map(|(key, text)| (key.as_str(), text.as_str()))
    }

    /// Why the key at `path` is refused, if it is that one.
    #[must_use]
    pub fn refusal_of(&self, path: &str) -> Option<&str> {
        self.refusal().filter(|(key, _)| *key == path).map(|(_, text)| text)
    }

    /// Forgets the settings that wait.
    pub fn take_back(&mut self) {
        self.pending.clear();
        self.draft = None;
        self.refused = None;
    }

    /// Takes a setting `KEY=VALUE`; whether the scene has it now. If it is none, nothing changes; if it does not fit the scene, it waits.
    pub fn set(&mut self, scene: &mut Scene, setting: &str) -> bool {
        let mut draft = scene.clone();
        for waiting in &self.pending {
            // What cannot be set any more, such as a key of an item that is gone, is left out.
            let _ = draft.set(waiting);
        }
        let key = setting.split('=').next().unwrap_or_default().trim().to_owned();
        if let Err(error) = draft.set(setting) {
            self.refuse(&key, &error);
            return false;
        }
        match check(&draft, scene) {
            Ok(()) => {
                *scene = draft;
                self.take_back();
                true
            }
            Err(error) => {
                let same = format!("{key}=");
                self.pending.retain(|waiting| !waiting.starts_with(&same));
                self.pending.push(setting.to_owned());
                self.draft = Some(draft);
                self.refuse(&key, &error);
                false
            }
        }
    }

    fn refuse(&mut self, key: &str, error: &SceneError) {
        let key = if error.key.is_empty() { key } else { &error.key };
        self.refused = Some((key.to_owned(), format!("{}; {}", error.problem, error.help())));
    }
}

/// Checks a draft as much as the scene from before passes: data in memory need not be named.
fn check(draft: &Scene, scene: &Scene) -> Result<(), SceneError> {
    draft.check_settings()?;
    if scene.check_sources().is_ok() { draft.check_sources() } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum::scene::LightKind;

    #[test]
    fn settings_that_need_each_other_wait_for_each_other() {
        let mut scene = Scene::default();
        let mut panels = Panels::default();
        assert!(!panels.set(&mut scene, "light.0.kind=point"));
        assert_eq!(scene, Scene::default());
        assert_eq!(panels.shown(&scene).light[0].kind, LightKind::Point);
        assert!(panels.refusal().is_some_and(|(key, _)| key.starts_with("light.0")), "{panels:?}");
        // The camera moves meanwhile.
        scene.camera.azimuth = 12.0;
        assert!(panels.set(&mut scene, "light.0.position=[9, 9, 9]"), "{panels:?}");
        assert_eq!((scene.light[0].kind, scene.camera.azimuth), (LightKind::Point, 12.0));
        assert_eq!(panels.refusal(), None);
    }

    #[test]
    fn what_is_no_setting_changes_nothing_and_is_told() {
        let mut scene = Scene::default();
        let mut panels = Panels::default();
        for setting in
            ["film.width=0", "film.width=none", "light.7.azimuth=3", "nonsense", "camera.azimuth=[", "method=magic"]
        {
            assert!(!panels.set(&mut scene, setting), "{setting}");
            assert!(panels.refusal().is_some_and(|(_, text)| !text.is_empty()), "{setting}");
        }
        assert_eq!(scene, Scene::default());
        panels.take_back();
        assert_eq!(panels.refusal(), None);
        assert!(panels.set(&mut scene, "film.width=77") && scene.film.width == 77);
    }
}

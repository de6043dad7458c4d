//! The rules that tie several keys of a scene together.

mod figure;
mod medium;
mod settings;
mod sources;

use super::Scene;
use super::check::check_table;
use super::error::{Fault, Origin, SceneError};
use super::schema::Shape;

impl Scene {
    /// Checks the whole scene, as a scene file is: the settings and the sources.
    ///
    /// Scenes read by [`Scene::from_toml`] have passed; one that was changed since may have lost it.
    ///
    /// # Errors
    ///
    /// Those of [`Scene::check_settings`] and of [`Scene::check_sources`].
    pub fn validate(&self) -> Result<(), SceneError> {
        self.check_settings()?;
        self.check_sources()
    }

    /// Checks the range of every value, and that the values on which a picture depends do not contradict each other. Files and built-in
    /// data need not be named: a scene that passes can render data in memory.
    ///
    /// # Errors
    ///
    /// Where a value is out of its documented range or not finite; where the method cannot do what a key asks for; where a direction has no
    /// length, the eye stands on its target, the points of a transfer function are not sorted, or a film that is rendered in one part has more than
    /// [`Film::MOST_RAYS`](super::Film::MOST_RAYS) rays.
    pub fn check_settings(&self) -> Result<(), SceneError> {
        let check = || {
            check_table(Shape::scene(), &self.to_table()?, &mut Vec::new())?;
            settings::check(self)
        };
        check().map_err(|fault: Fault| fault.from(Origin::Memory))
    }

    /// Checks that the scene names the files or built-in data of its picture.
    ///
    /// # Errors
    ///
    /// Where a volume or mesh has not exactly one of `file` and `builtin`, or a key that only files have; where the method does not show what
    /// is named; where an environment map has no file.
    pub fn check_sources(&self) -> Result<(), SceneError> {
        sources::check(self).map_err(|fault| fault.from(Origin::Memory))
    }

    /// Checks that materials, transfer functions and clipping planes are ones that the scene's method renders in a picture of a mesh.
    ///
    /// # Errors
    ///
    /// Where a material is opaque or a mirror, a clear one has a colour, or there are transfer functions or clipping planes, and the method cannot
    /// render it ([`MethodName::capabilities`](super::MethodName::capabilities)).
    pub(crate) fn check_for_mesh(&self) -> Result<(), SceneError> {
        settings::check_mesh(self).map_err(|fault| fault.from(Origin::Memory))
    }

    /// The part of [`Scene::validate`] that looks at several keys at once.
    pub(super) fn check_consistency(&self) -> Result<(), Fault> {
        sources::check(self)?;
        settings::check(self)
    }
}

/// Fails at the first key that is given and must not be.
fn refuse(given: &[(&str, bool)], problem: &str, advice: &str) -> Result<(), Fault> {
    match given.iter().find(|(_, given)| *given) {
        None => Ok(()),
        Some((name, _)) => Err(Fault::contradiction(name, problem, format!("leave `{name}` out, {advice}"))),
    }
}

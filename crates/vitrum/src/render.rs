//! From a scene to a frame, in one call.

use crate::backend::Backend;
use crate::error::Error;
use crate::film::Frame;
use crate::inputs::Inputs;
use crate::method::sweep;
use crate::request::{Progress, Wanted};
use crate::scene::{Method, Scene};
use crate::session::Session;

/// Whether a frame of a scene can be made of its inputs, as far as that can be told without a backend and without work.
///
/// # Errors
/// [`Error::SceneFile`] where a key is out of its range, [`Error::Scene`] where what is seen and lit makes no frame, as when the light
/// shines towards the camera.
pub fn check(scene: &Scene, inputs: &Inputs) -> Result<(), Error> {
    scene.validate()?;
    if let Some(mesh) = inputs.mesh.as_ref().filter(|mesh| mesh.surface_area() == 0.0) {
        let (name, count) = (&mesh.name, mesh.triangles.len());
        return Err(Error::Scene(format!(
            "{name}: none of its {count} triangles has an area; give a mesh that has a surface"
        )));
    }
    match scene.method {
        Method::Sweep => sweep::check(scene, inputs),
        Method::Voxels => Ok(()),
    }
}

/// Renders a scene with all outputs. `progress` is called from time to time and cancels the frame by returning `false`.
///
/// # Errors
/// Those of [`check`]; [`Error::Backend`] where the backend lacks the memory or fails, or `progress` cancels.
pub fn render(
    scene: &Scene,
    inputs: &Inputs,
    backend: &mut dyn Backend,
    progress: &mut dyn FnMut(Progress) -> bool,
) -> Result<Frame, Error> {
    render_wanted(scene, inputs, Wanted::default(), backend, progress)
}

/// Renders a scene with the outputs that are wanted. Each is the same as with all.
///
/// # Errors
/// As [`render`].
pub fn render_wanted(
    scene: &Scene,
    inputs: &Inputs,
    wanted: Wanted,
    backend: &mut dyn Backend,
    progress: &mut dyn FnMut(Progress) -> bool,
) -> Result<Frame, Error> {
    scene.validate()?;
    Session::new(inputs, backend)?.render(scene, wanted, progress)
}

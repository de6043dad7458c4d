//! Frames of one volume after another: what does not change stays on the backend.

use crate::backend::Backend;
use crate::frame::Frame;
use crate::inputs::Inputs;
use crate::method::sweep::{Sweep, Uploaded};
use crate::render::{Error, Progress, Wanted, finish};
use crate::scene::Scene;
use std::time::Instant;

/// Volumes on a backend, to be rendered again and again while camera, light and transfer functions change.
pub struct Session<'a> {
    inputs: &'a Inputs,
    backend: &'a mut dyn Backend,
    uploaded: Uploaded,
    /// The time that the upload took, until the first frame has told it.
    upload_ms: f64,
}

impl<'a> Session<'a> {
    /// Uploads the volumes.
    ///
    /// # Errors
    /// If a volume is too large for the sweep or for the backend.
    pub fn new(inputs: &'a Inputs, backend: &'a mut dyn Backend) -> Result<Self, Error> {
        let started = Instant::now();
        let uploaded = Uploaded::new(inputs, backend)?;
        Ok(Self { inputs, backend, uploaded, upload_ms: started.elapsed().as_secs_f64() * 1e3 })
    }

    /// Renders a scene of these volumes, with the outputs that are wanted. The scene's own `volume` and `ior_volume` are not
    /// looked at. The first frame's `upload_ms` includes the volumes'.
    ///
    /// # Errors
    /// If the scene is not valid, or the backend fails; the session can go on with another scene.
    pub fn render(
        &mut self,
        scene: &Scene,
        wanted: Wanted,
        progress: &mut dyn FnMut(Progress) -> bool,
    ) -> Result<Frame, Error> {
        scene.validate()?;
        let started = Instant::now();
        let mut sweep = Sweep::prepare_uploaded(scene, self.inputs, self.uploaded, self.backend)?;
        if !wanted.light {
            sweep.end_light_with_rays();
        }
        let upload_ms = started.elapsed().as_secs_f64() * 1e3 + std::mem::take(&mut self.upload_ms);
        let result = finish(scene, &sweep, wanted, self.backend, progress, upload_ms);
        sweep.free(self.backend);
        result
    }
}

impl Drop for Session<'_> {
    fn drop(&mut self) {
        self.uploaded.free(self.backend);
    }
}

//! Frames of one volume after another: what does not change stays on the backend.

use crate::backend::Backend;
use crate::blend::Blend;
use crate::frame::Frame;
use crate::inputs::Inputs;
use crate::method::sweep::{Sweep, Uploaded};
use crate::render::{Error, Progress, Wanted, develop, expose};
use crate::scene::Scene;
use crate::spectrum::exposures;
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
        let exposures = exposures(scene);
        let mut upload_ms = std::mem::take(&mut self.upload_ms);
        let mut blend = Blend::default();
        let mut frame = None;
        let count = exposures.len() as u32;
        for (index, (band, seen)) in (0..).zip(&exposures) {
            let started = Instant::now();
            let mut sweep = Sweep::prepare_uploaded(seen, self.inputs, self.uploaded, self.backend)?;
            if !wanted.light {
                sweep.end_light_with_rays();
            }
            upload_ms += started.elapsed().as_secs_f64() * 1e3;
            let planes = sweep.planes.count;
            let mut tell = |done: u32| progress(Progress { done: index * planes + done, total: count * planes });
            let result = expose(&sweep, wanted, self.backend, &mut tell).map(|exposure| blend.add(*band, exposure));
            if result.is_ok() && index + 1 == count {
                frame = blend.exposure.take().map(|whole| develop(scene, &sweep, &whole, self.backend, upload_ms));
            }
            sweep.free(self.backend);
            result?;
        }
        Ok(frame.expect("a scene has at least one exposure"))
    }
}

impl Drop for Session<'_> {
    fn drop(&mut self) {
        self.uploaded.free(self.backend);
    }
}

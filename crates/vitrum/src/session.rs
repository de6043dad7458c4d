//! Frames of one volume after another: what does not change stays on the backend.

use crate::backend::{Backend, BackendError};
use crate::error::Error;
use crate::film::Frame;
use crate::inputs::Inputs;
use crate::method::mesh_volumes::MeshVolumes;
use crate::method::sweep::blend::Blend;
use crate::method::sweep::film::{develop, expose};
use crate::method::sweep::spectrum::exposures;
use crate::method::{sweep, voxels};
use crate::request::{Progress, Wanted};
use crate::scene::{Method, Scene};
use std::time::Instant;

/// Volumes on a backend, to be rendered again and again while camera, light and transfer functions change.
pub struct Session<'a> {
    inputs: &'a Inputs,
    backend: Held<'a>,
    /// What to go on with when the device fails, until it has been called.
    fallback: Option<Box<Fallback<'a>>>,
    uploaded: Uploaded,
    /// The time that the upload took, until the first frame has told it.
    upload_ms: f64,
}

/// Opens another backend after a failure of the first one's device.
pub type Fallback<'a> = dyn FnMut(&BackendError) -> Result<Box<dyn Backend>, BackendError> + 'a;

/// What stays on the backend from frame to frame.
enum Uploaded {
    Volumes(sweep::Uploaded),
    /// A mesh, once a scene has said what becomes of it.
    Mesh(Option<Box<voxels::Uploaded>>),
    /// A mesh as volumes.
    MeshVolumes(Box<MeshVolumes>, sweep::Uploaded),
}

/// A backend, the caller's or the session's own.
enum Held<'a> {
    Borrowed(&'a mut dyn Backend),
    Owned(Box<dyn Backend>),
}

impl Held<'_> {
    fn get(&mut self) -> &mut dyn Backend {
        match self {
            Self::Borrowed(backend) => &mut **backend,
            Self::Owned(backend) => backend.as_mut(),
        }
    }
}

impl<'a> Session<'a> {
    /// Uploads the volumes.
    ///
    /// # Errors
    /// If a volume is too large for the sweep or for the backend.
    pub fn new(inputs: &'a Inputs, backend: &'a mut dyn Backend) -> Result<Self, Error> {
        Self::upload(inputs, Held::Borrowed(backend))
    }

    /// As [`Self::new`], with a backend of the session's own.
    ///
    /// When its device fails or has too little memory, now or in a later frame, and there is a `fallback`, the session goes on
    /// with what that opens: volumes are uploaded again, and the frame begins anew. `fallback` is called once at most, with the
    /// reason; it is the place to tell the user.
    ///
    /// # Errors
    /// Those of [`Self::new`], of `fallback`, and of the backend that it opened.
    pub fn owning(
        inputs: &'a Inputs,
        backend: Box<dyn Backend>,
        fallback: Option<Box<Fallback<'a>>>,
    ) -> Result<Self, Error> {
        match (Self::upload(inputs, Held::Owned(backend)), fallback) {
            (Err(Error::Backend(failure)), Some(mut fallback)) if failure.is_of_device() => {
                Self::upload(inputs, Held::Owned(fallback(&failure)?))
            }
            (Ok(mut session), fallback) => {
                session.fallback = fallback;
                Ok(session)
            }
            (Err(error), _) => Err(error),
        }
    }

    fn upload(inputs: &'a Inputs, mut backend: Held<'a>) -> Result<Self, Error> {
        let started = Instant::now();
        let uploaded = match inputs.mesh {
            None => Uploaded::Volumes(sweep::Uploaded::new(inputs, backend.get())?),
            Some(_) => Uploaded::Mesh(None),
        };
        let upload_ms = started.elapsed().as_secs_f64() * 1e3;
        Ok(Self { inputs, backend, fallback: None, uploaded, upload_ms })
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
        let failure = match self.render_once(scene, wanted, progress) {
            Err(Error::Backend(error)) if error.is_of_device() => error,
            outcome => return outcome,
        };
        let Some(mut fallback) = self.fallback.take() else { return Err(failure.into()) };
        *self = Self::upload(self.inputs, Held::Owned(fallback(&failure)?))?;
        self.render_once(scene, wanted, progress)
    }

    fn render_once(
        &mut self,
        scene: &Scene,
        wanted: Wanted,
        progress: &mut dyn FnMut(Progress) -> bool,
    ) -> Result<Frame, Error> {
        let started = Instant::now();
        self.suit(scene, progress)?;
        let mut upload_ms = std::mem::take(&mut self.upload_ms) + started.elapsed().as_secs_f64() * 1e3;
        let of_mesh;
        let (inputs, volumes, scene) = match &mut self.uploaded {
            Uploaded::Volumes(volumes) => (self.inputs, &*volumes, scene),
            Uploaded::MeshVolumes(shown, volumes) => {
                of_mesh = shown.scene(scene, self.inputs)?;
                (&shown.inputs, &*volumes, &of_mesh)
            }
            Uploaded::Mesh(mesh) => {
                return voxels::film::render(scene, self.inputs, mesh, self.backend.get(), progress);
            }
        };
        let exposures = exposures(scene);
        let mut blend = Blend::default();
        let mut frame = None;
        let count = exposures.len() as u32;
        let backend = self.backend.get();
        for (index, (band, seen)) in (0..).zip(&exposures) {
            let started = Instant::now();
            let sweep = sweep::Sweep::prepare_uploaded(seen, inputs, volumes, wanted, backend)?;
            upload_ms += started.elapsed().as_secs_f64() * 1e3;
            let planes = sweep.planes.count;
            let mut tell = |done: u32| progress(Progress { done: index * planes + done, total: count * planes });
            let result = expose(&sweep, wanted, backend, &mut tell).map(|exposure| blend.add(*band, exposure));
            if result.is_ok() && index + 1 == count {
                frame = blend.exposure.take().map(|whole| develop(scene, &sweep, &whole, backend, upload_ms));
            }
            result?;
        }
        let mut frame = frame.expect("a scene has at least one exposure");
        if let Uploaded::MeshVolumes(shown, _) = &self.uploaded {
            frame.statistics.voxels = Some(shown.inputs.volume.dimensions);
            frame.statistics.open_rows = Some(shown.open_rows);
        }
        Ok(frame)
    }

    /// Makes of a mesh what the scene's method runs through.
    fn suit(&mut self, scene: &Scene, progress: &mut dyn FnMut(Progress) -> bool) -> Result<(), Error> {
        let fits = match (&self.uploaded, scene.method) {
            (Uploaded::Volumes(_), Method::Voxels) => {
                return Err(Error::Scene("the method `voxels` shows a mesh, and volumes were read".to_owned()));
            }
            (Uploaded::Volumes(_), Method::Sweep) | (Uploaded::Mesh(_), Method::Voxels) => true,
            (Uploaded::MeshVolumes(shown, _), Method::Sweep) => shown.fits(scene, self.inputs)?,
            (Uploaded::Mesh(_), Method::Sweep) | (Uploaded::MeshVolumes(..), Method::Voxels) => false,
        };
        if fits {
            return Ok(());
        }
        let backend = self.backend.get();
        self.uploaded = Uploaded::Mesh(None);
        if scene.method == Method::Sweep {
            // How long that takes beside the sweep is not known, so that it counts for nothing.
            let mut wait = |_, _| progress(Progress { done: 0, total: 1 });
            let shown = MeshVolumes::new(scene, self.inputs, backend, &mut wait)?;
            let volumes = sweep::Uploaded::new(&shown.inputs, backend)?;
            self.uploaded = Uploaded::MeshVolumes(Box::new(shown), volumes);
        }
        Ok(())
    }
}

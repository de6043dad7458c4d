//! The renderer: from a scene to a frame.

use crate::assets::Assets;
use crate::backend::{Backend, BackendError};
use crate::course::exposed;
use crate::error::Error;
use crate::film::Frame;
use crate::ground_alone::ground_alone;
use crate::method::{self, Cache, Job};
use crate::preset;
use crate::request::{Layers, OutputRequest, Progress};
use crate::scene::{Background, Interpolation, Scene};
use crate::subject::Volumes;
use crate::unrenderable::Unrenderable;
use std::sync::Arc;
use vitrum_io::Mesh;

/// Opens another backend after a failure of the first one's device.
pub type Fallback = dyn FnMut(&BackendError) -> Result<Box<dyn Backend>, BackendError> + Send;

/// Renders frames of the same assets one after another, while camera, lights, transfer functions or materials change: data that a
/// change leaves alone stays on the backend.
pub struct Renderer {
    assets: Assets,
    backend: Box<dyn Backend>,
    /// Opens the backend to go on with when the device fails, until it has been called.
    fallback: Option<Box<Fallback>>,
    cache: Cache,
}

impl Renderer {
    /// A renderer of `assets`, such as a volume or a mesh, on `backend`.
    pub fn new(backend: Box<dyn Backend>, assets: impl Into<Assets>) -> Self {
        Self { assets: assets.into(), backend, fallback: None, cache: Cache::default() }
    }

    /// When the backend's device fails or has too little memory, the renderer goes on with the backend that `fallback` opens: data is
    /// uploaded again, and the frame begins anew. `fallback` is called once at most, with the reason; it is the place to tell the user.
    #[must_use]
    pub fn with_fallback(self, fallback: Box<Fallback>) -> Self {
        Self { fallback: Some(fallback), ..self }
    }

    /// The data that is rendered.
    pub fn assets(&self) -> &Assets {
        &self.assets
    }

    /// Renders other assets from now on.
    pub fn show(&mut self, assets: impl Into<Assets>) {
        self.assets = assets.into();
        self.cache = Cache::default();
    }

    /// Renders the mesh, or the bodies within the volume, in another shape from now on, such as that of a later moment ([`crate::MovingMeshes`]). What does not depend on a mesh's
    /// shape stays on the backend; of a mesh with the same triangles, materials and colours, so does the tree that exact surfaces and beams
    /// are looked for in, which is refitted.
    pub fn deform(&mut self, mesh: Arc<Mesh>) {
        if self.assets.subject.mesh().is_none() && self.assets.bodies.is_none() {
            self.cache = Cache::default();
        }
        self.assets.set_mesh(mesh);
    }

    /// The backend.
    pub fn backend(&mut self) -> &mut dyn Backend {
        self.backend.as_mut()
    }

    /// Renders a scene of the renderer's assets, with the outputs that are requested. The files that the scene names are not looked at.
    /// `progress` is called from time to time and cancels the frame by returning `false`.
    ///
    /// # Errors
    /// If the scene is not valid, or the backend fails; the renderer can go on with another scene.
    pub fn render(
        &mut self,
        scene: &Scene,
        request: OutputRequest,
        progress: &mut (dyn FnMut(Progress) -> bool + Send),
    ) -> Result<Frame, Error> {
        let failure = match self.render_once(scene, request, progress) {
            Err(Error::Backend(error)) if error.is_device_error() => error,
            outcome => return outcome,
        };
        let Some(mut fallback) = self.fallback.take() else { return Err(failure.into()) };
        self.cache = Cache::default();
        self.backend = fallback(&failure)?;
        self.render_once(scene, request, progress)
    }

    fn render_once(
        &mut self,
        scene: &Scene,
        request: OutputRequest,
        progress: &mut (dyn FnMut(Progress) -> bool + Send),
    ) -> Result<Frame, Error> {
        let job = Job { scene, assets: &self.assets, request, chosen: None };
        frame(&job, &mut self.cache, self.backend.as_mut(), progress)
    }
}

/// Whether a frame of a scene can be made of its assets, as far as that can be told without a backend and without work.
///
/// # Errors
/// [`Error::SceneFile`] where a key is out of its range, [`Error::Unrenderable`] where the scene's method cannot show the assets, or the scene's
/// values together make no frame, as when the light shines towards the camera.
pub fn check(scene: &Scene, assets: &Assets) -> Result<(), Error> {
    scene.check_settings()?;
    if scene.volume.interpolation == Interpolation::Cubic {
        let mut volumes = assets.subject.volumes().into_iter().flat_map(Volumes::iter);
        if let Some(labels) = volumes.find(|volume| preset::are_named_labels(volume)) {
            return Err(Unrenderable::CubicLabels { name: labels.name.clone() }.into());
        }
    }
    method::of(scene.method).check(scene, assets)
}

/// Renders one frame of a scene with all outputs. `progress` is called from time to time and cancels the frame by returning `false`.
///
/// # Errors
/// Those of [`check`]; [`Error::Backend`] where the backend lacks the memory or fails, or `progress` cancels.
pub fn render(
    scene: &Scene,
    assets: &Assets,
    backend: &mut dyn Backend,
    progress: &mut (dyn FnMut(Progress) -> bool + Send),
) -> Result<Frame, Error> {
    render_requested(scene, assets, OutputRequest::default(), backend, progress)
}

/// As [`render`], with the outputs that are requested. Each is the same as with all.
///
/// # Errors
/// As [`render`].
pub fn render_requested(
    scene: &Scene,
    assets: &Assets,
    request: OutputRequest,
    backend: &mut dyn Backend,
    progress: &mut (dyn FnMut(Progress) -> bool + Send),
) -> Result<Frame, Error> {
    frame(&Job { scene, assets, request, chosen: None }, &mut Cache::default(), backend, progress)
}

/// Renders one frame with the data that a cache has of earlier frames; the cache must belong to the same assets and the same backend.
///
/// This is the one course from a scene to a frame, for every method: each exposure is prepared, run and read, then summed up; the sum
/// becomes the frame's layers.
///
/// # Errors
/// As [`render`].
pub fn frame(
    job: &Job<'_>,
    cache: &mut Cache,
    backend: &mut dyn Backend,
    progress: &mut (dyn FnMut(Progress) -> bool + Send),
) -> Result<Frame, Error> {
    backend.threads().run(|| frame_here(job, cache, backend, progress))
}

/// As [`frame`], on the threads that this is called on.
fn frame_here(
    job: &Job<'_>,
    cache: &mut Cache,
    backend: &mut dyn Backend,
    progress: &mut (dyn FnMut(Progress) -> bool + Send),
) -> Result<Frame, Error> {
    check(job.scene, job.assets)?;
    let shown = cache.shown(job.scene, job.assets)?;
    let assets = shown.as_ref().unwrap_or(job.assets);
    let framed = cache.framed(job.scene, assets);
    let scene = framed.as_ref().unwrap_or(job.scene);
    let finer = cache.finer(scene, assets)?;
    let (scene, assets) = finer.as_ref().map_or((scene, assets), |(scene, assets)| (scene, assets));
    let job = &Job { scene, assets, ..*job };
    let Some(background) = job.scene.background.as_deref().and_then(Background::parse) else {
        return exposed(job, cache, backend, progress);
    };
    // The background takes the environment's place in the picture alone.
    let mut scene = job.scene.clone();
    scene.environment.visible = false;
    let catches = scene.ground.as_ref().is_some_and(|ground| ground.shadow_catcher);
    if catches {
        // Differences of pictures: each pixel has the same rays in all of them.
        scene.film.refinement = 1;
    }
    // The background shines through clear matter in its colour.
    let request = OutputRequest { layers: job.request.layers.with("transmittance"), ..job.request };
    let job = &Job { request, ..*job };
    let whole = exposed(&Job { scene: &scene, ..*job }, cache, backend, progress)?;
    let frame = if catches {
        let bare = Scene { ground: None, ..scene.clone() };
        let layers = Layers::color().with("transmittance").with("depth");
        let job = &Job { request: OutputRequest { light: false, layers, ..job.request }, ..*job };
        let bare = exposed(&Job { scene: &bare, ..*job }, cache, backend, progress)?;
        let (alone, assets) = ground_alone(&scene, job.assets)?;
        let alone = Job { scene: &alone, assets: &assets, ..*job };
        let alone = exposed(&alone, &mut Cache::default(), backend, progress)?;
        whole.catch_shadows(&bare, &alone)
    } else {
        whole
    };
    Ok(match background {
        Background::Color(paint) => frame.before(paint),
        Background::Transparent => frame,
    })
}

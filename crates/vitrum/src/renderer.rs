//! The renderer: from a scene to a frame.

use crate::assets::Assets;
use crate::backend::times::merge;
use crate::backend::{Backend, BackendError, KernelTime, ReadBack as _};
use crate::error::Error;
use crate::film::{Accumulator, Frame, RayRecords, Rendered, Statistics, index_of, replace};
use crate::method::{self, Bounds, Cache, Exposure, Job, Method, Part, PreparedFrame, RefinedPixels, Tools, View};
use crate::request::{OutputRequest, Progress, Stage};
use crate::scene::{Background, Film, Light, MethodName, OpacityPoint, Scene, Surroundings, TransferFunction};
use crate::subject::Subject;
use std::sync::Arc;
use vitrum_io::{Layer, Mesh, Volume, Voxels};
use web_time::Instant;

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

    /// Renders the mesh in another shape from now on, such as that of a later moment ([`crate::MovingMeshes`]). What does not depend on a mesh's
    /// shape stays on the backend; of a mesh with the same triangles, materials and colours, so does the tree that exact surfaces and beams
    /// are looked for in, which is refitted.
    pub fn deform(&mut self, mesh: Arc<Mesh>) {
        if self.assets.subject.mesh().is_none() {
            self.cache = Cache::default();
        }
        self.assets.subject = Subject::Mesh(mesh);
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
        let job = Job { scene, assets: &self.assets, request, refined: None };
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
    frame(&Job { scene, assets, request, refined: None }, &mut Cache::default(), backend, progress)
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
    let whole = exposed(&Job { scene: &scene, ..*job }, cache, backend, progress)?;
    let frame = if catches {
        let bare = Scene { ground: None, ..scene.clone() };
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

/// The scene's ground with nothing on it: a clear volume takes the subject's place, so that camera and light are the same.
fn ground_alone(scene: &Scene, assets: &Assets) -> Result<(Scene, Assets), Error> {
    let [corner, x, y, z] = [0, 1, 2, 4].map(|index| Bounds::from(&assets.subject).corners()[index]);
    let edges = [x, y, z].map(|end| end - corner);
    let spacing = edges.map(|edge| 0.5 * edge.length());
    let mut clear = Volume::new("ground", [2; 3], spacing.map(|edge| edge as f32), Voxels::from(vec![0_u8; 8]))?;
    clear.axes = edges.map(|edge| edge.normalize().as_vec3().to_array());
    clear.origin = (corner + (edges[0] + edges[1] + edges[2]) * 0.25).as_vec3().to_array();
    let nothing = TransferFunction { opacity: vec![OpacityPoint { value: 0.0, opacity: 0.0 }], ..Default::default() };
    // Where nothing casts shadows, a light may stand anywhere.
    let light = scene.light.iter().map(|light| Light { shadows: false, ..light.clone() }).collect();
    let alone = Scene {
        method: MethodName::Sweep,
        light,
        transfer: nothing,
        mesh: Vec::new(),
        ior_volume: None,
        material: Vec::new(),
        clip: Vec::new(),
        wall: None,
        surroundings: Surroundings::default(),
        ..scene.clone()
    };
    Ok((alone, Assets { subject: clear.into(), ..assets.clone() }))
}

/// A frame of a scene as it is, with its exposures summed up.
fn exposed(
    job: &Job<'_>,
    cache: &mut Cache,
    backend: &mut dyn Backend,
    progress: &mut (dyn FnMut(Progress) -> bool + Send),
) -> Result<Frame, Error> {
    let scene = job.scene;
    let method = method::of(scene.method);
    let exposures = method.exposures(scene, job.assets);
    // These come first.
    let whole = exposures.iter().filter(|exposure| exposure.part == Part::Whole).count();
    let mut course = Course { method, cache, backend, progress, spent: Spent::default() };
    let mut sum = Accumulator::new(method.outputs(), exposures.len());
    let mut statistics = Statistics::default();
    for (index, exposure) in exposures.iter().enumerate() {
        let job = Job { scene: &exposure.scene, ..*job };
        let prepared = course.add(&job, exposure, (index, exposures.len()), Stage::Render, &mut sum)?;
        if index + 1 == whole {
            statistics = Statistics::of(scene, course.backend);
            prepared.statistics(&sum.film, course.backend, &mut statistics)?;
        }
    }
    let size = [scene.film.width, scene.film.height];
    let rays = RayRecords { records: &sum.film, size, edge: scene.film.supersampling };
    let shown = || method.outputs().iter().filter(|output| !output.channels.is_empty());
    let mut layers: Vec<Layer> = shown().map(|output| rays.layer(output)).collect();
    if method.refines() && scene.film.refinement > scene.film.supersampling {
        let fates = layers.iter().find(|layer| layer.name == "status").map(|layer| layer.channels[0].data.as_slice());
        let exposure = libm::exp2f(scene.film.exposure);
        let Film { supersampling, refinement, refinement_budget, .. } = scene.film;
        let times = refinement as f32 / supersampling as f32;
        let pixels = Rendered { color: &layers[0], fates, size, exposure }.differing(times * times, refinement_budget);
        statistics.refined_pixels = Some(pixels.len() as u64);
        course.refine(job, &exposures, &pixels, &mut layers)?;
    }
    let Spent { frame_ms, upload_ms, kernels, dispatches } = course.spent;
    let [width, height] = size;
    let bounds = Bounds::from(&job.assets.subject);
    let camera = Some(View::new(scene, bounds).matrices(height, bounds));
    let (frame_ms, upload_ms) = (vec![frame_ms], Some(upload_ms));
    let statistics = Statistics { camera, dispatches, frame_ms, kernels, upload_ms, ..statistics };
    Ok(Frame { width, height, layers, light: sum.light, statistics }.expose(scene.film.exposure))
}

/// Time and passes that a frame has taken.
#[derive(Default)]
struct Spent {
    frame_ms: f64,
    upload_ms: f64,
    kernels: Vec<KernelTime>,
    dispatches: u64,
}

/// A frame on its course.
struct Course<'a> {
    method: &'static dyn Method,
    cache: &'a mut Cache,
    backend: &'a mut dyn Backend,
    progress: &'a mut (dyn FnMut(Progress) -> bool + Send),
    spent: Spent,
}

/// The most rays of refined pixels at once: their records take some hundred megabytes.
const MOST_REFINED_RAYS: usize = 1 << 20;

impl Course<'_> {
    /// Renders the exposure of a job, number `index` of `count`, and adds it to `sum`.
    fn add(
        &mut self,
        job: &Job<'_>,
        exposure: &Exposure,
        (index, count): (usize, usize),
        stage: Stage,
        sum: &mut Accumulator,
    ) -> Result<Box<dyn PreparedFrame>, Error> {
        let Self { method, cache, backend, progress, spent } = self;
        let started = Instant::now();
        let prepared = method.prepare(job, cache, &mut Tools { backend: &mut **backend, progress: &mut **progress })?;
        spent.upload_ms += started.elapsed().as_secs_f64() * 1e3;
        backend.take_kernel_times();
        let started = Instant::now();
        let (index, count) = (index as u64, count as u64);
        let mut tell = |done: u64, all: u64| progress(Progress { stage, done: index * all + done, total: count * all });
        prepared.run(&mut **backend, &mut tell)?;
        let film = backend.read_all(prepared.film())?;
        spent.frame_ms += started.elapsed().as_secs_f64() * 1e3;
        merge(&mut spent.kernels, &backend.take_kernel_times());
        spent.dispatches += prepared.passes().passes.len() as u64;
        let light = prepared.light(&mut **backend)?;
        let [across, down] = prepared.rays();
        sum.add(exposure, film, across as usize * down as usize, light);
        Ok(prepared)
    }

    /// Renders some pixels anew, with more rays, and puts their values into `layers`.
    fn refine(
        &mut self,
        job: &Job<'_>,
        exposures: &[Exposure],
        pixels: &[u32],
        layers: &mut [Layer],
    ) -> Result<(), Error> {
        let film = &job.scene.film;
        let edge = film.refinement;
        let columns = RefinedPixels::COLUMNS as usize;
        let at_once = (MOST_REFINED_RAYS / (edge * edge) as usize / columns).max(1) * columns;
        // Rows are full: the last pixel stands in for those that are missing.
        let filled = |part: &[u32]| {
            let missing = part.len().next_multiple_of(columns) - part.len();
            part.iter().copied().chain(part.last().copied().into_iter().cycle().take(missing)).collect::<Vec<u32>>()
        };
        let parts: Vec<Vec<u32>> = pixels.chunks(at_once).map(filled).collect();
        let outputs = self.method.outputs();
        let mut sums: Vec<_> = parts.iter().map(|_| Accumulator::new(outputs, exposures.len())).collect();
        let count = exposures.len() * parts.len();
        // All parts in a light that is there, then all in the next one.
        let all = exposures.iter().flat_map(|exposure| (0..parts.len()).map(move |part| (exposure, part)));
        for (index, (exposure, part)) in all.enumerate() {
            let refined = Some(RefinedPixels { pixels: &parts[part], edge });
            let job = Job { scene: &exposure.scene, request: OutputRequest { light: false }, refined, ..*job };
            self.add(&job, exposure, (index, count), Stage::Refine, &mut sums[part])?;
        }
        for (part, sum) in parts.iter().zip(&sums) {
            let refined = RefinedPixels { pixels: part, edge };
            let rays = RayRecords { records: &sum.film, size: refined.size(), edge };
            let at: Vec<usize> = part.iter().map(|&word| index_of(word, film.width)).collect();
            for (layer, output) in layers.iter_mut().zip(outputs.iter().filter(|output| !output.channels.is_empty())) {
                replace(layer, output, &rays.layer(output), &at);
            }
        }
        Ok(())
    }
}

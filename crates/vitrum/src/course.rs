//! The course from a scene to a frame: exposures one after another, summed up, and pixels that are rendered anew.

use crate::backend::times::merge;
use crate::backend::{Backend, KernelTime, ReadBack as _};
use crate::error::Error;
use crate::film::{Accumulator, Frame, RayRecords, Rendered, Statistics, index_of, replace};
use crate::method::{self, Bounds, Cache, Exposure, Job, Method, Part, PreparedFrame, RefinedPixels, Tools, View};
use crate::request::{OutputRequest, Progress, Stage};
use crate::scene::Film;
use vitrum_io::Layer;
use web_time::Instant;

/// A frame of a scene as it is, with its exposures summed up.
pub(crate) fn exposed(
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

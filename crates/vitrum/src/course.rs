//! The course from a scene to a frame: exposures one after another, each in parts, summed up; and pixels that are rendered anew.

use crate::backend::times::merge;
use crate::backend::{Backend, KernelTime, ReadBack as _};
use crate::error::Error;
use crate::film::{Accumulator, Costly, Frame, Places, RayRecords, Rendered, Statistics};
use crate::method::{self, Bounds, Cache, ChosenRays, Exposure, Job, Method, Part, PreparedFrame};
use crate::method::{RefinedPixels, Tools, View};
use crate::parts::parts;
use crate::request::{OutputRequest, Progress, Stage};
use crate::scene::Film;
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
    let Film { width, height, supersampling, refinement, refinement_budget, .. } = scene.film;
    let size = [width, height];
    let mut course = Course { method, cache, backend, progress, spent: Spent::default() };
    let mut sum = Accumulator::new(method.outputs(), job.request.layers, exposures.len(), size)?;
    let refines = method.refines() && refinement > supersampling;
    let mut costly = refines.then(|| Costly::none(size));
    let mut statistics = course.expose(job, &exposures, &mut sum, costly.as_mut())?;
    if let (Some(costly), Some(color)) = (costly, sum.layers.first()) {
        let exposure = libm::exp2f(scene.film.exposure);
        let times = refinement as f32 / supersampling as f32;
        let rendered = Rendered { color, costly: &costly, size, exposure };
        let pixels = rendered.differing(times * times, refinement_budget);
        drop(costly);
        statistics.refined_pixels = Some(pixels.len() as u64);
        course.refine(job, &exposures, &pixels, &mut sum)?;
    }
    let Spent { frame_ms, upload_ms, kernels, dispatches } = course.spent;
    let bounds = Bounds::from(&job.assets.subject);
    let camera = Some(View::new(scene, bounds).matrices(height, bounds));
    let (frame_ms, upload_ms) = (vec![frame_ms], Some(upload_ms));
    let statistics = Statistics { camera, dispatches, frame_ms, kernels, upload_ms, ..statistics }.with_peak();
    let Accumulator { layers, light, .. } = sum;
    Ok(Frame { width, height, layers, light, statistics }.expose(scene.film.exposure))
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

impl Course<'_> {
    /// Renders all exposures, each part of the picture by itself, and sums them up.
    fn expose(
        &mut self,
        job: &Job<'_>,
        exposures: &[Exposure],
        sum: &mut Accumulator,
        mut costly: Option<&mut Costly>,
    ) -> Result<Statistics, Error> {
        let Film { width, height, supersampling: edge, .. } = job.scene.film;
        let size = [width, height];
        let most = if self.method.divides(job.scene) { job.request.rays_at_once } else { u32::MAX };
        let parts = parts(size, edge, most);
        let count = exposures.len() * parts.len();
        // These come first.
        let whole = exposures.iter().filter(|exposure| exposure.part == Part::Whole).count();
        let (mut counted, mut statistics) = (Statistics::default(), Statistics::default());
        // All parts in a light that is there, then all in the next one.
        for (index, exposure) in exposures.iter().enumerate() {
            sum.begin(index, exposure);
            if sum.is_nearest() {
                counted = Statistics::default();
            }
            for (number, part) in parts.iter().enumerate() {
                let tile = (parts.len() > 1).then(|| part.tile(size, edge));
                let request = OutputRequest { light: job.request.light && number == 0, ..job.request };
                let job = Job { scene: &exposure.scene, request, chosen: tile.map(ChosenRays::Tile), ..*job };
                let at = (index * parts.len() + number, count);
                let (prepared, mut film) = self.render(&job, at, Stage::Render)?;
                if let Some(light) = prepared.light(&mut *self.backend)? {
                    sum.add_light(light);
                }
                if let Some(tile) = tile {
                    part.trim(tile, edge, &mut film);
                }
                if sum.is_nearest() {
                    prepared.count(&film, &mut counted);
                    if let Some(costly) = &mut costly {
                        costly.find(*part, edge, |ray| self.method.is_costly(&film, ray));
                    }
                }
                sum.add(&RayRecords { records: &film, size: part.size, edge }, &Places::Rectangle(*part));
                if (index + 1, number + 1) == (whole, parts.len()) {
                    statistics = Statistics::of(job.scene, &mut *self.backend);
                    prepared.statistics(&mut *self.backend, &mut statistics)?;
                }
            }
        }
        let Statistics { rays_terminated, rays_trapped, .. } = counted;
        Ok(Statistics { rays_terminated, rays_trapped, ..statistics })
    }

    /// Renders the exposure of a job, number `index` of `count`: the prepared frame and the finished records.
    fn render(
        &mut self,
        job: &Job<'_>,
        (index, count): (usize, usize),
        stage: Stage,
    ) -> Result<(Box<dyn PreparedFrame>, Vec<f32>), Error> {
        let Self { method, cache, backend, progress, spent } = self;
        let started = Instant::now();
        let prepared = method.prepare(job, cache, &mut Tools { backend: &mut **backend, progress: &mut **progress })?;
        spent.upload_ms += started.elapsed().as_secs_f64() * 1e3;
        backend.take_kernel_times();
        let started = Instant::now();
        let (index, count) = (index as u64, count as u64);
        let mut tell = |done: u64, all: u64| progress(Progress { stage, done: index * all + done, total: count * all });
        prepared.run(&mut **backend, &mut tell)?;
        job.assets.subject.check_read()?;
        let film = backend.read_all(prepared.film())?;
        spent.frame_ms += started.elapsed().as_secs_f64() * 1e3;
        merge(&mut spent.kernels, &backend.take_kernel_times());
        spent.dispatches += prepared.passes().passes.len() as u64;
        Ok((prepared, film))
    }

    /// Renders some pixels anew, with more rays, and puts their values in place of those in `sum`.
    fn refine(
        &mut self,
        job: &Job<'_>,
        exposures: &[Exposure],
        pixels: &[u32],
        sum: &mut Accumulator,
    ) -> Result<(), Error> {
        let edge = job.scene.film.refinement;
        let columns = RefinedPixels::COLUMNS as usize;
        let at_once = ((job.request.rays_at_once / (edge * edge)) as usize / columns).max(1) * columns;
        let count = exposures.len() * pixels.len().div_ceil(at_once);
        let mut done = 0;
        for (index, exposure) in exposures.iter().enumerate() {
            sum.begin(index, exposure);
            for part in pixels.chunks(at_once) {
                // Rows are full: the last pixel stands in for those that are missing.
                let missing = part.len().next_multiple_of(columns) - part.len();
                let last = part.last().copied().into_iter().cycle().take(missing);
                let filled: Vec<u32> = part.iter().copied().chain(last).collect();
                let refined = RefinedPixels { pixels: &filled, edge };
                let request = OutputRequest { light: false, ..job.request };
                let chosen = Some(ChosenRays::Refined(refined));
                let job = Job { scene: &exposure.scene, request, chosen, ..*job };
                let (_, film) = self.render(&job, (done, count), Stage::Refine)?;
                done += 1;
                let rays = RayRecords { records: &film, size: refined.size(), edge };
                sum.add(&rays, &Places::Anew(part));
            }
        }
        Ok(())
    }
}

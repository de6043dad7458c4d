//! From the records of a finished sweep to a frame.

use super::Sweep;
use crate::backend::{Backend, KernelTime};
use crate::error::Error;
use crate::film::{Frame, Pixel, Rays, Statistics, rgb, rgba, xyz};
use crate::request::Wanted;
use crate::scene::Scene;
use std::time::Instant;
use vitrum_io::{Layer, Picture};
use vitrum_kernels::abi::record::{film, status};

/// What a frame that was run has made.
pub(crate) struct Exposure {
    /// Planar records, see [`film`].
    pub film: Vec<f32>,
    /// Irradiance, if wanted: see [`Sweep::irradiance`].
    pub light: Option<Vec<f32>>,
    /// Time to run it and read it back.
    pub frame_ms: f64,
    /// What of it the kernels took.
    pub kernels: Vec<KernelTime>,
}

/// Runs a prepared frame and reads its outputs; `progress` is told the planes that are done.
pub(crate) fn expose(
    sweep: &Sweep,
    wanted: Wanted,
    backend: &mut dyn Backend,
    progress: &mut dyn FnMut(u32) -> bool,
) -> Result<Exposure, Error> {
    let started = Instant::now();
    backend.take_kernel_times();
    sweep.run(backend, progress)?;
    let film = sweep.film(backend)?;
    let frame_ms = started.elapsed().as_secs_f64() * 1e3;
    let light = if wanted.light { Some(sweep.irradiance(backend)?) } else { None };
    Ok(Exposure { film, light, frame_ms, kernels: backend.take_kernel_times() })
}

/// A frame of what a sweep has made.
pub(crate) fn develop(
    scene: &Scene,
    sweep: &Sweep,
    exposure: &Exposure,
    backend: &mut dyn Backend,
    upload_ms: f64,
) -> Frame {
    let (width, height) = (scene.film.width, scene.film.height);
    let rays = sweep.rays[0] as usize * sweep.rays[1] as usize;
    let turned = exposure.film[film::STATUS * rays..].iter().filter(|&&fate| fate == status::TURNED).count();
    let frame = Frame {
        width,
        height,
        layers: layers(scene, &exposure.film),
        light: exposure.light.as_ref().map(|light| light_picture(sweep, light)),
        statistics: Statistics {
            planes: sweep.planes.count,
            light_texels: sweep.light_grid.size,
            rays_turned: turned as u64,
            frame_ms: vec![exposure.frame_ms],
            upload_ms: Some(upload_ms),
            kernels: exposure.kernels.clone(),
            ..Statistics::of(scene, backend)
        },
    };
    frame.expose(scene.film.exposure)
}

fn layers(scene: &Scene, records: &[f32]) -> Vec<Layer> {
    let size = [scene.film.width, scene.film.height];
    let rays = Rays { records, size, edge: scene.film.supersampling };
    vec![
        rays.layer("color", Pixel::Mean, rgba(film::COLOR)),
        rays.layer("opacity", Pixel::Mean, [("Y", film::OPACITY)]),
        rays.layer("transmittance", Pixel::Mean, rgb(film::MEDIUM)),
        rays.layer("depth", Pixel::WeightedBy(film::OPACITY), [("Z", film::DEPTH)]),
        rays.layer("direction", Pixel::Direction, xyz(film::DIRECTION)),
        rays.layer("position", Pixel::Central, xyz(film::POSITION)),
        rays.layer("status", Pixel::Central, [("Y", film::STATUS)]),
    ]
}

/// The light on the last plane; the grid's rows go up, a picture's down.
fn light_picture(sweep: &Sweep, records: &[f32]) -> Picture {
    let [width, height] = sweep.light_grid.size;
    let texels = width as usize * height as usize;
    let pixels = (0..height as usize)
        .rev()
        .flat_map(|row| (0..width as usize).map(move |column| row * width as usize + column))
        .map(|at| [records[at], records[texels + at], records[2 * texels + at]])
        .collect();
    Picture::rgb(width, height, pixels)
}

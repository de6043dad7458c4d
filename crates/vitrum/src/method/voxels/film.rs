//! A frame of a mesh.

use super::passes::Rays;
use super::uploaded::Uploaded;
use crate::backend::Backend;
use crate::error::Error;
use crate::film::{self, Frame, Pixel, Statistics, rgb, rgba, xyz};
use crate::inputs::Inputs;
use crate::request::Progress;
use crate::scene::Scene;
use std::time::Instant;
use vitrum_io::Layer;
use vitrum_kernels::abi::record::{fate, view};

/// Renders a mesh. What is in `held` is used again if the scene's rays run through the same.
pub(crate) fn render(
    scene: &Scene,
    inputs: &Inputs,
    held: &mut Option<Box<Uploaded>>,
    backend: &mut dyn Backend,
    progress: &mut dyn FnMut(Progress) -> bool,
) -> Result<Frame, Error> {
    let mesh = inputs.mesh.as_ref().ok_or_else(|| Error::Scene("there is no mesh".to_owned()))?;
    let started = Instant::now();
    held.take_if(|held| !held.fits(scene, mesh));
    // How long that takes beside the rays is not known, so that it counts for nothing.
    let mut tell = |_, _| progress(Progress { done: 0, total: 1 });
    if held.is_none() {
        *held = Some(Box::new(Uploaded::new(scene, inputs, backend, &mut tell)?));
    }
    let uploaded = held.as_mut().expect("it was made above");
    uploaded.update(scene, inputs, backend, &mut tell)?;
    let rays = Rays::prepare(scene, inputs, uploaded, backend)?;
    let upload_ms = started.elapsed().as_secs_f64() * 1e3;
    backend.take_kernel_times();
    let started = Instant::now();
    let total = rays.passes.passes.len() as u32;
    let film = rays
        .run(backend, &mut |done| progress(Progress { done: done as u32, total }))
        .and_then(|()| rays.film(backend));
    let frame_ms = started.elapsed().as_secs_f64() * 1e3;
    let statistics = Statistics::of(scene, backend);
    let count = rays.rays[0] as usize * rays.rays[1] as usize;
    let film = film?;
    let trapped = film[view::STATUS * count..].iter().filter(|&&status| status == fate::TRAPPED).count();
    let frame = Frame {
        width: scene.film.width,
        height: scene.film.height,
        layers: layers(scene, &film),
        light: None,
        statistics: Statistics {
            voxels: uploaded.voxels(),
            open_rows: uploaded.voxels().map(|_| uploaded.open_rows),
            planes: total,
            rays_turned: trapped as u64,
            frame_ms: vec![frame_ms],
            upload_ms: Some(upload_ms),
            ..statistics
        },
    };
    Ok(frame.expose(scene.film.exposure))
}

fn layers(scene: &Scene, records: &[f32]) -> Vec<Layer> {
    let size = [scene.film.width, scene.film.height];
    let rays = film::Rays { records, size, edge: scene.film.supersampling };
    vec![
        rays.layer("color", Pixel::Mean, rgba(view::COLOR)),
        rays.layer("depth", Pixel::Present, [("Z", view::DEPTH)]),
        rays.layer("direction", Pixel::Direction, xyz(view::DIRECTION)),
        rays.layer("normal", Pixel::Direction, xyz(view::NORMAL)),
        rays.layer("bounces", Pixel::Central, [("Y", view::BOUNCES)]),
        rays.layer("path_length", Pixel::Mean, [("Y", view::LENGTH)]),
        rays.layer("transmittance", Pixel::Mean, rgb(view::TRANSMITTANCE)),
        rays.layer("reflectance", Pixel::Mean, [("Y", view::REFLECTANCE)]),
        rays.layer("status", Pixel::Central, [("Y", view::STATUS)]),
    ]
}

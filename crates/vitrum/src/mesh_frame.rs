//! A frame of a mesh.

use crate::backend::Backend;
use crate::frame::{Frame, Statistics, layer};
use crate::inputs::Inputs;
use crate::method::voxels::{Rays, Uploaded};
use crate::render::{Error, Progress, peak_rss_bytes};
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
    if let Some(other) = held.take_if(|held| !held.fits(scene, mesh)) {
        other.free(backend);
    }
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
    let count = rays.rays[0] as usize * rays.rays[1] as usize;
    rays.free(backend);
    let film = film?;
    let frame_ms = started.elapsed().as_secs_f64() * 1e3;
    let trapped = film[view::STATUS * count..].iter().filter(|&&status| status == fate::TRAPPED).count();
    Ok(Frame {
        width: scene.film.width,
        height: scene.film.height,
        layers: layers(scene, &film),
        light: None,
        statistics: Statistics {
            method: "voxels".to_owned(),
            backend: backend.name().to_owned(),
            adapter: backend.adapter(),
            width: scene.film.width,
            height: scene.film.height,
            voxels: uploaded.voxels(),
            planes: total,
            light_texels: [0, 0],
            rays_turned: trapped as u64,
            frame_ms: vec![frame_ms],
            upload_ms: Some(upload_ms),
            kernels: backend.take_kernel_times(),
            peak_rss_bytes: peak_rss_bytes(),
            gpu_bytes: backend.device_bytes(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
        },
    })
}

fn layers(scene: &Scene, records: &[f32]) -> Vec<Layer> {
    let size = [scene.film.width, scene.film.height];
    let make = |name: &str, channels: &[(&str, usize)]| layer(name, records, size, scene.film.supersampling, channels);
    let color = |from: usize| [("R", from), ("G", from + 1), ("B", from + 2)];
    let vector = |from: usize| [("X", from), ("Y", from + 1), ("Z", from + 2)];
    let [r, g, b] = color(view::COLOR);
    let mut first = make("color", &[r, g, b, ("A", view::COLOR + 3)]);
    let exposure = scene.film.exposure.exp2();
    for channel in first.channels.iter_mut().take(3) {
        channel.data.iter_mut().for_each(|value| *value *= exposure);
    }
    vec![
        first,
        make("depth", &[("Z", view::DEPTH)]),
        make("direction", &vector(view::DIRECTION)),
        make("normal", &vector(view::NORMAL)),
        make("bounces", &[("Y", view::BOUNCES)]),
        make("path_length", &[("Y", view::LENGTH)]),
        make("transmittance", &color(view::TRANSMITTANCE)),
        make("reflectance", &[("Y", view::REFLECTANCE)]),
        make("status", &[("Y", view::STATUS)]),
    ]
}

//! Renders a volume's file with the look of a preset: `cargo run --example volume -- scan.nrrd`; without a file, a built-in volume.

use std::path::Path;
use vitrum::scene::{Scene, VolumeSource};
use vitrum::{Assets, OutputRequest, Renderer, backend, preset};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut scene = Scene { volume: VolumeSource::default(), ..Scene::default() };
    match std::env::args().nth(1) {
        Some(file) => scene.volume.file = Some(file.into()),
        None => (scene.volume.builtin, scene.volume.resolution) = (Some("head".to_owned()), Some(48)),
    }
    (scene.film.width, scene.film.height) = (160, 120);
    let assets = Assets::load(&scene, Path::new(""))?;
    let volume = assets.subject.volume().ok_or("the scene shows a volume")?;
    preset::apply("amber", volume, &mut scene)?;
    let backend = backend::open(backend::Choice::Auto, &backend::GpuOptions::default(), None)?;
    let mut renderer = Renderer::new(backend, assets);
    renderer
        .render(&scene, OutputRequest { light: false, ..OutputRequest::default() }, &mut |_| true)?
        .write("volume.png".as_ref())?;
    Ok(())
}

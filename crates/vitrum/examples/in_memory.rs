//! Renders an array that a program has in memory, here a ball of smoothly falling density.

use vitrum::backend::CpuBackend;
use vitrum::io::{Volume, Voxels};
use vitrum::scene::Scene;
use vitrum::{OutputRequest, Renderer, preset};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    const N: u32 = 48;
    // x fastest, then y, then z.
    let density = |index: u32| {
        let at = [index % N, index / N % N, index / (N * N)].map(|x| x as f32 / N as f32 - 0.5);
        (1.0 - 2.0 * at.iter().map(|x| x * x).sum::<f32>().sqrt()).max(0.0)
    };
    let voxels: Vec<f32> = (0..N.pow(3)).map(density).collect();
    let volume = Volume::new("a ball", [N; 3], [1.0; 3], Voxels::from(voxels))?;
    let mut scene = Scene::default();
    (scene.film.width, scene.film.height) = (128, 128);
    preset::apply("plain", &volume, &mut scene)?;
    let mut renderer = Renderer::new(Box::new(CpuBackend::new(None)?), volume);
    for azimuth in [0.0, 60.0, 120.0] {
        scene.camera.azimuth = azimuth;
        let frame =
            renderer.render(&scene, OutputRequest { light: false, ..OutputRequest::default() }, &mut |_| true)?;
        frame.write(format!("ball-{azimuth}.png").as_ref())?;
    }
    Ok(())
}

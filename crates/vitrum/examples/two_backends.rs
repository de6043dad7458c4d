//! Renders the same scene on the CPU and, where there is an adapter, on the GPU, and compares the pictures.

use std::path::Path;
use vitrum::backend::{Backend, CpuBackend, GpuBackend};
use vitrum::{Assets, builtin, render};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut scene = builtin::scene("luneburg").ok_or("there is a built-in Luneburg lens")?;
    scene.volume.resolution = Some(32);
    (scene.film.width, scene.film.height) = (64, 64);
    let assets = Assets::load(&scene, Path::new(""))?;
    let expected = render(&scene, &assets, &mut CpuBackend::new(None)?, &mut |_| true)?;
    let mut gpu = match GpuBackend::new(None) {
        Ok(gpu) => gpu,
        Err(error) => {
            println!("only the CPU: {error}");
            return Ok(());
        }
    };
    let found = render(&scene, &assets, &mut gpu, &mut |_| true)?;
    let color = |frame: &vitrum::Frame| frame.channel("color", "G").map(<[f32]>::to_vec).unwrap_or_default();
    let pairs = color(&expected).into_iter().zip(color(&found));
    let most = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    println!("{} differs from the CPU by {most} at most", gpu.adapter());
    Ok(())
}

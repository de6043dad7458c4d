//! Reads the named outputs of a frame: the depth of the picture's middle, and all outputs as layers of one file.

use std::path::Path;
use vitrum::backend::CpuBackend;
use vitrum::{Assets, builtin, method, render};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut scene = builtin::scene("ball").ok_or("there is a built-in ball")?;
    scene.volume.resolution = Some(48);
    (scene.film.width, scene.film.height) = (96, 96);
    let assets = Assets::load(&scene, Path::new(""))?;
    let frame = render(&scene, &assets, &mut CpuBackend::new(None)?, &mut |_| true)?;
    for output in method::of(scene.method).outputs() {
        println!("{:14} {}", output.name, output.description);
    }
    let directions = frame.channel("direction", "Z").ok_or("every sweep has directions")?;
    println!("the middle ray leaves with a z of {}", directions[48 * 96 + 48]);
    frame.write("ball.exr".as_ref())?;
    Ok(())
}

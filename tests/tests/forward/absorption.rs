//! A homogeneous block in light from the front, from the side and from behind: what its particles send to the camera, against the integral
//! along each viewing ray of their density, what is left of the light that reaches them, and what is left of theirs.

use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::cube;
use vitrum_kernels::glam::DVec3;

use crate::on_both;
use crate::shot::{Cuboid, Shot, vector};

const HALF: f64 = 1.0;
const VOXELS: u32 = 32;
/// Opacity of a layer of thickness 1: an optical depth of 3.2 through the block.
const OPACITY: f64 = 0.8;
/// Steps of the reference's integral.
const STEPS: u32 = 1000;

/// The radiance along a viewing ray, in light of radiance 1 that travels along `light`.
fn radiance(block: Cuboid, from: DVec3, along: DVec3, light: DVec3) -> f64 {
    let extinction = -(1.0 - OPACITY).ln();
    let Some((enters, leaves)) = block.crossing(from, along) else { return 0.0 };
    let step = (leaves - enters) / f64::from(STEPS);
    let at = |index: u32| {
        let way = (f64::from(index) + 0.5) * step;
        let towards = block.crossing(from + along * (enters + way), -light).map_or(0.0, |(_, leaves)| leaves);
        extinction * (-extinction * (way + towards)).exp() * step
    };
    (0..STEPS).map(at).sum()
}

/// The integral of the front face straight on in light along the view: ½(1 − e^(−2τ)).
#[test]
fn the_integral_is_that_of_a_layer() {
    let block = Cuboid::around(DVec3::ZERO, DVec3::splat(HALF));
    let found = radiance(block, DVec3::Y * 3.0, DVec3::NEG_Y, DVec3::NEG_Y);
    let expected = 0.5 * (1.0 - (1.0 - OPACITY).powi(4));
    assert!((found - expected).abs() < 1e-5, "{found} instead of {expected}");
}

/// A step's particles are lit by one light; taken at the step's end it is off by half a step's optical depth along the light, and the error
/// falls with the step. At a quarter of a voxel that is up to 2 %.
#[test]
fn a_block_has_the_radiance_of_light_that_it_absorbs() -> Result<(), Failure> {
    let mut volume = cube(VOXELS, 2.0 * HALF as f32, |_| 1.0);
    volume.range = [0.0, 1.0];
    let block = Cuboid::around(DVec3::ZERO, DVec3::splat(HALF));
    on_both(|backend, held| {
        for angle in [60.0f64, 90.0, 150.0] {
            let (sin, cos) = angle.to_radians().sin_cos();
            let light = DVec3::new(sin, -cos, 0.0);
            let mut errors = Vec::new();
            for sample_distance in [1.0, 0.5, 0.25] {
                let settings = [
                    format!("transfer.opacity=[{{value=1,opacity={OPACITY}}}]"),
                    "transfer.reference_length=1".to_owned(),
                    vector("light.0.direction", light),
                    format!("sweep.sample_distance={sample_distance}"),
                    "sweep.light_resolution=1".to_owned(),
                    "camera.zoom=1.4".to_owned(),
                ];
                let shot = Shot::new(volume.clone(), 32, &settings)?;
                if !shot.takes(light) {
                    println!("{}: light at {angle}° is not taken", backend.name());
                    continue;
                }
                let pixels = shot.render(backend)?;
                let (mut squares, mut expected_squares, mut worst) = (0.0, 0.0, 0.0f64);
                for ((from, along), red) in shot.rays().zip(&pixels.red) {
                    // Not the outline, where a pixel is in the block in part.
                    if block.grown(-0.1).crossing(from, along).is_some() {
                        let expected = radiance(block, from, along, light);
                        squares += (red - expected).powi(2);
                        expected_squares += expected * expected;
                        worst = worst.max((red - expected).abs());
                    }
                }
                let error = (squares / expected_squares).sqrt();
                println!(
                    "{}: light at {angle}°, planes every {sample_distance} voxels: RMSE {error:.2e}, worst {worst:.2e}",
                    backend.name()
                );
                errors.push(error);
            }
            if let [coarse, middle, fine] = errors[..] {
                let order = (coarse / fine).log2() / 2.0;
                println!(
                    "{}: light at {angle}°: order {order:.2} ({:.2}, {:.2})",
                    backend.name(),
                    (coarse / middle).log2(),
                    (middle / fine).log2()
                );
                held.at_most(
                    backend,
                    &format!("radiance of a block in light at {angle}°, planes every quarter voxel, relative RMSE"),
                    fine,
                    0.02,
                );
                // Where the error is small already, roundings and texels need not fall with it.
                if coarse > 0.005 {
                    held.at_most(backend, &format!("lack of an order of 0.8 in light at {angle}°"), 0.8 - order, 0.0);
                }
            }
        }
        Ok(())
    })
}

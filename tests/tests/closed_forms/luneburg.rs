//! 3: the Luneburg lens, η² = 2 − r². A parallel beam meets at the antipode.

use crate::setup::{backends, cube, end, orthographic_frame, refracting, render, start};
use vitrum::scene::{Gradient, Integrator};

fn worst_miss(n: u32, integrator: Integrator, gradient: Gradient, backend: &mut dyn vitrum::backend::Backend) -> f64 {
    let size = 2.2;
    let volume = cube(n, size, |[x, y, z]| (2.0 - (x * x + y * y + z * z)).max(1.0).sqrt());
    let mut scene = refracting(&volume, 32);
    scene.sweep.integrator = integrator;
    scene.sweep.gradient = gradient;
    scene.sweep.sample_distance = 0.5;
    let frame = render(&scene, &volume, backend);
    let (half, centre) = orthographic_frame(f64::from(size));
    let mut worst = 0.0f64;
    for y in 0..32 {
        for x in 0..32 {
            let [sx, sy] = start(&frame, x, y, half);
            // Rays at the rim graze the lens over a long way; the beam's inner 80 % are asked for.
            if sx.hypot(sy) < 0.8 {
                let [ax, ay] = end(&frame, x, y).at_depth(centre - 1.0);
                worst = worst.max(ax.hypot(ay));
            }
        }
    }
    worst
}

#[test]
fn a_parallel_beam_meets_at_the_antipode() {
    for mut backend in backends() {
        for gradient in [Gradient::Central, Gradient::Chain] {
            let coarse = worst_miss(32, Integrator::Symplectic, gradient, backend.as_mut());
            let fine = worst_miss(64, Integrator::Symplectic, gradient, backend.as_mut());
            println!("{} {gradient:?}: miss {coarse:.5} at 32³, {fine:.5} at 64³", backend.name());
            // Trilinear interpolation and central differences are second order in the voxel's edge (1/29 here): a few h².
            assert!(fine < 0.01, "{fine}");
            assert!(fine < coarse * 0.5, "{coarse} to {fine} when the voxels halve");
        }
    }
}

#[test]
fn the_papers_euler_step_misses_by_more() {
    for mut backend in backends() {
        let euler = worst_miss(64, Integrator::Euler, Gradient::Central, backend.as_mut());
        let symplectic = worst_miss(64, Integrator::Symplectic, Gradient::Central, backend.as_mut());
        println!("{}: Euler {euler:.5}, symplectic {symplectic:.5}", backend.name());
        assert!(euler > 3.0 * symplectic, "Euler {euler}, symplectic {symplectic}");
    }
}

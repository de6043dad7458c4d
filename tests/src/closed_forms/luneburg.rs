//! 3: the Luneburg lens, η² = 2 − r². A parallel beam meets at the antipode.

use vitrum::backend::Backend;
use vitrum::scene::{Gradient, Integrator};

use super::table::larger;
use super::{cube, end, orthographic_frame, refracting, render, start};

/// The edge of the volume's cube; the lens has radius 1.
pub const EDGE: f64 = 2.2;

/// Largest distance from the antipode of the rays of the beam's inner 80 %, in a volume of `n`³ voxels.
pub fn worst_miss(n: u32, integrator: Integrator, gradient: Gradient, backend: &mut dyn Backend) -> f64 {
    let size = EDGE as f32;
    let volume = cube(n, size, |[x, y, z]| (2.0 - (x * x + y * y + z * z)).max(1.0).sqrt());
    let mut scene = refracting(&volume, 32);
    scene.sweep.integrator = integrator;
    scene.sweep.gradient = gradient;
    scene.sweep.sample_distance = 0.5;
    let frame = render(&scene, &volume, backend);
    let (half, centre) = orthographic_frame(EDGE);
    let mut worst = 0.0f64;
    for y in 0..32 {
        for x in 0..32 {
            let [sx, sy] = start(&frame, x, y, half);
            // Rays at the rim graze the lens over a long way.
            if sx.hypot(sy) < 0.8 {
                let [ax, ay] = end(&frame, x, y).at_depth(centre - 1.0);
                worst = larger(worst, ax.hypot(ay));
            }
        }
    }
    worst
}

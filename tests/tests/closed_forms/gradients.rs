//! 1, 2 and 5: media whose rays are known curves. η² linear: a parabola; η linear: a catenary; η² parabolic: a sine.
//!
//! A ray enters the cube's face with v = (0, 0, 1) and nothing there bends it, so v_z stays 1 and σ is the depth.

use crate::setup::{backends, cube, end, orthographic_frame, refracting, render, start};

/// The cube's edge.
const EDGE: f64 = 2.0;

/// The largest errors of position and slope behind the cube, for rays that start within 0.6 of the middle.
fn worst(ior: fn(f64) -> f64, truth: fn(f64) -> (f64, f64), backend: &mut dyn vitrum::backend::Backend) -> (f64, f64) {
    // In the picture x points left.
    let volume = cube(64, EDGE as f32, |[x, _, _]| ior(-x));
    let frame = render(&refracting(&volume, 32), &volume, backend);
    let (half, centre) = orthographic_frame(EDGE);
    let mut errors = (0.0f64, 0.0f64);
    for x in 0..32 {
        let [start_x, start_y] = start(&frame, x, 16, half);
        if start_x.abs() < 0.6 {
            let ray = end(&frame, x, 16);
            let (position, slope) = truth(start_x);
            let [found, up] = ray.at_depth(centre - EDGE / 2.0);
            errors.0 = errors.0.max((found - position).abs()).max((up - start_y).abs());
            errors.1 = errors.1.max((ray.direction[0] / -ray.direction[2] - slope).abs());
        }
    }
    errors
}

#[test]
fn rays_are_parabolas_catenaries_and_sines() {
    type Case = (&'static str, fn(f64) -> f64, fn(f64) -> (f64, f64));
    let cases: [Case; 3] = [
        ("parabola", |x| (1.0 + 0.3 * x).sqrt(), |x| (x + 0.5 * 0.15 * EDGE * EDGE, 0.15 * EDGE)),
        (
            "catenary",
            |x| 1.0 + 0.2 * x,
            |x| {
                let angle: f64 = 0.2 * EDGE;
                (((1.0 + 0.2 * x) * angle.cosh() - 1.0) / 0.2, (1.0 + 0.2 * x) * angle.sinh())
            },
        ),
        (
            "sine",
            |x| 1.2 * (1.0 - 0.36 * x * x).sqrt(),
            |x| {
                let frequency: f64 = 1.2 * 0.6;
                (x * (frequency * EDGE).cos(), -x * frequency * (frequency * EDGE).sin())
            },
        ),
    ];
    for mut backend in backends() {
        for (name, ior, truth) in cases {
            let (position, slope) = worst(ior, truth, backend.as_mut());
            println!("{} {name}: position off by {position:.5}, slope by {slope:.5}", backend.name());
            // A voxel is 0.031; second order in it leaves less than a thousandth of the edge.
            assert!(position < 2e-3 && slope < 2e-3, "{name}: {position}, {slope}");
        }
    }
}

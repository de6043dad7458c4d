//! 1, 2 and 5: media whose rays are known curves. η² linear: a parabola; η linear: a catenary; η² parabolic: a sine.
//!
//! The medium fills its cube. A ray meets the cube's face at right angles, so that v = (0, 0, η₀) behind it with the η₀ of that place, and
//! v_z stays η₀: σ is the depth over η₀. At the far face v_x stays and |v| becomes 1.

use vitrum::backend::Backend;
use vitrum::scene::Gradient;

use super::table::larger;
use super::{cube, end, orthographic_frame, refracting, render, start};

/// The cube's edge.
pub const EDGE: f64 = 2.0;

/// A medium whose index of refraction changes along x, with the exact ends of its rays.
pub struct Curve {
    /// The curve's name.
    pub name: &'static str,
    /// The index of refraction at x.
    pub ior: fn(f64) -> f64,
    /// Position and v_x at the far face of a ray that starts at x and comes there at σ.
    truth: fn(f64, f64) -> (f64, f64),
}

impl Curve {
    /// Position and slope behind the cube of a ray that starts at x.
    #[must_use]
    pub fn end(&self, x: f64) -> (f64, f64) {
        let (position, across) = (self.truth)(x, EDGE / (self.ior)(x));
        (position, across / (1.0 - across * across).sqrt())
    }
}

/// η² linear.
pub const PARABOLA: Curve = Curve {
    name: "parabola",
    ior: |x| (1.0 + 0.3 * x).sqrt(),
    truth: |x, sigma| (x + 0.5 * 0.15 * sigma * sigma, 0.15 * sigma),
};

/// η linear.
pub const CATENARY: Curve = Curve {
    name: "catenary",
    ior: |x| 1.0 + 0.2 * x,
    truth: |x, sigma| {
        let (angle, eta) = (0.2 * sigma, 1.0 + 0.2 * x);
        ((eta * angle.cosh() - 1.0) / 0.2, eta * angle.sinh())
    },
};

/// η² parabolic.
pub const SINE: Curve = Curve {
    name: "sine",
    ior: |x| 1.2 * (1.0 - 0.36 * x * x).sqrt(),
    truth: |x, sigma| {
        let frequency: f64 = 1.2 * 0.6;
        (x * (frequency * sigma).cos(), -x * frequency * (frequency * sigma).sin())
    },
};

/// The largest errors of position and slope behind a cube of `n`³ voxels, for rays that start within 0.6 of the middle.
pub fn worst(curve: &Curve, n: u32, gradient: Gradient, backend: &mut dyn Backend) -> (f64, f64) {
    // In the picture x points left.
    let volume = cube(n, EDGE as f32, |[x, _, _]| (curve.ior)(-x));
    let mut scene = refracting(&volume, 32);
    scene.sweep.gradient = gradient;
    let frame = render(&scene, &volume, backend);
    let (half, centre) = orthographic_frame(EDGE);
    let mut errors = (0.0f64, 0.0f64);
    for x in 0..32 {
        let [start_x, start_y] = start(&frame, x, 16, half);
        if start_x.abs() < 0.6 {
            let ray = end(&frame, x, 16);
            let (position, slope) = curve.end(start_x);
            let [found, up] = ray.at_depth(centre - EDGE / 2.0);
            errors.0 = larger(errors.0, larger((found - position).abs(), (up - start_y).abs()));
            errors.1 = larger(errors.1, (ray.direction[0] / -ray.direction[2] - slope).abs());
        }
    }
    errors
}

//! 3: the Luneburg lens with exact gradients: the ray step alone.

use vitrum_kernels::glam::Vec3;
use vitrum_kernels::optics::step::{flight, kick, kick_euler};

/// The point at which a ray at height `h` through a Luneburg lens (R = 1) meets the plane of the antipode, with `steps` planes across.
fn antipode(h: f32, steps: u32, euler: bool) -> f32 {
    let distance = 2.0 / steps as f32;
    let mut x = Vec3::new(h, 0.0, -1.0);
    let mut v = Vec3::new(0.0, 0.0, 1.0);
    for _ in 0..steps {
        let sigma = flight(v, distance);
        x = Vec3::new(x.x + v.x * sigma, x.y + v.y * sigma, x.z + distance);
        let r2 = x.x * x.x + x.y * x.y + x.z * x.z;
        let inside = r2 < 1.0;
        // ½∇(η²) = −x, ∇η = −x/η.
        let acceleration = if inside { x * -1.0 } else { Vec3::ZERO };
        let gradient = if inside { x * (-1.0 / (2.0 - r2).sqrt()) } else { Vec3::ZERO };
        v = if euler {
            kick_euler(v, gradient, distance, 0.01).direction
        } else {
            kick(v, acceleration, sigma, distance, 0.5, 0.01).direction
        };
    }
    x.x
}

/// The largest miss at the antipode of rays at heights 0.1, 0.3 and 0.5.
#[must_use]
pub fn worst_miss(steps: u32, euler: bool) -> f32 {
    [0.1f32, 0.3, 0.5]
        .into_iter()
        .map(|h| antipode(h, steps, euler).abs())
        .fold(0.0, |worst, miss| if miss > worst || miss.is_nan() { miss } else { worst })
}

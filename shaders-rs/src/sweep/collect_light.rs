//! The light of a texel from what the sheets brought and took.

use crate::abi::record::{Light, light, sums};
use crate::abi::sweep::SweepUniforms;
use crate::field::sums::sum;
use crate::math::{max, select};
use spirv_std::glam::Vec3;

/// The light of texel (x, y).
///
/// Where sheets cross, its direction is the mean of their slopes, weighted by their flux.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &SweepUniforms, _mode: u32, changes: &[u32]) -> [f32; light::SIZE] {
    let base = ((y * u.light_grid.width + x) * sums::SIZE as u32) as i32;
    let change = |channel: usize, scale: f32| sum(changes, base + 2 * channel as i32) * (1.0 / scale);
    // Unoccluded light, and what was changed. Rounding must not leave a texel darker than black.
    let red = max(1.0 + change(sums::FLUX, sums::FLUX_SCALE), 0.0);
    let green = max(1.0 + change(sums::FLUX + 1, sums::FLUX_SCALE), 0.0);
    let blue = max(1.0 + change(sums::FLUX + 2, sums::FLUX_SCALE), 0.0);
    let weight = (red + green + blue) * (1.0 / 3.0);
    // Less than a few units of flux tell no direction.
    let inverse = select(weight > 1e-6, 1.0 / max(weight, 1e-6), 0.0);
    let v = u.light.direction;
    let slope_x = change(sums::SLOPE_X, sums::SLOPE_SCALE) * inverse;
    let slope_y = change(sums::SLOPE_X + 1, sums::SLOPE_SCALE) * inverse;
    let light = Light {
        flux: Vec3::new(red, green, blue),
        direction: Vec3::new(v.x + slope_x * v.z, v.y + slope_y * v.z, v.z),
        displacement_x: 0.0,
        displacement_y: 0.0,
        concentration: 1.0,
    };
    light.store()
}

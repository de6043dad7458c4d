//! The length of columns of light that run apart from a point.

use crate::abi::shadow::Spread;
use crate::math::sqrt;

/// The length of the column through (`y`, `z`) of the grid for a unit of depth: 1 over the cosine of its angle to x.
#[inline(always)]
pub fn stretch(spread: &Spread, y: f32, z: f32) -> f32 {
    let (across, up) = (spread.low_y + spread.step * y, spread.low_z + spread.step * z);
    sqrt((1.0 + across * across) + up * up)
}

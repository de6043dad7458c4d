//! Light that nothing has stood in the way of, bent or filtered: the same on all texels.

use super::look_up::shift;
use crate::abi::record::light as record;
use crate::abi::sweep::SweepUniforms;
use crate::math::xyz;

/// The record of unoccluded light.
#[inline(always)]
pub fn light(u: &SweepUniforms) -> [f32; record::SIZE] {
    [1.0, 1.0, 1.0, u.light.direction.x, u.light.direction.y, u.light.direction.z, 0.0, 0.0, 1.0]
}

/// Whether unoccluded light stays on its texel from plane to plane, exactly.
#[inline(always)]
pub fn stays_on_texel(u: &SweepUniforms) -> bool {
    let (x, y) = shift(u, xyz(u.light.direction), u.step.distance);
    (x == 0.0) & (y == 0.0)
}

//! Light that nothing has stood in the way of, bent or filtered: the same on all texels.

use super::look_up::shift;
use crate::abi::record::{Light, light as record};
use crate::abi::sweep::SweepUniforms;
use crate::math::xyz;
use spirv_std::glam::Vec3;

/// The record of unoccluded light.
#[inline(always)]
pub fn light(u: &SweepUniforms) -> [f32; record::SIZE] {
    let light = Light {
        flux: Vec3::new(1.0, 1.0, 1.0),
        direction: xyz(u.light.direction),
        displacement_x: 0.0,
        displacement_y: 0.0,
        concentration: 1.0,
    };
    light.store()
}

/// Whether unoccluded light stays on its texel from plane to plane, exactly.
#[inline(always)]
pub fn stays_on_texel(u: &SweepUniforms) -> bool {
    let (x, y) = shift(u, xyz(u.light.direction), u.step.distance);
    (x == 0.0) & (y == 0.0)
}

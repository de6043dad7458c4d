//! The way after the one that has ended: along the strongest reflection that surfaces behind the first one have sent elsewhere (not in
//! Chang et al. 2010).

use super::ray::Ray;
use super::surface::sum;
use crate::abi::record::{fate, path};
use crate::abi::voxels::{VoxelsUniforms, flag};
use crate::math::normalize;
use spirv_std::glam::Vec3;

pub use super::ray::level;

/// Every ray has ended, or is taken to have.
#[inline(always)]
pub fn level(_x: u32, _y: u32, _u: &VoxelsUniforms, _mode: u32, _before: [f32; path::SIZE]) -> u32 {
    level::WORK
}

/// The ray at the beginning of its next way. One that kept no reflection brings no more light.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    _x: u32,
    _y: u32,
    u: &VoxelsUniforms,
    _mode: u32,
    before: [f32; path::SIZE],
) -> [f32; path::SIZE] {
    let mut ray = Ray::load(&before);
    let none = Vec3::new(0.0, 0.0, 0.0);
    ray.transmittance = ray.kept_transmittance;
    ray.rest = none;
    ray.kept_transmittance = none;
    ray.kept_rest = none;
    if sum(ray.transmittance) > 0.0 {
        ray.position = ray.kept_position;
        ray.direction = normalize(ray.kept_direction);
        ray.last_normal = ray.kept_normal;
        ray.medium = ray.kept_medium;
        ray.since = 0.0;
        ray.bounces = 1.0;
        ray.turn(u);
        ray.status = if u.flags & flag::SEEKS != 0 { fate::SEEKS } else { fate::ACTIVE };
    } else {
        // Its neighbours do not take it for one that goes beside them.
        ray.bounces = 0.0;
        ray.status = fate::LEFT;
    }
    ray.store()
}

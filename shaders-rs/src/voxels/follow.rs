//! The way after the one that has ended: along the strongest reflection that surfaces behind the first one have sent elsewhere (not in
//! Chang et al. 2010).

use super::initialize_rays;
use super::ray::Ray;
use super::surface::sum;
use crate::abi::record::{fate, path};
use crate::abi::voxels::VoxelsUniforms;
use spirv_std::glam::Vec3;

pub use super::ray::level;

/// Every ray has ended, or is taken to have.
#[inline(always)]
pub fn level(_x: u32, _y: u32, _u: &VoxelsUniforms, _mode: u32, _before: [f32; path::SIZE]) -> u32 {
    level::WORK
}

/// The ray at the beginning of its next way, which starts at the eye: up to the surface whose reflection was kept it is the last one. A ray
/// that kept no reflection brings no more light.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &VoxelsUniforms,
    mode: u32,
    before: [f32; path::SIZE],
) -> [f32; path::SIZE] {
    let mut ray = Ray::load(&before);
    if sum(ray.kept) > 0.0 {
        let turns = ray.turns;
        ray = Ray::load(&initialize_rays::invoke(x, y, u, mode));
        ray.turns = turns;
    } else {
        let none = Vec3::new(0.0, 0.0, 0.0);
        ray.transmittance = none;
        ray.rest = none;
        // Its neighbours do not take it for one that goes beside them.
        ray.bounces = 0.0;
        ray.status = fate::LEFT;
    }
    ray.store()
}

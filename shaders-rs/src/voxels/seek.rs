//! Search for the opaque triangle ahead of a ray that marches through voxels (not in Chang et al. 2010).

use super::ray::Ray;
use super::tree;
use crate::abi::record::{fate, path};
use crate::abi::voxels::{STEPS, VoxelsUniforms, mode};

pub use super::ray::level;

/// The level of work: whether the ray seeks.
#[inline(always)]
pub fn level(
    _x: u32,
    _y: u32,
    _u: &VoxelsUniforms,
    _mode: u32,
    before: [f32; path::SIZE],
    _nodes: &[f32],
    _corners: &[f32],
    _materials: &[f32],
) -> u32 {
    let status = Ray::load(&before).status;
    if status == fate::SEEKS {
        level::WORK
    } else if status == fate::ACTIVE {
        level::WAITING
    } else {
        level::ENDED
    }
}

/// The ray after some nodes.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    _x: u32,
    _y: u32,
    _u: &VoxelsUniforms,
    mode: u32,
    before: [f32; path::SIZE],
    nodes: &[f32],
    corners: &[f32],
    materials: &[f32],
) -> [f32; path::SIZE] {
    let mut ray = Ray::load(&before);
    let count = tree::count(nodes);
    let mut step = 0;
    while (step < 4 * STEPS) & (ray.status == fate::SEEKS) {
        step += 1;
        if ray.node < count {
            tree::visit(&mut ray, nodes, corners);
        } else if (mode == mode::TWO_SURFACES) & (ray.bounces >= 2.0) & !ray.has_turned() {
            // There is no third surface.
            ray.end(materials);
        } else {
            ray.status = fate::ACTIVE;
        }
    }
    ray.store()
}

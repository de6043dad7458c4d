//! Viewing rays through the triangles of meshes ([`super::trace`]), one for each pixel.

use super::trace;
use crate::abi::beams::{BeamsUniforms, rays};
use crate::abi::record::pencil;

pub use crate::voxels::ray::level;

/// The level of work: whether the pencil is to be followed in this round.
#[inline(always)]
pub fn level(
    _x: u32,
    _y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    before: [f32; pencil::SIZE],
    _nodes: &[f32],
    _corners: &[f32],
    _materials: &[f32],
) -> u32 {
    trace::level_of(u, &before)
}

/// The pencil after some nodes.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    before: [f32; pencil::SIZE],
    nodes: &[f32],
    corners: &[f32],
    materials: &[f32],
) -> [f32; pencil::SIZE] {
    trace::follow(x, y, u, rays::VIEW, before, nodes, corners, materials)
}

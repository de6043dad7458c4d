//! Empty space: bricks in which all four transfer functions do nothing.

use super::access::read;
use super::stencil::limit_to_grid;
use crate::abi::grid::{BRICK_SHIFT, Grid};
use crate::math::{absolute, floor_to_int, max};
use spirv_std::glam::Vec3;

/// The largest absolute component.
#[inline(always)]
fn largest(v: Vec3) -> f32 {
    max(max(absolute(v.x), absolute(v.y)), absolute(v.z))
}

/// Whether nothing happens on the way from voxel coordinates `from` to `to`: no opacity, no medium, no bending.
///
/// Bricks hold the range of a neighbourhood that reaches `grid.size.w` voxels beyond them, so the answer for `to` covers
/// `from` if it is not farther away than that.
#[inline(always)]
pub fn is_empty(occupancy: &[u32], grid: &Grid, from: Vec3, to: Vec3) -> bool {
    let reach = grid.size.w;
    let inside = limit_to_grid(grid, to);
    let near = largest(to - from) <= reach;
    let outside = largest(to - inside) > reach;
    let brick = |x: f32, size: f32| floor_to_int(x + 0.5, 0.0, size - 1.0) >> BRICK_SHIFT;
    let x = brick(inside.x, grid.size.x);
    let y = brick(inside.y, grid.size.y);
    let z = brick(inside.z, grid.size.z);
    let index = grid.bricks.w + x + grid.bricks.x * (y + grid.bricks.y * z);
    near & (outside | (read(occupancy, index) == 0))
}

//! Empty space: bricks in which all four transfer functions do nothing.

use super::access::read;
use super::stencil::{limit_to_grid, voxel_coordinates};
use crate::abi::grid::{BRICK_SHIFT, Grid};
use crate::abi::sweep::{SweepUniforms, flag};
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

/// Whether nothing happens on the way from `from` to `to` in the sweep frame, in the volume and in the `SECOND` one, if there is
/// one; never, if empty space is not to be skipped.
#[inline(always)]
pub fn step_is_empty<const SECOND: bool>(u: &SweepUniforms, occupancy: &[u32], from: Vec3, to: Vec3) -> bool {
    let shown = is_empty(occupancy, &u.grid, voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    let bending = !SECOND
        || is_empty(occupancy, &u.ior_grid, voxel_coordinates(&u.ior_grid, from), voxel_coordinates(&u.ior_grid, to));
    shown & bending & (u.dispatch.w & flag::SKIP_EMPTY != 0)
}

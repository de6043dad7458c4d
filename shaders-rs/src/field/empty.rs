//! Empty space: bricks in which all four transfer functions do nothing.

use super::access::read;
use super::stencil::{limit_to_grid, voxel_coordinates};
use crate::abi::grid::Grid;
use crate::abi::sweep::{SweepUniforms, flag};
use crate::math::{absolute, floor_to_int, max, min, select};
use spirv_std::glam::Vec3;

/// The largest absolute component.
#[inline(always)]
fn largest(v: Vec3) -> f32 {
    max(max(absolute(v.x), absolute(v.y)), absolute(v.z))
}

/// The word of the brick in which a point of the grid lies.
#[inline(always)]
fn brick_index(grid: &Grid, inside: Vec3) -> i32 {
    let brick = |x: f32, size: f32| floor_to_int(x + 0.5, 0.0, size - 1.0) >> grid.pages.w;
    let x = brick(inside.x, grid.size.x);
    let y = brick(inside.y, grid.size.y);
    let z = brick(inside.z, grid.size.z);
    grid.bricks.w + x + grid.bricks.x * (y + grid.bricks.y * z)
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
    let index = brick_index(grid, inside);
    near & (outside | (read(occupancy, index) != 0))
}

/// How many of the steps behind the one from `from` to `to`, all alike, cross nothing but empty space either: that or fewer.
#[inline(always)]
pub fn empty_steps(occupancy: &[u32], grid: &Grid, from: Vec3, to: Vec3) -> f32 {
    let inside = limit_to_grid(grid, to);
    // Up to there it is outside the grid, and farther than a brick's range reaches.
    let outside = largest(to - inside) - grid.size.w;
    // As many bricks less one are empty on all sides; `to` may be anywhere in its brick.
    let bricks = read(occupancy, brick_index(grid, inside)) as i32 as f32;
    let voxels = max(outside, (bricks - 1.0) * (1 << grid.pages.w) as f32);
    // A little less, for rounding; and no more than can be counted.
    min(max(voxels * 0.99, 0.0) / max(largest(to - from), 1e-6), 65536.0)
}

/// As [`empty_steps`], in the volume and in the `SECOND` one, if there is one.
#[inline(always)]
pub fn steps_are_empty<const SECOND: bool>(u: &SweepUniforms, occupancy: &[u32], from: Vec3, to: Vec3) -> f32 {
    let steps = |grid: &Grid| empty_steps(occupancy, grid, voxel_coordinates(grid, from), voxel_coordinates(grid, to));
    let shown = steps(&u.grid);
    let both = if SECOND { min(shown, steps(&u.ior_grid)) } else { shown };
    let known = select(u.dispatch.w & flag::SKIP_EMPTY != 0, both, 0.0);
    select(u.dispatch.w & flag::BEHIND_VOLUME != 0, f32::MAX, known)
}

/// Whether nothing happens on the way from `from` to `to` in the sweep frame, in the volume and in the `SECOND` one, if there is
/// one: always behind the volumes; elsewhere never, if empty space is not to be skipped.
#[inline(always)]
pub fn step_is_empty<const SECOND: bool>(u: &SweepUniforms, occupancy: &[u32], from: Vec3, to: Vec3) -> bool {
    let shown = is_empty(occupancy, &u.grid, voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    let bending = !SECOND
        || is_empty(occupancy, &u.ior_grid, voxel_coordinates(&u.ior_grid, from), voxel_coordinates(&u.ior_grid, to));
    (u.dispatch.w & flag::BEHIND_VOLUME != 0) | (shown & bending & (u.dispatch.w & flag::SKIP_EMPTY != 0))
}

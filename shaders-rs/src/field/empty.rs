//! Empty space: bricks in which all four transfer functions do nothing.

use super::access::read;
use super::stencil::limit_to_grid;
use crate::abi::grid::Grid;
use crate::math::{absolute, floor_to_int, max, min};
use spirv_std::glam::Vec3;

/// The largest absolute component.
#[inline(always)]
fn largest(v: Vec3) -> f32 {
    max(max(absolute(v.x), absolute(v.y)), absolute(v.z))
}

/// The word of the brick in which a point of the grid lies.
#[inline(always)]
fn brick_index(grid: &Grid, inside: Vec3) -> i32 {
    let brick = |x: f32, size: f32| floor_to_int(x + 0.5, 0.0, size - 1.0) >> grid.brick_shift;
    let x = brick(inside.x, grid.size.x);
    let y = brick(inside.y, grid.size.y);
    let z = brick(inside.z, grid.size.z);
    let (bricks_x, bricks_y) = (grid.bricks.x as i32, grid.bricks.y as i32);
    grid.first_brick as i32 + x + bricks_x * (y + bricks_y * z)
}

/// Whether nothing happens on the way from voxel coordinates `from` to `to`: no opacity, no medium, no bending.
///
/// Bricks hold the range of a neighbourhood that reaches `grid.reach` voxels beyond them, so the answer for `to` covers
/// `from` if it is not farther away than that.
#[inline(always)]
pub fn is_empty(occupancy: &[u32], grid: &Grid, from: Vec3, to: Vec3) -> bool {
    let reach = grid.reach;
    let inside = limit_to_grid(grid, to);
    let near = largest(to - from) <= reach;
    let outside = largest(to - inside) > reach;
    let index = brick_index(grid, inside);
    near & (outside | (read(occupancy, index) != 0))
}

/// What the word of a brick says on the way from voxel coordinates `from` to `to`.
#[derive(Clone, Copy)]
pub struct Told {
    /// The word holds for the whole way, which is no longer than a brick's range reaches.
    pub holds: bool,
    /// The whole way is outside the grid, whatever the word says.
    pub outside: bool,
    /// The word.
    pub word: u32,
}

/// The word of the brick in which `to` lies, or that is nearest.
#[inline(always)]
pub fn told(bricks: &[u32], grid: &Grid, from: Vec3, to: Vec3) -> Told {
    let inside = limit_to_grid(grid, to);
    let holds = largest(to - from) <= grid.reach;
    let outside = holds & (largest(to - inside) > grid.reach);
    Told { holds, outside, word: read(bricks, brick_index(grid, inside)) }
}

/// How many of the steps behind the one from `from` to `to`, all alike, are outside the grid for certain: that or fewer.
#[inline(always)]
pub fn steps_outside(grid: &Grid, from: Vec3, to: Vec3) -> f32 {
    let voxels = largest(to - limit_to_grid(grid, to)) - grid.reach;
    // A little less, for rounding; and no more than can be counted.
    min(max(voxels * 0.99, 0.0) / max(largest(to - from), 1e-6), 65536.0)
}

/// How many of the steps behind the one from `from` to `to`, all alike, cross nothing but empty space either: that or fewer.
#[inline(always)]
pub fn empty_steps(occupancy: &[u32], grid: &Grid, from: Vec3, to: Vec3) -> f32 {
    let inside = limit_to_grid(grid, to);
    // Up to there it is outside the grid, and farther than a brick's range reaches.
    let outside = largest(to - inside) - grid.reach;
    // As many bricks less one are empty on all sides; `to` may be anywhere in its brick.
    let bricks = read(occupancy, brick_index(grid, inside)) as i32 as f32;
    let voxels = max(outside, (bricks - 1.0) * (1 << grid.brick_shift) as f32);
    // A little less, for rounding; and no more than can be counted.
    min(max(voxels * 0.99, 0.0) / max(largest(to - from), 1e-6), 65536.0)
}

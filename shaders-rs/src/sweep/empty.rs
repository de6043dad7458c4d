//! Steps through empty space, in the volume and in the second one.

use crate::abi::format::VoxelFormat;
use crate::abi::grid::Grid;
use crate::abi::sweep::{SweepUniforms, flag};
use crate::field::empty::{empty_steps, is_empty};
use crate::field::stencil::voxel_coordinates;
use crate::math::{min, select};
use spirv_std::glam::Vec3;

/// As [`empty_steps`], in the volume and in the second one, if there is one.
#[inline(always)]
pub fn steps_are_empty<V: VoxelFormat>(u: &SweepUniforms, occupancy: &[u32], from: Vec3, to: Vec3) -> f32 {
    let steps = |grid: &Grid| empty_steps(occupancy, grid, voxel_coordinates(grid, from), voxel_coordinates(grid, to));
    let shown = steps(&u.grid);
    let both = if V::SECOND | V::BODIES { min(shown, steps(&u.ior_grid)) } else { shown };
    let known = select(u.flags & flag::SKIP_EMPTY != 0, both, 0.0);
    select(u.flags & flag::BEHIND_VOLUME != 0, f32::MAX, known)
}

/// Whether nothing happens on the way from `from` to `to` in the view frame, in the volume and in the second one, if there is
/// one: always behind the volumes; elsewhere never, if empty space is not to be skipped.
#[inline(always)]
pub fn step_is_empty<V: VoxelFormat>(u: &SweepUniforms, occupancy: &[u32], from: Vec3, to: Vec3) -> bool {
    let shown = is_empty(occupancy, &u.grid, voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    let second = !(V::SECOND | V::BODIES)
        || is_empty(occupancy, &u.ior_grid, voxel_coordinates(&u.ior_grid, from), voxel_coordinates(&u.ior_grid, to));
    (u.flags & flag::BEHIND_VOLUME != 0) | (shown & second & (u.flags & flag::SKIP_EMPTY != 0))
}

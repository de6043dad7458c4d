//! Opaque bodies within a volume: the share of each voxel that they fill, on a grid of their own, and the reflectance of their surfaces.
//!
//! A body's surface is where its share is [`SURFACE`]; the share falls across the surface, so that its gradient is the surface's normal.

use super::colors::{Tint, factors, mix, share_of_word};
use super::stencil::{Cell, cell, to_view_frame};
use super::voxels::{Rows, words};
use crate::abi::format::VoxelFormat;
use crate::abi::grid::Grid;
use crate::math::{lerp, max};
use spirv_std::glam::Vec3;

/// The share of a voxel at a body's surface.
pub const SURFACE: f32 = 0.5;

/// The share of bodies at voxel coordinates `at`, 0 to 1; beyond the grid, the nearest grid point's.
#[inline(always)]
pub fn share<V: VoxelFormat>(bodies: &[u32], grid: &Grid, at: Vec3) -> f32 {
    let Cell { rows: Rows { columns, y, z }, fraction } = cell::<V>(bodies, grid, at);
    let along_x = |row: i32| {
        let (left, right) = words(bodies, row, &columns);
        lerp(share_of_word(left, 24), share_of_word(right, 24), fraction.x)
    };
    let near = lerp(along_x(z[1] + y[1]), along_x(z[1] + y[2]), fraction.y);
    let far = lerp(along_x(z[2] + y[1]), along_x(z[2] + y[2]), fraction.y);
    lerp(near, far, fraction.z)
}

/// Whether voxel coordinates `at` lie in a body.
#[inline(always)]
pub fn is_in_body<V: VoxelFormat>(bodies: &[u32], grid: &Grid, at: Vec3) -> bool {
    share::<V>(bodies, grid, at) >= SURFACE
}

/// The gradient of the share of bodies at voxel coordinates `at` over world units, in the view frame: central differences over a voxel to each side.
#[inline(always)]
pub fn gradient<V: VoxelFormat>(bodies: &[u32], grid: &Grid, at: Vec3) -> Vec3 {
    let share = |x: f32, y: f32, z: f32| share::<V>(bodies, grid, Vec3::new(at.x + x, at.y + y, at.z + z));
    let x = share(1.0, 0.0, 0.0) - share(-1.0, 0.0, 0.0);
    let y = share(0.0, 1.0, 0.0) - share(0.0, -1.0, 0.0);
    let z = share(0.0, 0.0, 1.0) - share(0.0, 0.0, -1.0);
    to_view_frame(grid, Vec3::new(x * 0.5, y * 0.5, z * 0.5))
}

/// A voxel's reflectance, weighted by the share of bodies, and that share.
#[inline(always)]
fn weighted(word: u32) -> Tint {
    let Tint { color, extinction } = factors(word);
    Tint { color: color * extinction, extinction }
}

/// The diffuse reflectance of the bodies around voxel coordinates `at`, linear RGB, 0 to 1: the mean over the voxels around, weighted by the bodies' shares.
#[inline(always)]
pub fn reflectance<V: VoxelFormat>(bodies: &[u32], grid: &Grid, at: Vec3) -> Vec3 {
    let Cell { rows: Rows { columns, y, z }, fraction } = cell::<V>(bodies, grid, at);
    let along_x = |row: i32| {
        let (left, right) = words(bodies, row, &columns);
        mix(weighted(left), weighted(right), fraction.x)
    };
    let near = mix(along_x(z[1] + y[1]), along_x(z[1] + y[2]), fraction.y);
    let far = mix(along_x(z[2] + y[1]), along_x(z[2] + y[2]), fraction.y);
    let mean = mix(near, far, fraction.z);
    mean.color * (1.0 / max(mean.extinction, 1e-6))
}

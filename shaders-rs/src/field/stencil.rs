//! Trilinear interpolation, alone and with the six neighbours at one voxel's distance.
//!
//! The seven values share one neighbourhood of 32 voxels instead of reading 56.

use super::voxels::{Rows, pair, quad, rows};
use crate::abi::format::VoxelFormat;
use crate::abi::grid::Grid;
use crate::math::{affine, clamp, floor_to_int, lerp, select};
use spirv_std::glam::Vec3;

/// Normalised scalars at a point and at one voxel's distance along each axis.
#[derive(Clone, Copy)]
pub struct Stencil {
    /// At the point.
    pub centre: f32,
    /// At x − 1 and x + 1.
    pub x: (f32, f32),
    /// At y − 1 and y + 1.
    pub y: (f32, f32),
    /// At z − 1 and z + 1.
    pub z: (f32, f32),
}

/// Where a point lies among the voxels.
pub struct Cell {
    /// Where the voxels around it are stored.
    pub rows: Rows,
    /// Its distance from the nearest voxel before it along each axis, 0 to 1.
    pub fraction: Vec3,
}

/// The voxel coordinates of a point of the view frame.
#[inline(always)]
pub fn voxel_coordinates(grid: &Grid, point: Vec3) -> Vec3 {
    Vec3::new(affine(grid.row_x, point), affine(grid.row_y, point), affine(grid.row_z, point))
}

/// The nearest point of the grid's box.
#[inline(always)]
pub fn limit_to_grid(grid: &Grid, at: Vec3) -> Vec3 {
    Vec3::new(
        clamp(at.x, grid.low.x, grid.high.x),
        clamp(at.y, grid.low.y, grid.high.y),
        clamp(at.z, grid.low.z, grid.high.z),
    )
}

/// Where voxel coordinates `at` lie among the voxels; beyond the grid, the nearest grid point.
#[inline(always)]
pub fn cell<V: VoxelFormat>(voxels: &[u32], grid: &Grid, at: Vec3) -> Cell {
    let at = limit_to_grid(grid, at);
    // On a voxel's centre interpolation gives that voxel.
    let at = if grid.nearest != 0 { at_centre(grid, at) } else { at };
    let x = floor_to_int(at.x, -1.0, grid.size.x);
    let y = floor_to_int(at.y, -1.0, grid.size.y);
    let z = floor_to_int(at.z, -1.0, grid.size.z);
    Cell {
        rows: rows::<V>(voxels, grid, x, y, z),
        fraction: Vec3::new(at.x - x as f32, at.y - y as f32, at.z - z as f32),
    }
}

/// The centre of the voxel in which a point of the grid lies.
#[inline(always)]
fn at_centre(grid: &Grid, at: Vec3) -> Vec3 {
    Vec3::new(
        floor_to_int(at.x + 0.5, 0.0, grid.size.x - 1.0) as f32,
        floor_to_int(at.y + 0.5, 0.0, grid.size.y - 1.0) as f32,
        floor_to_int(at.z + 0.5, 0.0, grid.size.z - 1.0) as f32,
    )
}

/// The normalised scalar at the front of a segment whose back has `back`: labels are no numbers, between which others lie, so that a segment has that of its back.
#[inline(always)]
pub fn front_of(grid: &Grid, front: f32, back: f32) -> f32 {
    select(grid.nearest != 0, back, front)
}

/// The normalised scalar at voxel coordinates `at`; beyond the grid, the nearest grid point's scalar.
#[inline(always)]
pub fn scalar<V: VoxelFormat>(voxels: &[u32], grid: &Grid, at: Vec3) -> f32 {
    let Cell { rows: Rows { columns, y, z }, fraction } = cell::<V>(voxels, grid, at);
    let along_x = |row: i32| {
        let (a, b) = pair::<V>(voxels, row, &columns);
        lerp(a, b, fraction.x)
    };
    let near = lerp(along_x(z[1] + y[1]), along_x(z[1] + y[2]), fraction.y);
    let far = lerp(along_x(z[2] + y[1]), along_x(z[2] + y[2]), fraction.y);
    normalised(grid, lerp(near, far, fraction.z))
}

/// The normalised scalars at voxel coordinates `at` and around it.
#[inline(always)]
pub fn stencil<V: VoxelFormat>(voxels: &[u32], grid: &Grid, at: Vec3) -> Stencil {
    let Cell { rows: Rows { columns, y, z }, fraction: f } = cell::<V>(voxels, grid, at);
    // Along x at the four inner rows: (left, centre, right) of the point.
    let inner = |row: i32| {
        let (a, b, c, d) = quad::<V>(voxels, row, &columns);
        (lerp(a, b, f.x), lerp(b, c, f.x), lerp(c, d, f.x))
    };
    let outer = |row: i32| {
        let (a, b) = pair::<V>(voxels, row, &columns);
        lerp(a, b, f.x)
    };
    let (l00, c00, r00) = inner(z[1] + y[1]);
    let (l10, c10, r10) = inner(z[1] + y[2]);
    let (l01, c01, r01) = inner(z[2] + y[1]);
    let (l11, c11, r11) = inner(z[2] + y[2]);
    let (below0, above0) = (outer(z[1] + y[0]), outer(z[1] + y[3]));
    let (below1, above1) = (outer(z[2] + y[0]), outer(z[2] + y[3]));
    let (before0, behind0) = (outer(z[0] + y[1]), outer(z[3] + y[1]));
    let (before1, behind1) = (outer(z[0] + y[2]), outer(z[3] + y[2]));

    let near = lerp(c00, c10, f.y);
    let far = lerp(c01, c11, f.y);
    let left = lerp(lerp(l00, l10, f.y), lerp(l01, l11, f.y), f.z);
    let right = lerp(lerp(r00, r10, f.y), lerp(r01, r11, f.y), f.z);
    let below = lerp(lerp(below0, c00, f.y), lerp(below1, c01, f.y), f.z);
    let above = lerp(lerp(c10, above0, f.y), lerp(c11, above1, f.y), f.z);
    let before = lerp(lerp(before0, before1, f.y), near, f.z);
    let behind = lerp(far, lerp(behind0, behind1, f.y), f.z);
    Stencil {
        centre: normalised(grid, lerp(near, far, f.z)),
        x: (normalised(grid, left), normalised(grid, right)),
        y: (normalised(grid, below), normalised(grid, above)),
        z: (normalised(grid, before), normalised(grid, behind)),
    }
}

/// Normalised scalars are no further from 0: differences of such numbers and their squares are finite.
const FARTHEST: f32 = 1e9;

/// The normalised scalar of a stored value, as a [`Grid`] has its `value_origin` and `value_scale`.
#[inline(always)]
pub fn normalise(stored: f32, origin: f32, scale: f32) -> f32 {
    clamp((stored - origin) * scale, -FARTHEST, FARTHEST)
}

#[inline(always)]
fn normalised(grid: &Grid, stored: f32) -> f32 {
    normalise(stored, grid.value_origin, grid.value_scale)
}

/// A gradient over voxel coordinates, turned into the view frame (per world unit).
#[inline(always)]
pub fn to_view_frame(grid: &Grid, gradient: Vec3) -> Vec3 {
    let (x, y, z) = (grid.row_x.factors, grid.row_y.factors, grid.row_z.factors);
    Vec3::new(
        (x.x * gradient.x + y.x * gradient.y) + z.x * gradient.z,
        (x.y * gradient.x + y.y * gradient.y) + z.y * gradient.z,
        (x.z * gradient.x + y.z * gradient.y) + z.z * gradient.z,
    )
}

/// Central differences of the scalar over voxel coordinates.
#[inline(always)]
pub fn central_differences(s: &Stencil) -> Vec3 {
    Vec3::new(0.5 * (s.x.1 - s.x.0), 0.5 * (s.y.1 - s.y.0), 0.5 * (s.z.1 - s.z.0))
}

//! Where columns of the grid go through the surface.
//!
//! A column is a line along x through a point between voxels' faces; through each voxel go as many as the host asks for. Whether one
//! goes through a triangle is decided by the triangle's edges alone: an edge counts if one of its ends lies at or below the
//! column's z and the other above, and then by where it passes the column, which is computed from its lower to its upper end. Two
//! triangles with a common edge compute the same bits, so that no column slips through between them and none is counted twice.

use super::item_of;
use crate::abi::voxelize::VoxelizeUniforms;
use crate::field::access::read;
use crate::field::sums::Sums;
use crate::math::{clamp, floor_to_int, max, min, select};
use spirv_std::glam::Vec3;

/// Where an edge passes a z.
#[derive(Clone, Copy)]
struct Passage {
    up: bool,
    down: bool,
    x: f32,
    y: f32,
}

#[inline(always)]
fn pass(a: Vec3, b: Vec3, z: f32) -> Passage {
    let up = (a.z <= z) & (b.z > z);
    let down = (b.z <= z) & (a.z > z);
    let (low_x, high_x) = (select(up, a.x, b.x), select(up, b.x, a.x));
    let (low_y, high_y) = (select(up, a.y, b.y), select(up, b.y, a.y));
    let (low_z, high_z) = (select(up, a.z, b.z), select(up, b.z, a.z));
    let t = (z - low_z) / select(up | down, high_z - low_z, 1.0);
    Passage { up, down, x: low_x + (high_x - low_x) * t, y: low_y + (high_y - low_y) * t }
}

/// The one of three that is `true` has its value taken; at most one is.
#[inline(always)]
fn only(a: bool, b: bool, a_value: f32, b_value: f32, c_value: f32) -> f32 {
    select(a, a_value, select(b, b_value, c_value))
}

/// The number of columns before `y`.
#[inline(always)]
fn columns_before(y: f32, a_voxel: f32, most: f32) -> i32 {
    -floor_to_int(-(y * a_voxel - 0.5), -most, 0.0)
}

#[inline(always)]
fn corner(corners: &[f32], at: i32) -> Vec3 {
    Vec3::new(read(corners, at), read(corners, at + 1), read(corners, at + 2))
}

/// Does item y · width + x: for each column and each voxel along it, by how much more of it is inside than of the voxel before, in
/// units. Behind each row's voxels is a place for what is beyond the grid.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &VoxelizeUniforms,
    _mode: u32,
    corners: &[f32],
    items: &[u32],
    changes: &mut S,
) {
    let item = item_of(x, y, u, items);
    let at = item.triangle * 9;
    let (a, b, c) = (corner(corners, at), corner(corners, at + 3), corner(corners, at + 6));
    let shift = u.columns.x;
    let a_voxel = (1u32 << shift) as f32;
    let spacing = 1.0 / a_voxel;
    let units = (1u32 << u.columns.z) as f32;
    let length = u.size.x as f32;
    let mut line = item.first;
    while line < item.end {
        let z = (line as f32 + 0.5) * spacing;
        let (p, q, r) = (pass(a, b, z), pass(b, c, z), pass(c, a, z));
        if p.up | q.up | r.up {
            let (up_x, up_y) = (only(p.up, q.up, p.x, q.x, r.x), only(p.up, q.up, p.y, q.y, r.y));
            let (down_x, down_y) = (only(p.down, q.down, p.x, q.x, r.x), only(p.down, q.down, p.y, q.y, r.y));
            let most = u.size.y as f32 * a_voxel;
            let end = columns_before(max(up_y, down_y), a_voxel, most);
            let mut column = columns_before(min(up_y, down_y), a_voxel, most);
            // Seen from +x a triangle that faces there runs counterclockwise: its edge to the right goes up, and the column leaves.
            let leaves = up_y > down_y;
            let inverse = 1.0 / select(up_y == down_y, 1.0, up_y - down_y);
            let layer = (line >> shift) - u.columns.y as i32;
            while column < end {
                let t = clamp(((column as f32 + 0.5) * spacing - down_y) * inverse, 0.0, 1.0);
                let x = clamp(down_x + (up_x - down_x) * t, 0.0, length);
                let voxel = floor_to_int(x, 0.0, length - 1.0);
                let whole = floor_to_int(units, 0.0, 65536.0);
                // Of the voxel itself what lies behind the surface changes, of those behind it everything.
                let before = floor_to_int((x - voxel as f32) * units + 0.5, 0.0, units);
                let behind = whole - before;
                let row = layer * u.size.y as i32 + (column >> shift);
                let index = (row * u.size.w as i32 + voxel) as usize;
                let (first, second) = if leaves { (-behind, -before) } else { (behind, before) };
                if first != 0 {
                    changes.add(index, first as u32);
                }
                if second != 0 {
                    changes.add(index + 1, second as u32);
                }
                column += 1;
            }
        }
        line += 1;
    }
}

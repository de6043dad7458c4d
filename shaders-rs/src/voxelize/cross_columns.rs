//! Crossings of columns of the grid with the surface, for solid voxelization (not in Chang et al. 2010).
//!
//! A column is a line along x through a point between voxels' faces; through each voxel go as many as the host asks for.

use super::columns::{columns_before, cross, depth};
use super::item_of;
use crate::abi::voxelize::VoxelizeUniforms;
use crate::field::access::read;
use crate::field::sums::Sums;
use crate::math::{clamp, floor_to_int};
use spirv_std::glam::Vec3;

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
    let shift = u.column_shift;
    let a_voxel = (1u32 << shift) as f32;
    let spacing = 1.0 / a_voxel;
    let units = (1u32 << u.column_units) as f32;
    let length = u.size.x as f32;
    let mut line = item.first;
    while line < item.end {
        let z = (line as f32 + 0.5) * spacing;
        let across = cross(a, b, c, z);
        if across.crosses {
            let most = u.size.y as f32 * a_voxel;
            let end = columns_before(across.high_y, a_voxel, most);
            let mut column = columns_before(across.low_y, a_voxel, most);
            let layer = (line >> shift) - u.first_layer as i32;
            while column < end {
                let place = across.at((column as f32 + 0.5) * spacing);
                let x = clamp(depth(place, length, u.divergence), 0.0, length);
                let voxel = floor_to_int(x, 0.0, length - 1.0);
                let whole = floor_to_int(units, 0.0, 65536.0);
                // Of the voxel itself what lies behind the surface changes, of those behind it everything.
                let before = floor_to_int((x - voxel as f32) * units + 0.5, 0.0, units);
                let behind = whole - before;
                let row = layer * u.size.y as i32 + (column >> shift);
                let index = (row * u.row_words as i32 + voxel) as usize;
                let (first, second) = if across.leaves { (-behind, -before) } else { (behind, before) };
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

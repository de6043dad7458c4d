//! Sets the bits of the voxels that triangles meet.

use super::overlap::overlap;
use super::{Item, item_of};
use crate::abi::voxelize::{VoxelizeUniforms, triangle};
use crate::field::access::read;
use crate::field::sums::Sums;

/// Does item y · width + x: a bit for each voxel, 32 along x in a word.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &VoxelizeUniforms,
    _mode: u32,
    triangles: &[u32],
    items: &[u32],
    mask: &mut S,
) {
    let item = item_of(x, y, u, items);
    if item.first < item.end {
        let base = item.triangle * triangle::SIZE as i32;
        let whole = |at: usize| read(triangles, base + at as i32) as i32;
        if (whole(triangle::LAST) | whole(triangle::LAST + 1) | whole(triangle::LAST + 2)) == 0 {
            // It lies within one voxel.
            let line = whole(triangle::FIRST + 2) * u.size.y as i32 + whole(triangle::FIRST + 1);
            let x = whole(triangle::FIRST);
            mask.set((line * u.size.w as i32 + (x >> 5)) as usize, 1 << (x & 31) as u32);
        } else {
            mark_slices(u, triangles, item, mask);
        }
    }
}

/// Marks what the slices of an item meet.
#[inline(always)]
fn mark_slices<S: Sums + ?Sized>(u: &VoxelizeUniforms, triangles: &[u32], item: Item, mask: &mut S) {
    let overlap = overlap(triangles, item.triangle);
    let mut slice = item.first;
    while slice < item.end {
        let rows = overlap.rows(slice);
        let mut row = rows.first;
        while row <= rows.last {
            let y = if overlap.slices_are_layers { row } else { slice };
            let z = if overlap.slices_are_layers { slice } else { row };
            let span = overlap.voxels(y, z);
            if span.first <= span.last {
                let line = (overlap.first_z + z) * u.size.y as i32 + overlap.first_y + y;
                let base = line * u.size.w as i32;
                let (first, last) = (overlap.first_x + span.first, overlap.first_x + span.last);
                let mut word = first >> 5;
                while word <= last >> 5 {
                    let from = if word == first >> 5 { u32::MAX << (first & 31) as u32 } else { u32::MAX };
                    let to = if word == last >> 5 { u32::MAX >> (31 - (last & 31)) as u32 } else { u32::MAX };
                    mask.set((base + word) as usize, from & to);
                    word += 1;
                }
            }
            row += 1;
        }
        slice += 1;
    }
}

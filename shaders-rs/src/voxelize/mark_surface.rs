//! Sets the bits of the voxels that triangles meet.

use super::item_of;
use super::overlap::overlap;
use crate::abi::voxelize::VoxelizeUniforms;
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
}

//! Surface voxelization: sets the bits of the voxels that triangles meet (Chang et al. 2010, §2 and Fig. 1; the test of overlap:
//! Schwarz & Seidel 2010).

use super::overlap::{Overlap, shape, shape_of};
use super::place::Place;
use super::{Item, piece_of};
use crate::abi::voxelize::VoxelizeUniforms;
use crate::field::sums::Sums;

/// Does piece of work y · width + x: a bit for each voxel, 32 along x in a word.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &VoxelizeUniforms,
    mode: u32,
    corners: &[u32],
    items: &[u32],
    mask: &mut S,
) {
    let (item, place) = piece_of(x, y, u, mode, corners, items);
    if item.first < item.end {
        let shape = shape_of(&place);
        if shape == shape::ROW {
            mark::<{ shape::ROW }, S>(u, &place, item, mask);
        } else if shape == shape::FLAT_X {
            mark::<{ shape::FLAT_X }, S>(u, &place, item, mask);
        } else if shape == shape::FLAT_Y {
            mark::<{ shape::FLAT_Y }, S>(u, &place, item, mask);
        } else if shape == shape::FLAT_Z {
            mark::<{ shape::FLAT_Z }, S>(u, &place, item, mask);
        } else {
            mark::<{ shape::THICK }, S>(u, &place, item, mask);
        }
    }
}

/// Marks the voxels that the slices of an item meet.
#[inline(always)]
fn mark<const SHAPE: u32, S: Sums + ?Sized>(u: &VoxelizeUniforms, place: &Place, item: Item, mask: &mut S) {
    let overlap = Overlap::<SHAPE>::new(place);
    let layers = place.slices_are_layers();
    let mut slice = item.first;
    while slice < item.end {
        let rows = overlap.rows(slice);
        let mut row = rows.first;
        while row <= rows.last {
            let (y, z) = if layers { (row, slice) } else { (slice, row) };
            let span = overlap.voxels(y, z);
            if span.first <= span.last {
                let line = (place.first.z + z) * u.size.y as i32 + place.first.y + y;
                let base = line * u.row_words as i32;
                let (first, last) = (place.first.x + span.first, place.first.x + span.last);
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

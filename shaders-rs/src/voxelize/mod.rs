//! Triangles to voxels (Chang et al. 2010, §2).
//!
//! The paper cuts each triangle into the slices of the grid that it may meet, and draws each piece. So do these kernels: an
//! invocation has a triangle and some of its slices, so that large triangles are shared by many invocations. [`mark_surface`] sets
//! the bit of every voxel that a triangle meets, [`sum_attributes`] sums up what they bring there.
//!
//! Solids are not in the paper: [`cross_columns`] notes where columns of the grid go through the surface, [`fill_rows`] follows
//! them from end to end.
//!
//! What several invocations write is in integers and does not depend on their order.

pub mod columns;
pub mod cross_columns;
pub mod fill_rows;
pub mod mark_surface;
pub mod overlap;
pub mod place;
pub mod sum_attributes;

use crate::abi::voxelize::{VoxelizeUniforms, item, pieces};
use crate::field::access::read;
use place::Place;

/// A triangle, and which of its slices are to be done.
#[derive(Clone, Copy)]
pub struct Item {
    /// The triangle.
    pub triangle: i32,
    /// The first slice.
    pub first: i32,
    /// The slice behind the last one; not beyond `first` if there is nothing to do.
    pub end: i32,
}

/// The item of invocation (x, y); one without slices if there are no more items.
#[inline(always)]
pub fn item_of(x: u32, y: u32, u: &VoxelizeUniforms, items: &[u32]) -> Item {
    item_at(y * u.dispatch.width + x, u.work, items)
}

/// Item number `index` out of `all`; one without slices if there are not so many.
#[inline(always)]
pub fn item_at(index: u32, all: u32, items: &[u32]) -> Item {
    let at = (index * item::SIZE as u32) as i32;
    let first = read(items, at + item::FIRST as i32) as i32;
    let count = if index < all { read(items, at + item::COUNT as i32) as i32 } else { 0 };
    Item { triangle: read(items, at + item::TRIANGLE as i32) as i32, first, end: first + count }
}

/// The piece of work of invocation (x, y) on the surface, by mode (see [`pieces`]), and where its triangle lies.
#[inline(always)]
pub fn piece_of(x: u32, y: u32, u: &VoxelizeUniforms, mode: u32, corners: &[u32], items: &[u32]) -> (Item, Place) {
    if mode == pieces::TRIANGLES {
        let index = y * u.dispatch.width + x;
        let place = Place::of(u, corners, index as i32);
        let is_here = (index < u.work) & place.is_small();
        (Item { triangle: index as i32, first: 0, end: if is_here { place.slices() } else { 0 } }, place)
    } else {
        let item = item_of(x, y, u, items);
        let item = Item { triangle: item.triangle + u.first_triangle as i32, ..item };
        (item, Place::of(u, corners, item.triangle))
    }
}

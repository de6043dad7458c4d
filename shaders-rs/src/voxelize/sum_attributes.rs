//! Attributes of the surface's voxels: the number of triangles that meet a voxel, and the sums of their normals, colours and materials
//! (Chang et al. 2010, §2).
//!
//! As in the paper each triangle counts once in a voxel, whatever the size of its part there. Normal and colour are those of the
//! triangle's point whose barycentric coordinates are the voxel centre's, negative ones raised to 0.

use super::overlap::{Overlap, shape, shape_of};
use super::place::Place;
use super::{Item, piece_of};
use crate::abi::record::attributes;
use crate::abi::voxelize::{VoxelizeUniforms, brought};
use crate::field::access::{read, read_vector};
use crate::field::sums::{Sums, add, quantise};
use crate::math::{dot, floor_to_int, length, max, min, select};
use spirv_std::glam::Vec3;

/// The number of bits that are set in `mask` before bit `bit` of the word at `word`; `ranks` has those before each word.
#[inline(always)]
fn rank(mask: &[u32], ranks: &[u32], word: i32, bit: u32) -> i32 {
    (read(ranks, word) + (read(mask, word) & ((1 << bit) - 1)).count_ones()) as i32
}

/// Weights of a triangle's corners.
#[inline(always)]
fn weights(from_a: Vec3, e: Vec3, f: Vec3) -> Vec3 {
    let (ee, ef, ff) = (dot(e, e), dot(e, f), dot(f, f));
    let (pe, pf) = (dot(from_a, e), dot(from_a, f));
    let area = ee * ff - ef * ef;
    let inverse = select(area > 0.0, 1.0 / select(area > 0.0, area, 1.0), 0.0);
    let b = (ff * pe - ef * pf) * inverse;
    let c = (ee * pf - ef * pe) * inverse;
    // Numbers beyond that are of triangles that are nearly lines.
    let limited = |w: f32| min(max(w, 0.0), 16_777_216.0);
    let (a, b, c) = (limited(1.0 - b - c), limited(b), limited(c));
    let inverse = 1.0 / max((a + b) + c, 0.5);
    Vec3::new(a * inverse, b * inverse, c * inverse)
}

/// The vectors of a triangle's corners, from `at` on, by their weights.
#[inline(always)]
fn mean(brought: &[f32], at: i32, weights: Vec3) -> Vec3 {
    let (a, b, c) = (read_vector(brought, at), read_vector(brought, at + 3), read_vector(brought, at + 6));
    Vec3::new(
        (a.x * weights.x + b.x * weights.y) + c.x * weights.z,
        (a.y * weights.x + b.y * weights.y) + c.y * weights.z,
        (a.z * weights.x + b.z * weights.y) + c.z * weights.z,
    )
}

#[inline(always)]
fn add_vector<S: Sums + ?Sized>(sums: &mut S, at: i32, vector: Vec3) {
    add(sums, at, quantise(vector.x, attributes::SCALE));
    add(sums, at + 2, quantise(vector.y, attributes::SCALE));
    add(sums, at + 4, quantise(vector.z, attributes::SCALE));
}

/// Does piece of work y · width + x. The voxels of `mask` have a place each, in their order.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &VoxelizeUniforms,
    mode: u32,
    corners: &[u32],
    items: &[u32],
    brought: &[f32],
    mask: &[u32],
    ranks: &[u32],
    sums: &mut S,
) {
    let (item, place) = piece_of(x, y, u, mode, corners, items);
    if item.first < item.end {
        let shape = shape_of(&place);
        if shape == shape::ROW {
            add_slices::<{ shape::ROW }, S>(u, &place, item, brought, mask, ranks, sums);
        } else if shape == shape::FLAT_X {
            add_slices::<{ shape::FLAT_X }, S>(u, &place, item, brought, mask, ranks, sums);
        } else if shape == shape::FLAT_Y {
            add_slices::<{ shape::FLAT_Y }, S>(u, &place, item, brought, mask, ranks, sums);
        } else if shape == shape::FLAT_Z {
            add_slices::<{ shape::FLAT_Z }, S>(u, &place, item, brought, mask, ranks, sums);
        } else {
            add_slices::<{ shape::THICK }, S>(u, &place, item, brought, mask, ranks, sums);
        }
    }
}

/// Adds what a triangle brings to the voxels that the slices of an item meet: the same as [`super::mark_surface`] marks.
#[inline(always)]
fn add_slices<const SHAPE: u32, S: Sums + ?Sized>(
    u: &VoxelizeUniforms,
    place: &Place,
    item: Item,
    brought: &[f32],
    mask: &[u32],
    ranks: &[u32],
    sums: &mut S,
) {
    let overlap = Overlap::<SHAPE>::new(place);
    let layers = place.slices_are_layers();
    let (a, b, c) = place.corners();
    let (e, f) = (b - a, c - a);
    let from = item.triangle * brought::SIZE as i32;
    let material = floor_to_int(read(brought, from + brought::MATERIAL as i32), 0.0, 16_777_216.0) as u32;
    let mut slice = item.first;
    while slice < item.end {
        let rows = overlap.rows(slice);
        let mut row = rows.first;
        while row <= rows.last {
            let (y, z) = if layers { (row, slice) } else { (slice, row) };
            let span = overlap.voxels(y, z);
            let base = ((place.first.z + z) * u.size.y as i32 + place.first.y + y) * u.row_words as i32;
            let mut x = span.first;
            while x <= span.last {
                let centre = Vec3::new(x as f32 + 0.5, y as f32 + 0.5, z as f32 + 0.5);
                let weights = weights(centre - a, e, f);
                let normal = mean(brought, from + brought::NORMALS as i32, weights);
                let size = length(normal);
                // Opposite normals of two corners may leave none.
                let scale = select(size > 1e-6, 1.0 / max(size, 1e-6), 0.0);
                let color = mean(brought, from + brought::COLORS as i32, weights);
                let column = place.first.x + x;
                let rank = rank(mask, ranks, base + (column >> 5), (column & 31) as u32);
                let at = rank * attributes::SIZE as i32;
                sums.add((at + attributes::COUNT as i32) as usize, 1);
                sums.raise((at + attributes::MATERIAL as i32) as usize, material);
                add_vector(sums, at + attributes::NORMAL as i32, normal * scale);
                add_vector(sums, at + attributes::COLOR as i32, color);
                x += 1;
            }
            row += 1;
        }
        slice += 1;
    }
}

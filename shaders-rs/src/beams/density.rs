//! The density of the medium: a factor on its coefficients, from a volume, or 1 everywhere. The volume's values stand behind the records of materials.

use super::medium::inside;
use crate::abi::beams::Medium;
use crate::field::access::read;
use crate::math::{clamp, floor_to_int, limit, max, xyz};
use spirv_std::glam::Vec3;

/// Distance between the two points of Gauss and Legendre in an interval of length 1 and its middle.
const POINT: f32 = 0.288_675_14;

/// The density at a position in the medium's box, interpolated between the middles of voxels.
#[inline(always)]
pub fn density_at(medium: &Medium, materials: &[f32], position: Vec3) -> f32 {
    let (columns, rows, layers) = (medium.columns as i32, medium.rows as i32, medium.layers as i32);
    let (low, high) = (xyz(medium.low), xyz(medium.high));
    // The coordinate along an axis, from the middle of the first voxel on, limited to the middles of the outer ones.
    let coordinate = |x: f32, low: f32, high: f32, count: i32| {
        let count = count as f32;
        clamp((x - low) / (high - low) * count - 0.5, 0.0, count - 1.0)
    };
    let x = coordinate(position.x, low.x, high.x, columns);
    let y = coordinate(position.y, low.y, high.y, rows);
    let z = coordinate(position.z, low.z, high.z, layers);
    let (i, j, k) = (floor_to_int(x, 0.0, 1e6), floor_to_int(y, 0.0, 1e6), floor_to_int(z, 0.0, 1e6));
    let (fx, fy, fz) = (x - i as f32, y - j as f32, z - k as f32);
    let next = limit(i + 1, columns) - i;
    let below = (limit(j + 1, rows) - j) * columns;
    let behind = (limit(k + 1, layers) - k) * columns * rows;
    let at = medium.first as i32 + (k * rows + j) * columns + i;
    let along = |at: i32| read(materials, at) * (1.0 - fx) + read(materials, at + next) * fx;
    let front = along(at) * (1.0 - fy) + along(at + below) * fy;
    let back = along(at + behind) * (1.0 - fy) + along(at + behind + below) * fy;
    front * (1.0 - fz) + back * fz
}

/// The integral of the density over a part of a line that lies in the medium, by the two points of Gauss and Legendre.
#[inline(always)]
pub fn over_part(medium: &Medium, materials: &[f32], from: Vec3, direction: Vec3, near: f32, far: f32) -> f32 {
    let (middle, length) = (0.5 * (near + far), far - near);
    let first = density_at(medium, materials, from + direction * (middle - POINT * length));
    let second = density_at(medium, materials, from + direction * (middle + POINT * length));
    0.5 * (first + second) * length
}

/// The optical depth, over the extinction coefficient where the density is 1, of a part of a line that lies in the medium: the integral of the density,
/// in voxels.
#[inline(always)]
pub fn depth_within(medium: &Medium, materials: &[f32], from: Vec3, direction: Vec3, near: f32, far: f32) -> f32 {
    let length = far - near;
    if medium.nodes == 0 {
        return length;
    }
    let step = length / medium.nodes as f32;
    let mut sum = 0.0;
    let mut node = 0;
    while (node < medium.nodes) & (length > 0.0) {
        let begin = near + step * node as f32;
        sum += over_part(medium, materials, from, direction, begin, begin + step);
        node += 1;
    }
    sum
}

/// The optical depth, over the extinction coefficient where the density is 1, of the line from `from` along the unit vector `direction` between the
/// distances `near` and `far`: the integral of the density where it is in the medium, in voxels.
#[inline(always)]
pub fn optical_depth(medium: &Medium, materials: &[f32], from: Vec3, direction: Vec3, near: f32, far: f32) -> f32 {
    let fog = inside(medium, from, direction, near, far);
    depth_within(medium, materials, from, direction, fog.enters, fog.leaves)
}

/// The optical depth at a place of a straight piece, which is at the share `share` of it, 0 to 1: between nodes it is in proportion. The piece is number
/// `number` of `count`; optical depths begin at float `first`.
#[inline(always)]
pub fn depth_on_piece(medium: &Medium, depths: &[f32], first: i32, number: i32, count: i32, share: f32) -> f32 {
    let nodes = medium.nodes as f32;
    let at = clamp(share, 0.0, 1.0) * nodes;
    let node = floor_to_int(at, 0.0, max(nodes - 1.0, 0.0));
    // Node 0 is where the piece begins.
    let depth = |node: i32| read(depths, first + node * count + number);
    let before = if node > 0 { depth(node - 1) } else { 0.0 };
    before + (depth(node) - before) * (at - node as f32)
}

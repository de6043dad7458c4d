//! Intersections of lines along x with a triangle.
//!
//! Whether one does is decided by the triangle's edges alone: an edge counts if one of its ends lies at or below the line's z and the
//! other above, and then by where it passes the line, which is computed from its lower to its upper end. Two triangles with a
//! common edge compute the same bits, so that no line slips through between them and none is counted twice.

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

/// The intersection of a triangle with a plane across z.
#[derive(Clone, Copy)]
pub struct Line {
    /// Whether it has any of it.
    pub crosses: bool,
    /// Whether a line towards +x goes out through the triangle: its edge on the right goes up.
    pub leaves: bool,
    /// From this y…
    pub low_y: f32,
    /// … to this one.
    pub high_y: f32,
    down_x: f32,
    down_y: f32,
    up_x: f32,
    inverse: f32,
}

impl Line {
    /// The x at `y`, which may lie a little beyond the ends.
    #[inline(always)]
    pub fn at(&self, y: f32) -> f32 {
        let t = clamp((y - self.down_y) * self.inverse, 0.0, 1.0);
        self.down_x + (self.up_x - self.down_x) * t
    }
}

/// The intersection of triangle `a`, `b`, `c` with the plane at `z`.
#[inline(always)]
pub fn cross(a: Vec3, b: Vec3, c: Vec3, z: f32) -> Line {
    let (p, q, r) = (pass(a, b, z), pass(b, c, z), pass(c, a, z));
    let (up_x, up_y) = (only(p.up, q.up, p.x, q.x, r.x), only(p.up, q.up, p.y, q.y, r.y));
    let (down_x, down_y) = (only(p.down, q.down, p.x, q.x, r.x), only(p.down, q.down, p.y, q.y, r.y));
    Line {
        crosses: p.up | q.up | r.up,
        // Seen from +x a triangle that faces there runs counterclockwise: its edge to the right goes up, and the column leaves.
        leaves: up_y > down_y,
        low_y: min(up_y, down_y),
        high_y: max(up_y, down_y),
        down_x,
        down_y,
        up_x,
        inverse: 1.0 / select(up_y == down_y, 1.0, up_y - down_y),
    }
}

/// The number of columns before `y`, of which `a_voxel` go through a voxel.
#[inline(always)]
pub fn columns_before(y: f32, a_voxel: f32, most: f32) -> i32 {
    -floor_to_int(-(y * a_voxel - 0.5), -most, 0.0)
}

/// The depth, in voxels, of a `place` along a column of `length` voxels; both count from the grid's front.
///
/// Columns of light that run apart from a point are made parallel to x by a projective map, which keeps triangles what they are: a vertex at
/// depth d from the point goes to y / d and z / d, and to a place along x that is linear in 1 / d. Voxels, however, are as deep everywhere.
/// `divergence` is a voxel's edge over the distance from the point to the grid's front; where it is 0, columns have been parallel, and
/// place and depth are the same to the last bit.
#[inline(always)]
pub fn depth(place: f32, length: f32, divergence: f32) -> f32 {
    place / (1.0 + divergence * (length - place))
}

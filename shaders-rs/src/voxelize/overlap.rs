//! Whether a triangle meets a box: the separating axes of Akenine-Möller 2001 in the form of Schwarz & Seidel 2010.
//!
//! A box and a triangle are apart if one of the triangle's plane, the edges of its projections along x, y and z, and the box's faces
//! lies between them. Each is a linear condition on the box's place, and boxes are all of one size: for a row of voxels along x the
//! conditions leave a span, which is found without looking at each voxel.
//!
//! No voxel that a triangle meets is missed. Corners and edges are exact (see [`crate::abi::voxelize::triangle`]); what products, sums
//! and quotients are off by is less than the margin by which the host enlarges voxels, 2⁻¹⁹ of the triangle's extent, except in what
//! follows from a normal of a triangle that is nearly a line. For that, conditions are loosened by the normal's own error.

use crate::abi::voxelize::triangle;
use crate::field::access::read;
use crate::math::{absolute, floor_to_int, max, min, select};
use spirv_std::glam::Vec3;

/// Relative error of a difference of two products of exact numbers, with room to spare: 2⁻²².
const ERROR: f32 = 1.0 / 4_194_304.0;

/// Where a span begins and ends.
#[derive(Clone, Copy)]
pub struct Span {
    /// The first voxel.
    pub first: i32,
    /// The last voxel, before the first if there is none.
    pub last: i32,
}

/// along · s + across · t + rest ≥ 0.
#[derive(Clone, Copy)]
struct Condition {
    along: f32,
    across: f32,
    rest: f32,
    /// 1 / along; 1 where that is 0.
    inverse: f32,
}

/// A triangle's conditions.
#[derive(Clone, Copy)]
pub struct Overlap {
    /// The first voxel along x, y, z.
    pub first_x: i32,
    /// See `first_x`.
    pub first_y: i32,
    /// See `first_x`.
    pub first_z: i32,
    /// Whether slices are layers along z; else along y. The longer of the two, so that a slice has few rows.
    pub slices_are_layers: bool,
    last: Vec3,
    normal: Vec3,
    inverse: f32,
    front: f32,
    back: f32,
    xy_0: Condition,
    xy_1: Condition,
    xy_2: Condition,
    xz_0: Condition,
    xz_1: Condition,
    xz_2: Condition,
    rows_0: Condition,
    rows_1: Condition,
    rows_2: Condition,
}

/// The largest value of `n` · x over a voxel at 0 that is enlarged by `margin`.
#[inline(always)]
fn highest(n: f32, margin: f32) -> f32 {
    select(n > 0.0, n * (1.0 + margin), -(n * margin))
}

#[inline(always)]
fn reciprocal(x: f32) -> f32 {
    1.0 / select(x == 0.0, 1.0, x)
}

/// That a voxel reaches beyond an edge's line to the triangle's side: the edge goes by (`edge_s`, `edge_t`) from (`s`, `t`), and the
/// triangle is on its left if `side` is 1, on its right if it is −1.
#[inline(always)]
fn beyond_edge(s: f32, t: f32, edge_s: f32, edge_t: f32, side: f32, margin: f32, looser: f32) -> Condition {
    let along = -(edge_t * side);
    let across = edge_s * side;
    let rest = (highest(along, margin) - along * s) + (highest(across, margin) - across * t) + looser;
    Condition { along, across, rest, inverse: reciprocal(along) }
}

/// The triangle's side of its edges in a projection in which it has twice the area `area`, known to ± `error`; and by how much their
/// conditions must be loosened in case it is the other one.
#[inline(always)]
fn side(area: f32, error: f32) -> (f32, f32) {
    (select(area < 0.0, -1.0, 1.0), select(absolute(area) <= error, 2.0 * error, 0.0))
}

#[inline(always)]
fn corner(triangles: &[u32], at: i32) -> Vec3 {
    let number = |c: i32| f32::from_bits(read(triangles, at + c));
    Vec3::new(number(0), number(1), number(2))
}

/// Corner `number` of a triangle, in voxels from its first one.
#[inline(always)]
pub fn corner_of(triangles: &[u32], index: i32, number: i32) -> Vec3 {
    corner(triangles, index * triangle::SIZE as i32 + triangle::CORNERS as i32 + 3 * number)
}

/// The conditions of triangle number `index`.
#[inline(always)]
pub fn overlap(triangles: &[u32], index: i32) -> Overlap {
    let base = index * triangle::SIZE as i32;
    let (a, b, c) = (corner_of(triangles, index, 0), corner_of(triangles, index, 1), corner_of(triangles, index, 2));
    let margin = f32::from_bits(read(triangles, base + triangle::MARGIN as i32));
    let whole = |at: usize| read(triangles, base + at as i32) as i32;
    let (last_x, last_y, last_z) = (whole(triangle::LAST), whole(triangle::LAST + 1), whole(triangle::LAST + 2));
    let (e, f, g) = (b - a, c - b, a - c);

    let normal = Vec3::new(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
    let error = Vec3::new(
        (absolute(e.y * f.z) + absolute(e.z * f.y)) * ERROR,
        (absolute(e.z * f.x) + absolute(e.x * f.z)) * ERROR,
        (absolute(e.x * f.y) + absolute(e.y * f.x)) * ERROR,
    );
    let (last_x, last_y, last_z) = (last_x as f32, last_y as f32, last_z as f32);
    let extent = max(max(last_x, last_y), last_z) + 2.0;
    let looser = ((error.x + error.y) + error.z) * extent;
    let at = (normal.x * a.x + normal.y * a.y) + normal.z * a.z;
    let up = (highest(normal.x, margin) + highest(normal.y, margin)) + highest(normal.z, margin);
    let down = (highest(-normal.x, margin) + highest(-normal.y, margin)) + highest(-normal.z, margin);

    let (xy, xy_looser) = side(normal.z, error.z);
    // y is the normal's component of the projection (z, x): that of (x, z) has the other sign.
    let (xz, xz_looser) = side(-normal.y, error.y);
    let (yz, yz_looser) = side(normal.x, error.x);
    let slices_are_layers = last_z >= last_y;
    // Within a slice, rows follow each other along y in a layer, else along z: (y, z) or (z, y).
    let rows = select(slices_are_layers, yz, -yz);
    let (a_s, a_t) = (select(slices_are_layers, a.y, a.z), select(slices_are_layers, a.z, a.y));
    let (b_s, b_t) = (select(slices_are_layers, b.y, b.z), select(slices_are_layers, b.z, b.y));
    let (c_s, c_t) = (select(slices_are_layers, c.y, c.z), select(slices_are_layers, c.z, c.y));
    Overlap {
        first_x: whole(triangle::FIRST),
        first_y: whole(triangle::FIRST + 1),
        first_z: whole(triangle::FIRST + 2),
        slices_are_layers,
        last: Vec3::new(last_x, last_y, last_z),
        normal,
        inverse: reciprocal(normal.x),
        front: (up - at) + looser,
        back: (down + at) + looser,
        xy_0: beyond_edge(a.x, a.y, e.x, e.y, xy, margin, xy_looser),
        xy_1: beyond_edge(b.x, b.y, f.x, f.y, xy, margin, xy_looser),
        xy_2: beyond_edge(c.x, c.y, g.x, g.y, xy, margin, xy_looser),
        xz_0: beyond_edge(a.x, a.z, e.x, e.z, xz, margin, xz_looser),
        xz_1: beyond_edge(b.x, b.z, f.x, f.z, xz, margin, xz_looser),
        xz_2: beyond_edge(c.x, c.z, g.x, g.z, xz, margin, xz_looser),
        rows_0: beyond_edge(a_s, a_t, b_s - a_s, b_t - a_t, rows, margin, yz_looser),
        rows_1: beyond_edge(b_s, b_t, c_s - b_s, c_t - b_t, rows, margin, yz_looser),
        rows_2: beyond_edge(c_s, c_t, a_s - c_s, a_t - c_t, rows, margin, yz_looser),
    }
}

/// The part of (low, high) in which along · s + rest ≥ 0.
#[inline(always)]
fn narrow(range: (f32, f32), along: f32, inverse: f32, rest: f32) -> (f32, f32) {
    let limit = -(rest * inverse);
    let low = select(along > 0.0, max(range.0, limit), range.0);
    let high = select(along < 0.0, min(range.1, limit), range.1);
    let never = (along == 0.0) & (rest < 0.0);
    (low, select(never, -1.0, high))
}

#[inline(always)]
fn narrow_by(range: (f32, f32), condition: Condition, t: f32) -> (f32, f32) {
    narrow(range, condition.along, condition.inverse, condition.across * t + condition.rest)
}

/// The whole numbers of a range within 0…`most`.
#[inline(always)]
fn span(range: (f32, f32), most: f32) -> Span {
    Span { first: -floor_to_int(-range.0, -most - 1.0, 0.0), last: floor_to_int(range.1, -1.0, most) }
}

impl Overlap {
    /// The rows of slice `slice`, both counted from the triangle's first voxel.
    #[inline(always)]
    pub fn rows(&self, slice: i32) -> Span {
        let t = slice as f32;
        let most = select(self.slices_are_layers, self.last.y, self.last.z);
        let range = narrow_by((0.0, most), self.rows_0, t);
        let range = narrow_by(range, self.rows_1, t);
        span(narrow_by(range, self.rows_2, t), most)
    }

    /// The voxels of row (`y`, `z`), all counted from the triangle's first voxel.
    #[inline(always)]
    pub fn voxels(&self, y: i32, z: i32) -> Span {
        let (y, z) = (y as f32, z as f32);
        let n = self.normal;
        let plane = n.y * y + n.z * z;
        let range = narrow((0.0, self.last.x), n.x, self.inverse, plane + self.front);
        let range = narrow(range, -n.x, -self.inverse, self.back - plane);
        let range = narrow_by(range, self.xy_0, y);
        let range = narrow_by(range, self.xy_1, y);
        let range = narrow_by(range, self.xy_2, y);
        let range = narrow_by(range, self.xz_0, z);
        let range = narrow_by(range, self.xz_1, z);
        span(narrow_by(range, self.xz_2, z), self.last.x)
    }
}

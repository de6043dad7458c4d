//! Overlap of a triangle and a box: the separating axes of Akenine-Möller 2001 in the form of Schwarz & Seidel 2010, in the place of
//! Intersect() in Fig. 1 of Chang et al. 2010.
//!
//! A box and a triangle are apart if one of the triangle's plane, the edges of its projections along x, y and z, and the box's faces
//! lies between them. Each is a linear condition on the box's place, and boxes are all of one size: for a row of voxels along x the
//! conditions leave a span, which is found without looking at each voxel.
//!
//! Where a triangle's box is a voxel thick along an axis, the triangle meets a voxel if its projection along that axis does, which is a
//! third of the conditions ([`shape`]); where it is so along two, it meets all of the box.
//!
//! No voxel that a triangle meets is missed. Corners and edges are exact (see [`Place`]); what products, sums and quotients are off by
//! is less than the margin by which voxels are enlarged, 2⁻¹⁹ of the triangle's extent, except in what follows from a normal of a
//! triangle that is nearly a line. For that, conditions are loosened by the normal's own error.

use super::place::Place;
use crate::math::{absolute, floor_to_int, max, min, select};
use spirv_std::glam::{IVec3, Vec3, Vec4};

/// Relative error of a difference of two products of exact numbers, with room to spare: 2⁻²².
const ERROR: f32 = 1.0 / 4_194_304.0;

/// The first and the last voxel of a span.
#[derive(Clone, Copy)]
pub struct Span {
    /// The first voxel.
    pub first: i32,
    /// The last voxel, before the first if there is none.
    pub last: i32,
}

/// The shape of a triangle's box, which decides the conditions that have to be tested.
pub mod shape {
    /// A voxel along two axes at least: none.
    pub const ROW: u32 = 0;
    /// A voxel along x: those of the projection along x.
    pub const FLAT_X: u32 = 1;
    /// A voxel along y: those of the projection along y.
    pub const FLAT_Y: u32 = 2;
    /// A voxel along z: those of the projection along z.
    pub const FLAT_Z: u32 = 3;
    /// Several along each: all.
    pub const THICK: u32 = 4;
}

/// The shape of a triangle's box.
#[inline(always)]
pub fn shape_of(place: &Place) -> u32 {
    let (x, y, z) = (place.last.x == 0, place.last.y == 0, place.last.z == 0);
    if (x & y) | (y & z) | (z & x) {
        shape::ROW
    } else if x {
        shape::FLAT_X
    } else if y {
        shape::FLAT_Y
    } else if z {
        shape::FLAT_Z
    } else {
        shape::THICK
    }
}

/// The largest value of `n` · x over a voxel at 0 that is enlarged by `margin`.
#[inline(always)]
fn highest(n: f32, margin: f32) -> f32 {
    max(n * (1.0 + margin), -(n * margin))
}

/// The larger of each two.
#[inline(always)]
fn larger(a: Vec4, b: Vec4) -> Vec4 {
    Vec4::select(a.cmpgt(b), a, b)
}

/// 1 / x; 1 where x is 0.
#[inline(always)]
fn reciprocal(x: f32) -> f32 {
    1.0 / select(x == 0.0, 1.0, x)
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

/// The whole numbers of a range within 0…`most`.
#[inline(always)]
fn span(range: (f32, f32), most: f32) -> Span {
    Span { first: -floor_to_int(-range.0, -most - 1.0, 0.0), last: floor_to_int(range.1, -1.0, most) }
}

/// A number for each corner or edge; the last one is not used.
#[inline(always)]
fn of_corners(a: f32, b: f32, c: f32) -> Vec4 {
    Vec4::new(a, b, c, 0.0)
}

/// The conditions of a projection to (s, t), one for each of the triangle's edges: that a voxel reaches beyond the edge's line to the
/// triangle's side, along · s + across · t + rest ≥ 0.
#[derive(Clone, Copy)]
struct Projection {
    across: Vec4,
    rest: Vec4,
    /// −1 / along where a condition limits s from below, else 0.
    below: Vec4,
    /// −1 / along where it limits s from above; where along is 0, so much that what does not hold leaves nothing; else 0.
    above: Vec4,
    /// 0 where a condition limits s from above, else the last s.
    free: Vec4,
}

impl Projection {
    /// Of a triangle whose corners have these coordinates, and twice the area `area`, known to ± `error`: where that may be on either
    /// side, conditions are loosened in case it is the other one. Voxels are enlarged by `margin`, the last one is at `most`.
    #[inline(always)]
    fn new(s: Vec4, t: Vec4, area: f32, error: f32, margin: f32, most: f32) -> Self {
        let side = select(area < 0.0, -1.0, 1.0);
        let looser = select(absolute(area) <= error, 2.0 * error, 0.0);
        let along = (t - of_corners(t.y, t.z, t.x)) * side;
        let across = (of_corners(s.y, s.z, s.x) - s) * side;
        let highest = |n: Vec4| larger(n * (1.0 + margin), -(n * margin));
        let rest = (highest(along) - along * s) + (highest(across) - across * t) + Vec4::splat(looser);
        let none = along.cmpeq(Vec4::ZERO);
        let inverse = Vec4::splat(-1.0) / Vec4::select(none, Vec4::ONE, along);
        let is_below = along.cmpgt(Vec4::ZERO);
        let is_above = along.cmplt(Vec4::ZERO);
        Self {
            across,
            rest,
            below: Vec4::select(is_below, inverse, Vec4::ZERO),
            above: Vec4::select(is_above, inverse, Vec4::select(none, Vec4::splat(1e20), Vec4::ZERO)),
            free: Vec4::select(is_above, Vec4::ZERO, Vec4::splat(most)),
        }
    }

    /// The part of a range along s, from 0 to the last s at most, in which its conditions hold at `t`.
    #[inline(always)]
    fn narrow(&self, range: (f32, f32), t: f32) -> (f32, f32) {
        let rest = self.across * t + self.rest;
        let low = rest * self.below;
        let high = rest * self.above + self.free;
        (max(max(range.0, low.x), max(low.y, low.z)), min(min(range.1, high.x), min(high.y, high.z)))
    }
}

/// The conditions of a triangle whose box has the shape `SHAPE` (see [`shape`]).
#[derive(Clone, Copy)]
pub struct Overlap<const SHAPE: u32> {
    slices_are_layers: bool,
    last: IVec3,
    normal: Vec3,
    inverse: f32,
    front: f32,
    back: f32,
    xy: Projection,
    xz: Projection,
    /// (y, z) or (z, y): within a slice, rows follow each other along y in a layer, else along z.
    rows: Projection,
}

impl<const SHAPE: u32> Overlap<SHAPE> {
    /// The conditions of a triangle.
    #[inline(always)]
    pub fn new(place: &Place) -> Self {
        let (a, b, c) = place.corners();
        let margin = place.margin();
        let (e, f) = (b - a, c - b);
        let normal = Vec3::new(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
        let error = Vec3::new(
            (absolute(e.y * f.z) + absolute(e.z * f.y)) * ERROR,
            (absolute(e.z * f.x) + absolute(e.x * f.z)) * ERROR,
            (absolute(e.x * f.y) + absolute(e.y * f.x)) * ERROR,
        );
        let last = Vec3::new(place.last.x as f32, place.last.y as f32, place.last.z as f32);
        let extent = max(max(last.x, last.y), last.z) + 2.0;
        let looser = ((error.x + error.y) + error.z) * extent;
        let at = (normal.x * a.x + normal.y * a.y) + normal.z * a.z;
        let up = (highest(normal.x, margin) + highest(normal.y, margin)) + highest(normal.z, margin);
        let down = (highest(-normal.x, margin) + highest(-normal.y, margin)) + highest(-normal.z, margin);
        let x = of_corners(a.x, b.x, c.x);
        let y = of_corners(a.y, b.y, c.y);
        let z = of_corners(a.z, b.z, c.z);
        let layers = place.slices_are_layers();
        let rows = if layers {
            Projection::new(y, z, normal.x, error.x, margin, last.y)
        } else {
            Projection::new(z, y, -normal.x, error.x, margin, last.z)
        };
        Self {
            slices_are_layers: layers,
            last: place.last,
            normal,
            inverse: reciprocal(normal.x),
            front: (up - at) + looser,
            back: (down + at) + looser,
            xy: Projection::new(x, y, normal.z, error.z, margin, last.x),
            // y is the normal's component of the projection (z, x): that of (x, z) has the other sign.
            xz: Projection::new(x, z, -normal.y, error.y, margin, last.x),
            rows,
        }
    }

    /// The rows of slice `slice`, both counted from the triangle's first voxel.
    #[inline(always)]
    pub fn rows(&self, slice: i32) -> Span {
        let most = if self.slices_are_layers { self.last.y } else { self.last.z };
        if (SHAPE == shape::THICK) | (SHAPE == shape::FLAT_X) {
            span(self.rows.narrow((0.0, most as f32), slice as f32), most as f32)
        } else {
            Span { first: 0, last: most }
        }
    }

    /// The voxels of row (`y`, `z`), all counted from the triangle's first voxel.
    #[inline(always)]
    pub fn voxels(&self, y: i32, z: i32) -> Span {
        let (y, z) = (y as f32, z as f32);
        let most = self.last.x as f32;
        let mut range = (0.0, most);
        if SHAPE == shape::THICK {
            let n = self.normal;
            let plane = n.y * y + n.z * z;
            range = narrow(range, n.x, self.inverse, plane + self.front);
            range = narrow(range, -n.x, -self.inverse, self.back - plane);
        }
        if (SHAPE == shape::THICK) | (SHAPE == shape::FLAT_Z) {
            range = self.xy.narrow(range, y);
        }
        if (SHAPE == shape::THICK) | (SHAPE == shape::FLAT_Y) {
            range = self.xz.narrow(range, z);
        }
        if (SHAPE == shape::ROW) | (SHAPE == shape::FLAT_X) {
            Span { first: 0, last: self.last.x }
        } else {
            span(range, most)
        }
    }
}

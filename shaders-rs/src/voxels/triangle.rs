//! Watertight ray–triangle intersection: no ray slips through between two triangles (Woop, Benthin & Wald 2013).

use crate::abi::voxels::corner;
use crate::field::access::read_vector;
use crate::math::{absolute, select};
use crate::optics::receiver::FAR;
use spirv_std::glam::Vec3;

/// Least distance of a hit of [`meet`], in voxels: a ray leaves the surface that it starts from.
const NEAR: f32 = 1e-3;

/// A point on a triangle.
#[derive(Clone, Copy)]
pub struct Hit {
    /// Distance along the ray; [`FAR`] if it misses.
    pub distance: f32,
    /// Weights of the corners, not normalised; their sum is not 0 if there is a hit.
    pub weights: Vec3,
}

/// The sheared frame of a ray, whose z axis is the ray's longest axis and along which the ray runs (§3.1 there).
#[derive(Clone, Copy)]
pub struct Sheared {
    origin: Vec3,
    shear: Vec3,
    along_x: bool,
    along_y: bool,
}

/// Turns the axes so that the ray's longest is the last.
#[inline(always)]
fn turned(v: Vec3, along_x: bool, along_y: bool) -> Vec3 {
    Vec3::new(
        select(along_x, v.y, select(along_y, v.z, v.x)),
        select(along_x, v.z, select(along_y, v.x, v.y)),
        select(along_x, v.x, select(along_y, v.y, v.z)),
    )
}

/// The frame of a ray.
#[inline(always)]
pub fn shear(origin: Vec3, direction: Vec3) -> Sheared {
    let (x, y, z) = (absolute(direction.x), absolute(direction.y), absolute(direction.z));
    let along_x = (x >= y) & (x >= z);
    let along_y = !along_x & (y >= z);
    let d = turned(direction, along_x, along_y);
    let inverse = 1.0 / d.z;
    Sheared { origin, shear: Vec3::new(d.x * inverse, d.y * inverse, inverse), along_x, along_y }
}

#[inline(always)]
fn in_frame(ray: &Sheared, point: Vec3) -> Vec3 {
    let p = turned(point - ray.origin, ray.along_x, ray.along_y);
    Vec3::new(p.x - ray.shear.x * p.z, p.y - ray.shear.y * p.z, p.z * ray.shear.z)
}

/// Whether no two of three numbers have different signs.
#[inline(always)]
fn agree(a: f32, b: f32, c: f32) -> bool {
    let negative = (a < 0.0) | (b < 0.0) | (c < 0.0);
    let positive = (a > 0.0) | (b > 0.0) | (c > 0.0);
    !(negative & positive)
}

/// Intersection of a ray's line with triangle number `index`, ahead or behind; the distance of a miss is [`FAR`]. Two triangles compute the
/// edge function of a common edge with the same bits, and rounding gives neither the wrong sign: a ray through an edge or a corner
/// meets at least one of those that share it.
#[inline(always)]
pub fn intersect(ray: &Sheared, corners: &[f32], index: i32) -> Hit {
    let at = index * corner::SIZE as i32;
    let a = in_frame(ray, read_vector(corners, at));
    let b = in_frame(ray, read_vector(corners, at + 3));
    let c = in_frame(ray, read_vector(corners, at + 6));
    let (u, v, w) = (c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
    let sum = u + v + w;
    let inside = agree(u, v, w) & (sum != 0.0);
    let distance = (u * a.z + v * b.z + w * c.z) / select(inside, sum, 1.0);
    Hit { distance: select(inside, distance, FAR), weights: Vec3::new(u, v, w) }
}

/// Intersection with triangle number `index`, at least `NEAR` ahead of the ray's start.
#[inline(always)]
pub fn meet(ray: &Sheared, corners: &[f32], index: i32) -> Hit {
    let hit = intersect(ray, corners, index);
    Hit { distance: select(hit.distance > NEAR, hit.distance, FAR), ..hit }
}

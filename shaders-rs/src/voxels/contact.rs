//! Surfaces in contact: all triangles that a ray meets at one place are crossed together, so that a face that two bodies share refracts once,
//! from the one body to the other, whatever rounding makes of the order of its two sides (not in Chang et al. 2010).
//!
//! Two hits are at one place if the distance between them, across the surface that the ray meets less obliquely, is at most
//! `same_distance`: some times what rounding can be off by.

use super::ray::Ray;
use super::surface::ior;
use super::tree;
use super::triangle::{intersect, shear};
use crate::abi::voxels::corner;
use crate::field::access::{read, read_vector};
use crate::math::{absolute, cross, dot, max, normalize, select};
use spirv_std::glam::Vec3;

/// Least cosine between a ray and a normal that distances across a surface are measured with: rays closer to the surface are within a
/// 17th of a degree of it.
const GRAZING: f32 = 1e-3;
/// Distance across a surface within which a ray that starts there cannot meet it anew, over `same_distance`.
const LEAVING: f32 = 2.0;
/// Distance across a surface by which a ray that starts in front of it may begin behind it by rounding, over `same_distance`.
const BEHIND: f32 = 0.5;

/// The triangles of the place that is nearest so far on a ray's straight way. The ray's record has the strongest of them: an opaque one,
/// else that of the material with the lowest number, else the nearest.
#[derive(Clone, Copy)]
pub struct Contact {
    /// A bit for each material with a surface that the ray enters there.
    pub enters: i32,
    /// A bit for each material with a surface that the ray leaves there.
    pub leaves: i32,
    /// Distance on the straight way up to which surfaces have been crossed without a bend, in voxels; 0 where the way begins.
    pub start: f32,
    /// Distance of the last triangle there, in voxels.
    pub end: f32,
    /// Cosine between the ray and the normal of the triangle in the ray's record, at least [`GRAZING`].
    cosine: f32,
}

/// Whether a material is opaque, diffuse or a mirror.
#[inline(always)]
pub fn is_opaque(material: i32, materials: &[f32]) -> bool {
    ior(material, materials) <= 0.0
}

/// The number of a triangle's material.
#[inline(always)]
pub fn material_of(triangle: i32, corners: &[f32]) -> i32 {
    read(corners, triangle * corner::SIZE as i32 + corner::MATERIAL as i32) as i32
}

/// The unit normal of a triangle.
#[inline(always)]
pub fn plane(triangle: i32, corners: &[f32]) -> Vec3 {
    let at = triangle * corner::SIZE as i32;
    let a = read_vector(corners, at);
    normalize(cross(read_vector(corners, at + 3) - a, read_vector(corners, at + 6) - a))
}

/// The materials around a ray behind a place, a bit each, where `bits` are around it before, and the ray enters and leaves materials with the bits of
/// `enters` and `leaves`. A body that the ray enters and leaves at one place, along an edge or where two of its parts touch, stays as it is.
#[inline(always)]
pub fn beyond(bits: i32, enters: i32, leaves: i32) -> i32 {
    (bits | (enters & !leaves)) & !(leaves & !enters)
}

impl Contact {
    /// From the ray's record.
    #[inline(always)]
    pub fn load(ray: &Ray, corners: &[f32]) -> Self {
        let along = if ray.triangle >= 0 { dot(ray.direction, plane(ray.triangle, corners)) } else { 1.0 };
        Self {
            enters: ray.last_normal.x as i32,
            leaves: ray.last_normal.y as i32,
            start: ray.last_normal.z,
            end: ray.since,
            cosine: max(absolute(along), GRAZING),
        }
    }

    /// Stores it in the ray's record.
    #[inline(always)]
    pub fn store(self, ray: &mut Ray) {
        ray.last_normal = Vec3::new(self.enters as f32, self.leaves as f32, self.start);
        ray.since = self.end;
    }

    /// Begins the search for the next place behind `start`.
    #[inline(always)]
    pub fn seek(&mut self, start: f32) {
        self.enters = 0;
        self.leaves = 0;
        self.start = start;
    }

    /// Whether the ray may meet a surface at `distance`. Where the way begins, those that it has just crossed or was reflected by are left
    /// out: `changes` says whether the surface is another, whose crossing changes the materials around the ray.
    #[inline(always)]
    fn is_ahead(&self, distance: f32, cosine: f32, same: f32, changes: bool) -> bool {
        let across = distance * cosine;
        let begins = (across > same * LEAVING) | (changes & (across >= -(same * BEHIND)));
        (distance > self.start) & (self.start > 0.0) | (begins & (self.start <= 0.0))
    }

    /// Visits the ray's next node of the tree, and moves on to the node behind. `bits` has a bit for each material around the ray; `same` is
    /// the distance up to which two surfaces are in contact, in voxels.
    #[inline(always)]
    pub fn visit(&mut self, ray: &mut Ray, bits: i32, same: f32, nodes: &[f32], corners: &[f32], materials: &[f32]) {
        let found = ray.triangle >= 0;
        let reach = ray.distance + select(found, same / self.cosine, 0.0);
        let triangle = tree::step(ray, self.start, reach, nodes);
        if triangle < 0 {
            return;
        }
        let distance = intersect(&shear(ray.position, ray.direction), corners, triangle).distance;
        if distance >= reach {
            return;
        }
        let along = dot(ray.direction, plane(triangle, corners));
        let cosine = max(absolute(along), GRAZING);
        let material = material_of(triangle, corners);
        let opaque = is_opaque(material, materials);
        let bit = if opaque { 0 } else { 1 << material };
        let (enters, leaves) = if along < 0.0 { (bit, 0) } else { (0, bit) };
        // A mirror that has just reflected the ray is not met again.
        let ends = ior(material, materials) == 0.0;
        let changes = ends | (enters & !bits != 0) | (leaves & bits != 0);
        if !self.is_ahead(distance, cosine, same, changes) {
            return;
        }
        let nearer = distance < ray.distance;
        let apart = absolute(distance - ray.distance) * max(cosine, self.cosine);
        let together = found & (apart <= same);
        let mut replaces = nearer;
        if together {
            self.enters |= enters;
            self.leaves |= leaves;
            self.end = max(self.end, distance);
            let other = material_of(ray.triangle, corners);
            let other_opaque = is_opaque(other, materials);
            if opaque != other_opaque {
                replaces = opaque;
            } else if !opaque & (material != other) {
                replaces = material < other;
            }
        } else if nearer {
            self.enters = enters;
            self.leaves = leaves;
            self.end = distance;
        }
        if replaces {
            ray.triangle = triangle;
            ray.distance = distance;
            self.cosine = cosine;
        }
    }
}

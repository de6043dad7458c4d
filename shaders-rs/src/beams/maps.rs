//! Maps of the bodies as the light sees them, over its lattice: the first surface along the ray of each texel, and behind a clear one the last
//! surface that light leaves a body by (Hu et al. 2010, §5.1; Hu & Qin 2007).
//!
//! Distances are from the light, or from the plane on which the rays of a distant light start. The ray of a texel meets the front map where the map was made,
//! and nothing is interpolated there; between texels the back map is interpolated.

use super::emission::{self, Start};
use crate::abi::beams::BeamsUniforms;
use crate::abi::light::kind;
use crate::abi::record::faces;
use crate::field::access::read;
use crate::math::{dot, floor_to_int, length, max, min, normalize, xyz};
use crate::optics::receiver::FAR;
use crate::voxels::ray::{reciprocal, slab};
use spirv_std::glam::Vec3;

/// The number of a material where there is no surface.
pub const NO_MATERIAL: i32 = -1;

/// A component of the record of texel number `number` of `count`.
#[inline(always)]
pub fn of_texel(records: &[f32], component: usize, number: i32, count: i32) -> f32 {
    read(records, component as i32 * count + number)
}

/// A vector of that record, from `component` on.
#[inline(always)]
pub fn vector_of_texel(records: &[f32], component: usize, number: i32, count: i32) -> Vec3 {
    Vec3::new(
        of_texel(records, component, number, count),
        of_texel(records, component + 1, number, count),
        of_texel(records, component + 2, number, count),
    )
}

/// The ray of a texel, and its part in the box of all surfaces.
#[derive(Clone, Copy)]
pub struct Line {
    /// The ray where it starts.
    pub start: Start,
    /// Distance along the ray at which there can be light: 0, or far behind the plane of a distant light.
    pub source: f32,
    /// Distance at which the ray enters the box.
    pub enters: f32,
    /// Distance at which it leaves.
    pub leaves: f32,
    /// Whether the ray comes past the box.
    pub misses: bool,
}

impl Line {
    /// The ray of texel (`column`, `row`).
    #[inline(always)]
    pub fn new(u: &BeamsUniforms, column: i32, row: i32) -> Self {
        let start = emission::start(u, column, row);
        let d = start.direction;
        let inverse = Vec3::new(reciprocal(d.x), reciprocal(d.y), reciprocal(d.z));
        let (enters, leaves) = slab(start.position, inverse, xyz(u.low), xyz(u.high));
        let source = if u.light.kind == kind::DISTANT { -FAR } else { 0.0 };
        let enters = max(enters, source);
        Self { start, source, enters, leaves, misses: leaves <= enters }
    }

    /// The position at a distance.
    #[inline(always)]
    pub fn at(&self, distance: f32) -> Vec3 {
        self.start.position + self.start.direction * distance
    }
}

/// The first surface along the ray of a texel.
#[derive(Clone, Copy)]
pub struct Front {
    /// Distance along the ray.
    pub distance: f32,
    /// Unit normal between the corners, on the side that the light comes from.
    pub normal: Vec3,
    /// The triangle, or one of [`ahead`](crate::abi::receivers::ahead).
    pub triangle: i32,
    /// The number of its material.
    pub material: i32,
}

impl Front {
    /// That of texel number `number` of `count`.
    #[inline(always)]
    pub fn load(faces: &[f32], number: i32, count: i32) -> Self {
        Self {
            distance: of_texel(faces, faces::FRONT_DISTANCE, number, count),
            normal: vector_of_texel(faces, faces::FRONT_NORMAL, number, count),
            triangle: of_texel(faces, faces::FRONT_TRIANGLE, number, count) as i32,
            material: of_texel(faces, faces::FRONT_MATERIAL, number, count) as i32,
        }
    }
}

/// The back map at a place, interpolated between those of the four texels around it that have a back of the material that is asked for.
#[derive(Clone, Copy)]
pub struct Back {
    /// The place's own distance from the light less that of the map: above 0 behind the body. [`FAR`] where the map has no back.
    pub gap: f32,
    /// Unit normal, on the side that the light goes to; 0 where the map has no back.
    pub normal: Vec3,
}

impl Back {
    /// The back of a body of material `material` where a ray from the light to `position` meets it.
    #[inline(always)]
    pub fn at(u: &BeamsUniforms, faces: &[f32], material: i32, position: Vec3) -> Self {
        let lattice = &u.lattice;
        let texels = lattice.count as i32;
        let count = texels * texels;
        let offset = position - xyz(lattice.origin);
        let along = dot(offset, xyz(lattice.axis));
        let distant = u.light.kind == kind::DISTANT;
        let inverse = if distant { 1.0 } else { 1.0 / max(along, 1e-6) };
        let distance = if distant { along } else { length(offset) };
        let column =
            (dot(offset, xyz(lattice.across)) * inverse - lattice.low_across) * reciprocal(lattice.step_across) - 0.5;
        let row = (dot(offset, xyz(lattice.upwards)) * inverse - lattice.low_upwards)
            * reciprocal(lattice.step_upwards)
            - 0.5;
        // Beyond the lattice there is no texel, and none has a weight.
        let (i, j) = (floor_to_int(column, -2.0, texels as f32), floor_to_int(row, -2.0, texels as f32));
        let (right, down) = (min(max(column - i as f32, 0.0), 1.0), min(max(row - j as f32, 0.0), 1.0));
        let (mut sum, mut weights, mut normal) = (0.0, 0.0, Vec3::new(0.0, 0.0, 0.0));
        let mut corner = 0;
        while corner < 4 {
            let (to_right, to_down) = (corner & 1, corner >> 1);
            let (x, y) = (i + to_right, j + to_down);
            let number = y * texels + x;
            let weight =
                (if to_right == 1 { right } else { 1.0 - right }) * (if to_down == 1 { down } else { 1.0 - down });
            let on_lattice = (x >= 0) & (y >= 0) & (x < texels) & (y < texels);
            if on_lattice & (of_texel(faces, faces::BACK_MATERIAL, number, count) as i32 == material) {
                sum += of_texel(faces, faces::BACK_DISTANCE, number, count) * weight;
                normal += vector_of_texel(faces, faces::BACK_NORMAL, number, count) * weight;
                weights += weight;
            }
            corner += 1;
        }
        if weights > 0.0 {
            Self { gap: distance - sum / weights, normal: normalize(normal) }
        } else {
            Self { gap: FAR, normal: Vec3::new(0.0, 0.0, 0.0) }
        }
    }
}

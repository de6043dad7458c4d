//! Rays through the triangles of a mesh, for comparison with voxels (watertight intersection: Woop, Benthin & Wald 2013).

use super::contact::{Contact, beyond, is_opaque, material_of, plane};
use super::ray::{Ray, level_of};
use super::surface::{bend, ior, meet};
use super::tree;
use super::triangle::{intersect, shear};
use crate::abi::receivers::ahead;
use crate::abi::record::{fate, path};
use crate::abi::voxels::{AIR, STEPS, VoxelsUniforms, corner};
use crate::field::access::read_vector;
use crate::math::{dot, max, normalize, select, select_vector};
use spirv_std::glam::Vec3;

pub use super::ray::level;

/// The level of work: whether the ray is active.
#[inline(always)]
pub fn level(
    _x: u32,
    _y: u32,
    _u: &VoxelsUniforms,
    _mode: u32,
    before: [f32; path::SIZE],
    _nodes: &[f32],
    _corners: &[f32],
    _materials: &[f32],
) -> u32 {
    level_of(Ray::load(&before).status)
}

/// The lowest number of a material whose bit is set in `bits`, [`AIR`] if none is.
#[inline(always)]
pub fn lowest(bits: i32) -> i32 {
    let mut found = AIR;
    let mut number = AIR - 1;
    while number >= 0 {
        if (bits >> number) & 1 == 1 {
            found = number;
        }
        number -= 1;
    }
    found
}

/// The unit normal between the corners of the triangle that a ray meets.
#[inline(always)]
fn between_corners(ray: &Ray, corners: &[f32]) -> Vec3 {
    let weights = intersect(&shear(ray.position, ray.direction), corners, ray.triangle).weights;
    let sum = (weights.x + weights.y) + weights.z;
    let share = weights * (1.0 / select(sum == 0.0, 1.0, sum));
    let normals = ray.triangle * corner::SIZE as i32 + corner::NORMALS as i32;
    let mean = read_vector(corners, normals) * share.x
        + read_vector(corners, normals + 3) * share.y
        + read_vector(corners, normals + 6) * share.z;
    normalize(mean)
}

/// The unit normal that the ray is bent by at the triangle that it meets, on its way from medium `from` to `to`: that between the corners, or
/// where it would put the ray on the wrong side of the triangle, the triangle's own.
#[inline(always)]
fn normal(ray: &Ray, corners: &[f32], from: i32, to: i32, materials: &[f32]) -> Vec3 {
    let plane = plane(ray.triangle, corners);
    let mean = between_corners(ray, corners);
    let d = ray.direction;
    let bent = bend(d, mean, ior(from, materials), ior(to, materials));
    let comes = dot(d, plane);
    let goes = dot(bent.direction, plane) * select(bent.reflected, -1.0, 1.0);
    select_vector((dot(mean, d) * comes > 0.0) & (goes * comes > 0.0), mean, plane)
}

/// The ray after some nodes.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    _x: u32,
    _y: u32,
    u: &VoxelsUniforms,
    mode: u32,
    before: [f32; path::SIZE],
    nodes: &[f32],
    corners: &[f32],
    materials: &[f32],
) -> [f32; path::SIZE] {
    let mut ray = Ray::load(&before);
    let mut contact = Contact::load(&ray, corners);
    let count = tree::count(nodes);
    // Below 0, to tell them from a material's number.
    let mut bits = if ray.medium == AIR { 0 } else { -ray.medium };
    let mut step = 0;
    while (step < 4 * STEPS) & (ray.status == fate::ACTIVE) {
        step += 1;
        if ray.node < count {
            contact.visit(&mut ray, bits, u.same_distance, nodes, corners, materials);
        } else {
            let from = lowest(bits);
            let met = ray.triangle >= 0;
            let beyond = beyond(bits, contact.enters, contact.leaves);
            let to = lowest(beyond);
            let ends = if met {
                is_opaque(material_of(ray.triangle, corners), materials)
            } else {
                // Nothing, or a receiver.
                true
            };
            if !met & ((ray.triangle == ahead::NOTHING) | (from == AIR)) {
                ray.end(materials);
            } else if ends {
                ray.attenuate(max(ray.distance - contact.start, 0.0), from, materials);
                ray.meet(AIR, materials);
            } else if from == to {
                // Surfaces within a material that lies above theirs are not seen, and the way goes straight on.
                ray.attenuate(max(contact.end - contact.start, 0.0), from, materials);
                bits = beyond;
                contact.seek(max(contact.end, f32::MIN_POSITIVE));
                ray.turn(u);
            } else {
                let normal = normal(&ray, corners, from, to, materials);
                ray.attenuate(max(ray.distance - contact.start, 0.0), from, materials);
                ray.advance(ray.distance, AIR, materials);
                contact.seek(0.0);
                if meet(&mut ray, u, mode, normal, from, to, materials) {
                    bits = beyond;
                }
            }
        }
    }
    ray.medium = if bits == 0 { AIR } else { -bits };
    contact.store(&mut ray);
    ray.store()
}

//! Rays through the triangles of a mesh, for comparison with voxels (watertight intersection: Woop, Benthin & Wald 2013).

use super::ray::{Ray, level_of};
use super::surface::{ior, meet};
use super::tree;
use super::triangle::shear;
use crate::abi::receivers::ahead;
use crate::abi::record::{fate, path};
use crate::abi::voxels::{AIR, STEPS, VoxelsUniforms, corner};
use crate::field::access::{read, read_vector};
use crate::math::{cross, dot, normalize, select, select_vector};
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

/// The lowest number of a material whose bit is set in `bits`.
#[inline(always)]
fn lowest(bits: i32) -> i32 {
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

/// The surface at a hit.
#[derive(Clone, Copy)]
struct Surface {
    /// Unit normal of the triangle.
    plane: Vec3,
    /// Unit normal between its corners.
    normal: Vec3,
    /// Number of the material.
    material: i32,
}

#[inline(always)]
fn surface(ray: &Ray, corners: &[f32], index: i32) -> Surface {
    let at = index * corner::SIZE as i32;
    let (a, b, c) = (read_vector(corners, at), read_vector(corners, at + 3), read_vector(corners, at + 6));
    let (e, f) = (b - a, c - a);
    let plane = normalize(cross(e, f));
    let weights = super::triangle::meet(&shear(ray.position, ray.direction), corners, index).weights;
    let sum = (weights.x + weights.y) + weights.z;
    let share = weights * (1.0 / select(sum == 0.0, 1.0, sum));
    let normals = at + corner::NORMALS as i32;
    let mean = read_vector(corners, normals) * share.x
        + read_vector(corners, normals + 3) * share.y
        + read_vector(corners, normals + 6) * share.z;
    let mean = normalize(mean);
    // Where the ray is on the other side of the one than of the other, only the triangle's can be right.
    let same = dot(mean, ray.direction) * dot(plane, ray.direction) > 0.0;
    let normal = select_vector(same, mean, plane);
    Surface { plane, normal, material: read(corners, at + corner::MATERIAL as i32) as i32 }
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
    let count = tree::count(nodes);
    // Below 0, to tell them from a material's number.
    let mut bits = if ray.medium == AIR { 0 } else { -ray.medium };
    let mut step = 0;
    while (step < 4 * STEPS) & (ray.status == fate::ACTIVE) {
        step += 1;
        if ray.node < count {
            tree::visit(&mut ray, nodes, corners);
        } else if ray.triangle < 0 {
            let from = lowest(bits);
            // Nothing, or a receiver.
            if (ray.triangle == ahead::NOTHING) | (from == AIR) {
                ray.end(materials);
            } else {
                ray.meet(from, materials);
            }
        } else {
            let from = lowest(bits);
            let surface = surface(&ray, corners, ray.triangle);
            if ior(surface.material, materials) == 0.0 {
                ray.meet(from, materials);
            } else {
                let bit = 1 << surface.material;
                let beyond = if dot(ray.direction, surface.plane) < 0.0 { bits | bit } else { bits & !bit };
                let to = lowest(beyond);
                ray.advance(ray.distance, from, materials);
                // Surfaces within a material that lies above theirs are not seen.
                let through = if from == to {
                    ray.turn(u);
                    true
                } else {
                    meet(&mut ray, u, mode, surface.normal, from, to, materials)
                };
                bits = if through { beyond } else { bits };
            }
        }
    }
    ray.medium = if bits == 0 { AIR } else { -bits };
    ray.store()
}

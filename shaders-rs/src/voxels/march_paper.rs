//! Ray marching through voxels as in the paper (Chang et al. 2010, §4.1.1, Eq. 1): from slice to slice across the ray's longest axis,
//! P_i = P_{i−1} + T / cos θ, refracted at every voxel that a triangle meets, by the normal and the material that the voxel stores.

use super::ray::{Ray, level_of};
use super::surface::meet;
use crate::abi::record::{fate, path};
use crate::abi::voxels::{AIR, STEPS, VoxelsUniforms, surface};
use crate::field::access::{read, read_vector};
use crate::math::{absolute, dot, floor_to_int, max};
use spirv_std::glam::Vec3;

pub use super::ray::level;

/// Whether the ray is under way, and marches.
#[inline(always)]
pub fn level(
    _x: u32,
    _y: u32,
    _u: &VoxelsUniforms,
    _mode: u32,
    before: [f32; path::SIZE],
    _mask: &[u32],
    _ranks: &[u32],
    _surfaces: &[f32],
    _materials: &[f32],
) -> u32 {
    level_of(Ray::load(&before).status)
}

/// Whether a position lies outside of the grid.
#[inline(always)]
fn is_outside(u: &VoxelsUniforms, p: Vec3) -> bool {
    let (x, y, z) = (u.size.x as i32 as f32, u.size.y as i32 as f32, u.size.z as i32 as f32);
    (p.x < 0.0) | (p.y < 0.0) | (p.z < 0.0) | (p.x >= x) | (p.y >= y) | (p.z >= z)
}

/// The ray after some slices.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    _x: u32,
    _y: u32,
    u: &VoxelsUniforms,
    mode: u32,
    before: [f32; path::SIZE],
    mask: &[u32],
    ranks: &[u32],
    surfaces: &[f32],
    materials: &[f32],
) -> [f32; path::SIZE] {
    let mut ray = Ray::load(&before);
    let (nx, ny, nz) = (u.size.x as i32, u.size.y as i32, u.size.z as i32);
    let row = (nx + 31) >> 5;
    let mut step = 0;
    while (step < STEPS) & (ray.status == fate::ACTIVE) {
        step += 1;
        let d = ray.direction;
        let longest = max(max(absolute(d.x), absolute(d.y)), absolute(d.z));
        let slice = 1.0 / max(longest, 0.5);
        let meets = ray.distance <= slice;
        if meets {
            ray.meet(ray.medium, materials);
        } else {
            ray.advance(slice, ray.medium, materials);
        }
        let p = ray.position;
        if !meets & is_outside(u, p) {
            ray.end(materials);
        } else if !meets {
            let x = floor_to_int(p.x, 0.0, (nx - 1) as f32);
            let y = floor_to_int(p.y, 0.0, (ny - 1) as f32);
            let z = floor_to_int(p.z, 0.0, (nz - 1) as f32);
            let word = (z * ny + y) * row + (x >> 5);
            let bits = read(mask, word);
            let bit = (x & 31) as u32;
            if (bits >> bit) & 1 == 1 {
                let place = (read(ranks, word) + (bits & ((1 << bit) - 1)).count_ones()) as i32;
                let at = place * surface::SIZE as i32;
                let normal = read_vector(surfaces, at);
                let material = floor_to_int(read(surfaces, at + surface::MATERIAL as i32), 0.0, AIR as f32);
                let along = dot(d, normal);
                let to = if along < 0.0 { material } else { AIR };
                let again = (ray.bounces > 0.0) & (dot(normal, ray.last_normal) > u.same_cosine);
                if !again & (along != 0.0) & (to != ray.medium) {
                    let from = ray.medium;
                    let through = meet(&mut ray, u, mode, normal, from, to, materials);
                    ray.medium = if through { to } else { from };
                    ray.last_normal = normal;
                }
            }
        }
    }
    ray.store()
}

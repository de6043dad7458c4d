//! Ray marching through voxels with a smoothed surface: from brick to brick where no surface is near, in half voxels elsewhere; at a
//! surface, Snell's law (Chang et al. 2010, §4.1.1, Eq. 1; two surfaces: §4.1, after Wyman 2005). The surface is the level ½ of the
//! smoothed coverage, which is not in the paper: the paper takes each voxel that a triangle meets as the surface.

use super::crease::face;
use super::ray::{Ray, bounds, level_of, reciprocal, slab};
use super::solid::medium;
use super::surface::meet;
use crate::abi::record::{fate, path};
use crate::abi::voxels::{AIR, BRICK_SHIFT, STEPS, VoxelsUniforms};
use crate::field::access::read;
use crate::math::{dot, floor_to_int, max, min, select};
use spirv_std::glam::Vec3;

pub use super::ray::level;

/// Length of a step near a surface, in voxels.
const STEP: f32 = 0.5;
/// Length by which a step passes a brick's face, in voxels, so that the ray is in the next brick.
const BEYOND: f32 = 1e-3;
/// Halvings of a step that crosses a surface (bisection): the error is 2⁻¹³ voxels.
const HALVINGS: i32 = 12;

/// Whether the ray is under way, and marches.
#[inline(always)]
pub fn level(
    _x: u32,
    _y: u32,
    _u: &VoxelsUniforms,
    _mode: u32,
    before: [f32; path::SIZE],
    _bricks: &[u32],
    _fields: &[u32],
    _materials: &[f32],
) -> u32 {
    level_of(Ray::load(&before).status)
}

/// Length of the next step, in voxels: half a voxel near a surface, else the distance to the end of the empty bricks.
#[inline(always)]
fn stride(u: &VoxelsUniforms, bricks: &[u32], position: Vec3, inverse: Vec3) -> f32 {
    let (nx, ny, nz) = (u.bricks.x as i32, u.bricks.y as i32, u.bricks.z as i32);
    let edge = (1 << BRICK_SHIFT) as f32;
    // Between voxels' centres, as the fields are.
    let x = floor_to_int((position.x - 0.5) / edge, 0.0, (nx - 1) as f32);
    let y = floor_to_int((position.y - 0.5) / edge, 0.0, (ny - 1) as f32);
    let z = floor_to_int((position.z - 0.5) / edge, 0.0, (nz - 1) as f32);
    let clear = read(bricks, (z * ny + y) * nx + x) as i32;
    if clear > 0 {
        let low = Vec3::new((x - clear + 1) as f32, (y - clear + 1) as f32, (z - clear + 1) as f32);
        let high = Vec3::new((x + clear) as f32, (y + clear) as f32, (z + clear) as f32);
        let half = Vec3::new(0.5, 0.5, 0.5);
        let (_, leaves) = slab(position, inverse, low * edge + half, high * edge + half);
        max(leaves, 0.0) + BEYOND
    } else {
        STEP
    }
}

/// Distance along a step at which the medium changes, in voxels, by bisection; `here` is the medium at the start, and the medium at the
/// end is another.
#[inline(always)]
fn boundary(u: &VoxelsUniforms, fields: &[u32], ray: &Ray, distance: f32) -> f32 {
    let (mut near, mut far) = (0.0, distance);
    let mut i = 0;
    while i < HALVINGS {
        let middle = 0.5 * (near + far);
        if medium(u, fields, ray.position + ray.direction * middle) == ray.medium {
            near = middle;
        } else {
            far = middle;
        }
        i += 1;
    }
    far
}

/// The ray after some steps.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    _x: u32,
    _y: u32,
    u: &VoxelsUniforms,
    mode: u32,
    before: [f32; path::SIZE],
    bricks: &[u32],
    fields: &[u32],
    materials: &[f32],
) -> [f32; path::SIZE] {
    let mut ray = Ray::load(&before);
    let (low, high) = bounds(u);
    if (ray.status == fate::ACTIVE) & (ray.bounces == 0.0) {
        // The eye may be inside.
        ray.medium = medium(u, fields, ray.position);
    }
    let mut step = 0;
    while (step < STEPS) & (ray.status == fate::ACTIVE) {
        step += 1;
        let d = ray.direction;
        let inverse = Vec3::new(reciprocal(d.x), reciprocal(d.y), reciprocal(d.z));
        let (_, leaves) = slab(ray.position, inverse, low, high);
        let free = min(stride(u, bricks, ray.position, inverse), max(leaves, 0.0) + BEYOND);
        // Up to what is opaque.
        let meets = ray.distance <= free;
        let distance = select(meets, ray.distance, free);
        let from = ray.medium;
        let there = medium(u, fields, ray.position + d * distance);
        let mut goes_on = there == from;
        if !goes_on {
            let until = boundary(u, fields, &ray, distance);
            let point = ray.position + d * until;
            let to = medium(u, fields, point);
            // The surface of the one that lies above the other.
            let owner = if to < from { to } else { from };
            let face = face(u, fields, owner, point, d);
            let normal = face.normal;
            // The paper's threshold: a surface that has just been met, found once more where it is a little uneven.
            let again = (ray.since + until < u.same_distance) & (dot(normal, ray.last_normal) > u.same_cosine);
            goes_on = again | (to == from);
            if !goes_on {
                ray.advance(until + face.ahead, from, materials);
                let through = meet(&mut ray, u, mode, normal, from, to, materials);
                ray.medium = if through { to } else { from };
                ray.last_normal = normal;
            }
        }
        if goes_on & meets {
            ray.meet(from, materials);
        } else if goes_on {
            ray.advance(distance, from, materials);
            if (leaves <= 0.0) & (there == AIR) & (from == AIR) {
                ray.end(materials);
            }
        }
    }
    ray.store()
}

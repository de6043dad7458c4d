//! Directions of pixels: from the eye to the first surface, and mirrored there (the law of reflection).

use crate::abi::record::path;
use crate::abi::voxels::VoxelsUniforms;
use crate::field::access::read;
use crate::math::{dot, normalize, select, xyz};
use spirv_std::glam::Vec3;

/// Three components of the record of ray number `at`.
#[inline(always)]
pub fn vector(u: &VoxelsUniforms, rays: &[f32], at: i32, component: usize) -> Vec3 {
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    let c = |c: usize| read(rays, c as i32 * count + at);
    Vec3::new(c(component), c(component + 1), c(component + 2))
}

/// Direction in which pixel (x, y) looks, along the grid's axes, at depth 1 from the eye; and the offset of the origin of its ray from
/// the eye, 0 in perspective.
#[inline(always)]
fn aim(u: &VoxelsUniforms, x: i32, y: i32) -> (Vec3, Vec3) {
    let (width, height) = (u.dispatch.width as i32 as f32, u.dispatch.height as i32 as f32);
    let across = ((x as f32 + 0.5) / width * 2.0 - 1.0) * u.camera.half_width;
    let upwards = (1.0 - (y as f32 + 0.5) / height * 2.0) * u.camera.half_height;
    let side = xyz(u.right) * across + xyz(u.up) * upwards;
    let perspective = select(u.camera.orthographic != 0, 0.0, 1.0);
    (xyz(u.away) + side * perspective, side * (1.0 - perspective))
}

/// The unit direction in which pixel (x, y) looks, along the grid's axes.
#[inline(always)]
pub fn viewing(u: &VoxelsUniforms, x: i32, y: i32) -> Vec3 {
    let (aim, _) = aim(u, x, y);
    normalize(aim)
}

/// The first surface that pixel (x, y) looks at, `depth` voxels away.
#[inline(always)]
pub fn first_surface(u: &VoxelsUniforms, x: i32, y: i32, depth: f32) -> Vec3 {
    let (_, side) = aim(u, x, y);
    xyz(u.eye) + side + viewing(u, x, y) * depth
}

/// Direction in which the first surface mirrors pixel (x, y); the pixel's own direction where it has no surface.
#[inline(always)]
pub fn mirrored(u: &VoxelsUniforms, rays: &[f32], x: i32, y: i32) -> Vec3 {
    let direction = viewing(u, x, y);
    let normal = vector(u, rays, y * u.dispatch.width as i32 + x, path::NORMAL);
    direction - normal * (2.0 * dot(direction, normal))
}

//! Finished pixels: what rays see of opaque bodies, receivers and the environment, by refraction and by reflection at the first surface.

use super::mirror::{first_surface, mirrored, vector, viewing};
use super::shade::{Point, facing, on_receiver, on_triangle, shade};
use crate::abi::record::path::ahead;
use crate::abi::record::{fate, mirror, path, view};
use crate::abi::voxels::{VoxelsUniforms, seen};
use crate::field::access::read;
use crate::math::{dot, length, max, select, xyz};
use crate::optics::environment::{Surroundings, environment};
use spirv_std::glam::Vec3;

#[inline(always)]
fn leaving(u: &VoxelsUniforms, rays: &[f32], x: i32, y: i32) -> Vec3 {
    vector(u, rays, y * u.dispatch.x as i32 + x, path::DIRECTION)
}

/// The neighbours of pixel (x, y) that are there: left, right, above, below.
#[inline(always)]
fn around(u: &VoxelsUniforms, x: i32, y: i32) -> (i32, i32, i32, i32) {
    let (width, height) = (u.dispatch.x as i32, u.dispatch.y as i32);
    let left = if x > 0 { x - 1 } else { 0 };
    let right = if x < width - 1 { x + 1 } else { width - 1 };
    let above = if y > 0 { y - 1 } else { 0 };
    let below = if y < height - 1 { y + 1 } else { height - 1 };
    (left, right, above, below)
}

/// The environment in direction `d`, over the angle between neighbouring pixels' directions: `across` and `down`, two apart.
#[inline(always)]
fn surroundings(u: &VoxelsUniforms, map: &[f32], d: Vec3, across: Vec3, down: Vec3) -> Vec3 {
    let surroundings = Surroundings {
        shape: u.environment,
        color: u.environment_color,
        horizon: u.environment_horizon,
        nadir: u.environment_nadir,
    };
    let turned = Vec3::new(dot(xyz(u.environment_x), d), dot(xyz(u.environment_y), d), dot(xyz(u.environment_z), d));
    environment(&surroundings, map, turned, 0.5 * max(length(across), length(down)))
}

/// A direction in view space (looking along −z).
#[inline(always)]
fn in_view(u: &VoxelsUniforms, v: Vec3) -> Vec3 {
    Vec3::new(dot(xyz(u.right), v), dot(xyz(u.up), v), -dot(xyz(u.away), v))
}

/// The point at which a ray ended.
#[inline(always)]
fn point(u: &VoxelsUniforms, corners: &[f32], looks: &[f32], triangle: i32, position: Vec3) -> Point {
    if triangle < 0 { on_receiver(u, triangle, position) } else { on_triangle(u, corners, looks, triangle, position) }
}

/// The finished pixel (x, y).
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &VoxelsUniforms,
    mode: u32,
    rays: &[f32],
    map: &[f32],
    corners: &[f32],
    looks: &[f32],
    shadow: &[u32],
    mirrors: &[f32],
) -> [f32; view::SIZE] {
    let (x, y) = (x as i32, y as i32);
    let at = y * u.dispatch.x as i32 + x;
    let count = (u.dispatch.x * u.dispatch.y) as i32;
    let component = |c: usize| read(rays, c as i32 * count + at);
    let (left, right, above, below) = around(u, x, y);
    let direction = leaving(u, rays, x, y);
    let across = leaving(u, rays, right, y) - leaving(u, rays, left, y);
    let down = leaving(u, rays, x, below) - leaving(u, rays, x, above);
    let transmittance = vector(u, rays, at, path::TRANSMITTANCE);
    let bounces = component(path::BOUNCES);
    let status = component(path::STATUS);
    let surfaces = mode == seen::SURFACES;
    let met = surfaces & (status == fate::MET);
    let mut first_normal = vector(u, rays, at, path::NORMAL);
    let mut through = surroundings(u, map, direction, across, down);
    if met {
        let triangle = component(path::TRIANGLE) as i32;
        let point = point(u, corners, looks, triangle, vector(u, rays, at, path::POSITION));
        through = shade(u, shadow, &point, direction);
        if bounces == 0.0 {
            first_normal = facing(&point, direction);
        }
    }
    let through = through * transmittance;
    let across = mirrored(u, rays, right, y) - mirrored(u, rays, left, y);
    let down = mirrored(u, rays, x, below) - mirrored(u, rays, x, above);
    let reflectance = component(path::REFLECTANCE);
    let towards_mirrored = mirrored(u, rays, x, y);
    let mut reflected = surroundings(u, map, towards_mirrored, across, down);
    if surfaces & (reflectance > 0.0) {
        let record = |component: usize| read(mirrors, component as i32 * count + at);
        let triangle = record(mirror::TRIANGLE) as i32;
        if triangle != ahead::NOTHING {
            let from = first_surface(u, x, y, component(path::DEPTH));
            let position = from + towards_mirrored * record(mirror::DISTANCE);
            let point = point(u, corners, looks, triangle, position);
            reflected = shade(u, shadow, &point, towards_mirrored);
        }
    }
    let reflected = reflected * reflectance;
    // Without an environment the picture is transparent where there is no surface.
    let something = (bounces > 0.0) | met;
    let visible = select(something, 1.0, u.environment_nadir.w);
    let color = (through + reflected) * visible;
    let normal = in_view(u, first_normal);
    let towards = in_view(u, direction);
    let voxel = u.scale.x;
    let depth = component(path::DEPTH) * voxel * dot(xyz(u.away), viewing(u, x, y));
    [
        color.x,
        color.y,
        color.z,
        visible,
        normal.x,
        normal.y,
        normal.z,
        bounces,
        component(path::LENGTH) * voxel,
        select(something, depth, 0.0),
        towards.x,
        towards.y,
        towards.z,
        transmittance.x,
        transmittance.y,
        transmittance.z,
        reflectance,
        // One that is still under way did not get out.
        select((status == fate::ACTIVE) | (status == fate::SEEKS), fate::TRAPPED, status),
    ]
}

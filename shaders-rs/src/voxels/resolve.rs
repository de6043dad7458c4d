//! Finished pixels: what rays see of the environment, by refraction and by reflection at the first surface.

use crate::abi::record::{fate, path, view};
use crate::abi::voxels::VoxelsUniforms;
use crate::field::access::read;
use crate::math::{dot, length, max, min, select, xyz};
use crate::optics::environment::{Surroundings, environment};
use spirv_std::glam::Vec3;

#[inline(always)]
fn vector(u: &VoxelsUniforms, rays: &[f32], at: i32, component: usize) -> Vec3 {
    let count = (u.dispatch.x * u.dispatch.y) as i32;
    let c = |c: usize| read(rays, c as i32 * count + at);
    Vec3::new(c(component), c(component + 1), c(component + 2))
}

/// The unit direction in which pixel (x, y) looks, along the grid's axes.
#[inline(always)]
fn viewing(u: &VoxelsUniforms, x: i32, y: i32) -> Vec3 {
    let (width, height) = (u.dispatch.x as i32 as f32, u.dispatch.y as i32 as f32);
    let across = ((x as f32 + 0.5) / width * 2.0 - 1.0) * u.camera.x;
    let upwards = (1.0 - (y as f32 + 0.5) / height * 2.0) * u.camera.y;
    let perspective = select(u.camera.w > 0.5, 0.0, 1.0);
    let aim = xyz(u.away) + (xyz(u.right) * across + xyz(u.up) * upwards) * perspective;
    aim * (1.0 / max(length(aim), 1e-20))
}

/// Where the first surface mirrors pixel (x, y); its own direction where there is none.
#[inline(always)]
fn mirrored(u: &VoxelsUniforms, rays: &[f32], x: i32, y: i32) -> Vec3 {
    let direction = viewing(u, x, y);
    let normal = vector(u, rays, y * u.dispatch.x as i32 + x, path::NORMAL);
    direction - normal * (2.0 * dot(direction, normal))
}

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
fn seen(u: &VoxelsUniforms, map: &[f32], d: Vec3, across: Vec3, down: Vec3) -> Vec3 {
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

/// The finished pixel (x, y).
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &VoxelsUniforms, _mode: u32, rays: &[f32], map: &[f32]) -> [f32; view::SIZE] {
    let (x, y) = (x as i32, y as i32);
    let at = y * u.dispatch.x as i32 + x;
    let count = (u.dispatch.x * u.dispatch.y) as i32;
    let component = |c: usize| read(rays, c as i32 * count + at);
    let (left, right, above, below) = around(u, x, y);
    let direction = leaving(u, rays, x, y);
    let across = leaving(u, rays, right, y) - leaving(u, rays, left, y);
    let down = leaving(u, rays, x, below) - leaving(u, rays, x, above);
    let transmittance = vector(u, rays, at, path::TRANSMITTANCE);
    let through = seen(u, map, direction, across, down) * transmittance;
    let across = mirrored(u, rays, right, y) - mirrored(u, rays, left, y);
    let down = mirrored(u, rays, x, below) - mirrored(u, rays, x, above);
    let reflectance = component(path::REFLECTANCE);
    let reflected = seen(u, map, mirrored(u, rays, x, y), across, down) * reflectance;
    let bounces = component(path::BOUNCES);
    // Without an environment the picture is transparent where there is no surface.
    let visible = select(bounces > 0.0, 1.0, u.environment_nadir.w);
    let color = (through + reflected) * visible;
    let normal = in_view(u, vector(u, rays, at, path::NORMAL));
    let towards = in_view(u, direction);
    let voxel = u.scale.x;
    let depth = component(path::DEPTH) * voxel * dot(xyz(u.away), viewing(u, x, y));
    let status = component(path::STATUS);
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
        select(bounces > 0.0, depth, 0.0),
        towards.x,
        towards.y,
        towards.z,
        transmittance.x,
        transmittance.y,
        transmittance.z,
        reflectance,
        // One that is still under way did not get out.
        select(status == fate::ACTIVE, fate::TRAPPED, min(status, fate::TRAPPED)),
    ]
}

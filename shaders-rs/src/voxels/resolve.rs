//! Finished pixels: radiance of opaque bodies, receivers and the environment, by refraction (Chang et al. 2010, §4) and by reflection
//! at the first surface (Fresnel's equations, Cook & Torrance 1982). What further surfaces reflect has the environment's mean radiance.

use super::ending::{Beside, brought, point, surroundings};
use super::mirror::{first_surface, mirrored, vector, viewing};
use super::shade::shade;
use crate::abi::receivers::ahead;
use crate::abi::record::{MeshPixel, fate, mirror, path, view};
use crate::abi::voxels::{VoxelsUniforms, seen};
use crate::field::access::read;
use crate::math::{dot, select, select_vector, xyz};
use spirv_std::glam::Vec3;

/// A direction in view space (looking along −z).
#[inline(always)]
fn in_view(u: &VoxelsUniforms, v: Vec3) -> Vec3 {
    Vec3::new(dot(xyz(u.right), v), dot(xyz(u.up), v), -dot(xyz(u.away), v))
}

/// The finished pixel (x, y).
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &VoxelsUniforms,
    mode: u32,
    rays: &[f32],
    pictures: &[f32],
    corners: &[f32],
    looks: &[f32],
    shadow: &[u32],
    mirrors: &[f32],
) -> [f32; view::SIZE] {
    let (x, y) = (x as i32, y as i32);
    let at = y * u.dispatch.width as i32 + x;
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    let component = |c: usize| read(rays, c as i32 * count + at);
    let direction = vector(u, rays, at, path::DIRECTION);
    let transmittance = vector(u, rays, at, path::TRANSMITTANCE);
    let bounces = component(path::BOUNCES);
    let status = component(path::STATUS);
    let surfaces = mode == seen::SURFACES;
    let met = surfaces & (status == fate::MET);
    let beside = Beside::new(u, rays, x, y, bounces, status);
    let through = brought(u, mode, at, &beside, rays, pictures, corners, looks, shadow);
    let clear_normal = vector(u, rays, at, path::NORMAL);
    let first_normal = select_vector(met & (bounces == 0.0), through.normal, clear_normal);
    let reflectance = component(path::REFLECTANCE);
    let towards_mirrored = mirrored(u, rays, x, y);
    let mut reflected = surroundings(u, pictures, towards_mirrored, beside.mirrored(towards_mirrored));
    if surfaces & (reflectance > 0.0) {
        let record = |component: usize| read(mirrors, component as i32 * count + at);
        let triangle = record(mirror::TRIANGLE) as i32;
        if triangle != ahead::NOTHING {
            let from = first_surface(u, x, y, component(path::DEPTH));
            let position = from + towards_mirrored * record(mirror::DISTANCE);
            let point = point(u, corners, looks, triangle, position);
            reflected = shade(u, pictures, shadow, &point, towards_mirrored);
        }
    }
    let reflected = reflected * reflectance;
    // Without an environment the picture is transparent where there is no surface.
    let something = (bounces > 0.0) | met;
    let visible = select(something, 1.0, u.environment.visible);
    let color = (through.radiance + reflected) * visible;
    let voxel = u.voxel;
    let depth = component(path::DEPTH) * voxel * dot(xyz(u.away), viewing(u, x, y));
    let pixel = MeshPixel {
        color,
        coverage: visible,
        normal: in_view(u, first_normal),
        bounces,
        length: component(path::LENGTH) * voxel,
        depth: select(something, depth, 0.0),
        direction: in_view(u, direction),
        transmittance,
        reflectance,
        // One that is still under way did not get out.
        status: select((status == fate::ACTIVE) | (status == fate::SEEKS), fate::TRAPPED, status),
    };
    pixel.store()
}

//! Finished pixels: radiance of opaque bodies, receivers and the environment, by refraction (Chang et al. 2010, §4) and by reflection
//! at the first surface (Fresnel's equations, Cook & Torrance 1982).

use super::mirror::{first_surface, mirrored, vector, viewing};
use super::shade::{Point, facing, on_receiver, on_triangle, shade};
use crate::abi::receivers::ahead;
use crate::abi::record::{MeshPixel, fate, mirror, path, view};
use crate::abi::voxels::{VoxelsUniforms, seen};
use crate::field::access::read;
use crate::math::{dot, length, max, select, xyz};
use crate::optics::environment::{environment, in_environment};
use spirv_std::glam::Vec3;

/// A pixel next to another.
#[derive(Clone, Copy)]
struct Neighbour {
    /// Whether the pixel lies in the picture and its ray took the same way.
    alike: bool,
    /// The direction in which its ray left.
    leaves: Vec3,
    /// Whether the pixel's first surface mirrors its surroundings, too.
    mirrors: bool,
    /// The direction from which the mirrored light comes.
    mirrored: Vec3,
}

/// Pixel (x, y), beside a pixel whose ray met `bounces` surfaces and has status `status`.
#[inline(always)]
fn neighbour(u: &VoxelsUniforms, rays: &[f32], x: i32, y: i32, bounces: f32, status: f32) -> Neighbour {
    let (width, height) = (u.dispatch.width as i32, u.dispatch.height as i32);
    let there = (x >= 0) & (x < width) & (y >= 0) & (y < height);
    let at = if there { y * width + x } else { 0 };
    let component = |c: usize| read(rays, c as i32 * (width * height) + at);
    Neighbour {
        alike: there & (component(path::BOUNCES) == bounces) & (component(path::STATUS) == status),
        leaves: vector(u, rays, at, path::DIRECTION),
        mirrors: there & (component(path::REFLECTANCE) > 0.0),
        mirrored: mirrored(u, rays, x, y),
    }
}

/// The change of a unit direction from pixel to pixel, radians: by central differences over the two neighbours of the pixel with direction `own`, or by
/// one difference if only one neighbour counts; `usual` if neither does.
#[inline(always)]
fn apart(own: Vec3, (first, first_counts): (Vec3, bool), (last, last_counts): (Vec3, bool), usual: f32) -> f32 {
    let whole = 0.5 * length(last - first);
    let half = select(last_counts, length(last - own), length(own - first));
    select(first_counts & last_counts, whole, select(first_counts | last_counts, half, usual))
}

/// The environment in direction `d`, over an angle.
#[inline(always)]
fn surroundings(u: &VoxelsUniforms, pictures: &[f32], d: Vec3, angle: f32) -> Vec3 {
    environment(&u.environment, pictures, in_environment(&u.environment, d), angle)
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
    let mut first_normal = vector(u, rays, at, path::NORMAL);
    let left = neighbour(u, rays, x - 1, y, bounces, status);
    let right = neighbour(u, rays, x + 1, y, bounces, status);
    let above = neighbour(u, rays, x, y - 1, bounces, status);
    let below = neighbour(u, rays, x, y + 1, bounces, status);
    let usual = length(viewing(u, x + 1, y) - viewing(u, x, y));
    let across = apart(direction, (left.leaves, left.alike), (right.leaves, right.alike), usual);
    let down = apart(direction, (above.leaves, above.alike), (below.leaves, below.alike), usual);
    // What is behind nothing does not depend on what is beside it.
    let angle = select(bounces > 0.0, max(across, down), usual);
    let mut through = surroundings(u, pictures, direction, angle);
    if met {
        let triangle = component(path::TRIANGLE) as i32;
        let point = point(u, corners, looks, triangle, vector(u, rays, at, path::POSITION));
        through = shade(u, pictures, shadow, &point, direction);
        if bounces == 0.0 {
            first_normal = facing(&point, direction);
        }
    }
    let through = through * transmittance;
    let reflectance = component(path::REFLECTANCE);
    let towards_mirrored = mirrored(u, rays, x, y);
    let across = apart(towards_mirrored, (left.mirrored, left.mirrors), (right.mirrored, right.mirrors), usual);
    let down = apart(towards_mirrored, (above.mirrored, above.mirrors), (below.mirrored, below.mirrors), usual);
    let mut reflected = surroundings(u, pictures, towards_mirrored, max(across, down));
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
    let color = (through + reflected) * visible;
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

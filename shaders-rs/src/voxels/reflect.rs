//! Search for the opaque triangle or receiver that the first surface mirrors; clear bodies are ignored (not in Chang et al. 2010). The
//! search visits no node twice, so that its end is known beforehand.

use super::mirror::{first_surface, mirrored};
use super::ray::{Ray, first_receiver};
use super::surface::ior;
use super::tree;
use crate::abi::receivers::ahead;
use crate::abi::record::mirror::stage;
use crate::abi::record::{Mirror, mirror, path};
use crate::abi::voxels::{STEPS, VoxelsUniforms, corner};
use crate::field::access::read;
use crate::optics::receiver::FAR;

pub use super::ray::level;

#[inline(always)]
fn component(x: u32, y: u32, u: &VoxelsUniforms, rays: &[f32], component: usize) -> f32 {
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    read(rays, component as i32 * count + (y * u.dispatch.width + x) as i32)
}

/// Whether the search is under way.
#[inline(always)]
pub fn level(
    _x: u32,
    _y: u32,
    _u: &VoxelsUniforms,
    _mode: u32,
    before: [f32; mirror::SIZE],
    _rays: &[f32],
    _nodes: &[f32],
    _corners: &[f32],
    _materials: &[f32],
) -> u32 {
    if Mirror::load(&before).stage == stage::FOUND { level::ENDED } else { level::WORK }
}

/// The search after some nodes. A search without a mirror ends at once.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &VoxelsUniforms,
    _mode: u32,
    before: [f32; mirror::SIZE],
    rays: &[f32],
    nodes: &[f32],
    corners: &[f32],
    materials: &[f32],
) -> [f32; mirror::SIZE] {
    let search = Mirror::load(&before);
    if search.stage == stage::FOUND {
        return before;
    }
    if component(x, y, u, rays, path::REFLECTANCE) <= 0.0 {
        return Mirror { stage: stage::FOUND, node: 0, triangle: ahead::NOTHING, distance: FAR }.store();
    }
    let depth = component(x, y, u, rays, path::DEPTH);
    let (column, row) = (x as i32, y as i32);
    let mut ray = Ray::straight(first_surface(u, column, row, depth), mirrored(u, rays, column, row));
    if search.stage == stage::NEW {
        let receiver = first_receiver(u, ray.position, ray.direction);
        ray.triangle = receiver.which;
        ray.distance = receiver.distance;
    } else {
        ray.node = search.node;
        ray.triangle = search.triangle;
        ray.distance = search.distance;
    }
    let count = tree::count(nodes);
    let mut step = 0;
    while (step < 4 * STEPS) & (ray.node < count) {
        step += 1;
        let (triangle, distance) = (ray.triangle, ray.distance);
        tree::visit(&mut ray, nodes, corners);
        let met = ray.triangle != triangle;
        let at = if met { ray.triangle } else { 0 };
        let material = read(corners, at * corner::SIZE as i32 + corner::MATERIAL as i32) as i32;
        if met & (ior(material, materials) != 0.0) {
            ray.triangle = triangle;
            ray.distance = distance;
        }
    }
    let stage = if ray.node < count { stage::SEEKS } else { stage::FOUND };
    Mirror { stage, node: ray.node, triangle: ray.triangle, distance: ray.distance }.store()
}

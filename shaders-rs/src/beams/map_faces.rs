//! The maps of the bodies ([`super::maps`]), by rays through their triangles: from the light to the first surface, and where it is clear, back from behind all
//! bodies to the last one.
//!
//! The front map has opaque surfaces, and those of clear bodies that face the light; the back map those of clear bodies that look away from it.

use super::bend::facet_for;
use super::facet::Facet;
use super::maps::{Line, NO_MATERIAL};
use crate::abi::beams::BeamsUniforms;
use crate::abi::receivers::ahead;
use crate::abi::record::faces::{SIZE, stage};
use crate::abi::record::{Faces, Path};
use crate::abi::voxels::STEPS;
use crate::math::dot;
use crate::optics::receiver::first_ahead;
use crate::voxels::contact::{is_opaque, material_of, plane};
use crate::voxels::ray::CONTACT;
use crate::voxels::surface::ior;
use crate::voxels::tree;
use crate::voxels::triangle::{meet, shear};
use spirv_std::glam::Vec3;

pub use crate::voxels::ray::level;

/// The level of work: whether the search is under way.
#[inline(always)]
pub fn level(
    _x: u32,
    _y: u32,
    _u: &BeamsUniforms,
    _mode: u32,
    before: [f32; SIZE],
    _nodes: &[f32],
    _corners: &[f32],
    _materials: &[f32],
) -> u32 {
    if Faces::load(&before).stage == stage::DONE { level::ENDED } else { level::WORK }
}

/// The maps at texel (`x`, `y`) after some nodes.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    before: [f32; SIZE],
    nodes: &[f32],
    corners: &[f32],
    materials: &[f32],
) -> [f32; SIZE] {
    let mut faces = Faces::load(&before);
    let line = Line::new(u, x as i32, y as i32);
    if faces.stage == stage::NEW {
        // What is in front of the box does not hide it, as for pencils of light.
        let receiver = first_ahead(&u.receivers, line.at(line.enters), line.start.direction, CONTACT);
        faces.stage = if line.misses { stage::DONE } else { stage::FRONT };
        faces.triangle = receiver.which;
        faces.distance = receiver.distance;
        faces.front_triangle = ahead::NOTHING;
        faces.front_material = NO_MATERIAL;
        faces.back_material = NO_MATERIAL;
    }
    let last = tree::count(nodes);
    let mut step = 0;
    while (step < 4 * STEPS) & (faces.stage != stage::DONE) {
        step += 1;
        if faces.node < last {
            visit(&mut faces, &line, nodes, corners, materials);
        } else if faces.stage == stage::FRONT {
            end_front(&mut faces, &line, corners, materials);
        } else {
            end_back(&mut faces, &line, corners);
        }
    }
    faces.store()
}

/// The ray of a search: from the box's one side or from its other one.
#[inline(always)]
fn ray(faces: &Faces, line: &Line) -> Path {
    let front = faces.stage == stage::FRONT;
    let d = line.start.direction;
    if front { Path::straight(line.at(line.enters), d) } else { Path::straight(line.at(line.leaves), -d) }
}

/// Visits the next node of the tree.
#[inline(always)]
fn visit(faces: &mut Faces, line: &Line, nodes: &[f32], corners: &[f32], materials: &[f32]) {
    let mut ray = ray(faces, line);
    ray.node = faces.node;
    let triangle = tree::step(&mut ray, 0.0, faces.distance, nodes);
    faces.node = ray.node;
    if triangle < 0 {
        return;
    }
    let distance = meet(&shear(ray.position, ray.direction), corners, triangle).distance;
    let opaque = is_opaque(material_of(triangle, corners), materials);
    let faces_light = dot(line.start.direction, plane(triangle, corners)) < 0.0;
    let is_sought = if faces.stage == stage::FRONT { opaque | faces_light } else { !opaque & !faces_light };
    if is_sought & (distance < faces.distance) {
        faces.distance = distance;
        faces.triangle = triangle;
    }
}

/// Writes the front map, and begins the search for the back behind a clear surface.
#[inline(always)]
fn end_front(faces: &mut Faces, line: &Line, corners: &[f32], materials: &[f32]) {
    faces.front_distance = line.enters + faces.distance;
    faces.front_triangle = faces.triangle;
    let mut clear = false;
    if faces.triangle >= 0 {
        let material = material_of(faces.triangle, corners);
        let index = ior(material, materials);
        clear = index > 0.0;
        let facet = Facet::new(corners, faces.triangle, line.at(faces.front_distance));
        let facet = facet_for(facet, line.start.direction, 1.0, if clear { index } else { 1.0 });
        faces.front_normal = facet.facing(line.start.direction).normal;
        faces.front_material = material;
    }
    faces.stage = if clear { stage::BACK } else { stage::DONE };
    faces.node = 0;
    faces.triangle = ahead::NOTHING;
    faces.distance = line.leaves - line.enters;
}

/// Writes the back map.
#[inline(always)]
fn end_back(faces: &mut Faces, line: &Line, corners: &[f32]) {
    faces.stage = stage::DONE;
    if faces.triangle >= 0 {
        faces.back_distance = line.leaves - faces.distance;
        faces.back_material = material_of(faces.triangle, corners);
        let facet = Facet::new(corners, faces.triangle, line.at(faces.back_distance));
        let turned: Vec3 = -line.start.direction;
        let facet = facet.flat_if(dot(facet.normal, turned) * dot(facet.plane, turned) <= 0.0);
        faces.back_normal = facet.facing(turned).normal;
    }
}

//! Light through clear bodies by maps ([`super::maps`]): refracted by the front map and again by the back map, to the position p₁ and the direction of Hu
//! et al. (2010, §5.1).
//!
//! Where a refracted ray comes to the back is found in the back map alone (Hu & Qin 2007): points of the ray are projected into the lattice, and their
//! distances from the light are compared with the map's. [`MARCH`] even steps to the end of the box look for the first point behind the map, [`HALVINGS`]
//! halvings and a linear step between its two sides for the place.

use super::maps::{Back, Front, Line};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Way, way};
use crate::math::{dot, max, select, xyz};
use crate::voxels::ray::{reciprocal, slab};
use crate::voxels::surface::{bend, ior};
use spirv_std::glam::Vec3;

/// Even steps through the box of all surfaces.
pub const MARCH: u32 = 16;

/// Halvings of the step in which a ray comes behind the back map.
pub const HALVINGS: u32 = 8;

/// The distance along a ray from `position` along `direction`, which the front map has refracted, at which it comes to the back map.
#[inline(always)]
fn to_back(u: &BeamsUniforms, faces: &[f32], material: i32, position: Vec3, direction: Vec3) -> f32 {
    let inverse = Vec3::new(reciprocal(direction.x), reciprocal(direction.y), reciprocal(direction.z));
    let (_, reach) = slab(position, inverse, xyz(u.low), xyz(u.high));
    let reach = max(reach, 0.0);
    let step = reach * (1.0 / MARCH as f32);
    // The ray is in front of the map at the one distance, and behind it at the other.
    let (mut near, mut near_gap) = (0.0, 0.0);
    let (mut far, mut far_gap) = (reach, 1.0);
    let mut found = false;
    let mut number = 0;
    while number < MARCH + HALVINGS {
        let marches = number < MARCH;
        let s = if marches { step * (number + 1) as f32 } else { 0.5 * (near + far) };
        if !(marches & found) {
            let gap = Back::at(u, faces, material, position + direction * s).gap;
            if gap >= 0.0 {
                far = s;
                far_gap = gap;
                found = true;
            } else {
                near = s;
                near_gap = gap;
            }
        }
        number += 1;
    }
    near + (far - near) * (-near_gap / max(far_gap - near_gap, 1e-20))
}

/// The way of the light of texel (x, y) through a clear body.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, faces: &[f32], materials: &[f32]) -> [f32; way::SIZE] {
    let count = u.dispatch.width * u.dispatch.height;
    let front = Front::load(faces, (y * u.dispatch.width + x) as i32, count as i32);
    let zero = Vec3::new(0.0, 0.0, 0.0);
    // Where light does not get through, all of it is reflected.
    let mut way = Way { position: zero, direction: zero, normal: zero, reflectance: 1.0, length: 0.0 };
    let index = if front.triangle >= 0 { ior(front.material, materials) } else { 0.0 };
    if index <= 0.0 {
        return way.store();
    }
    let line = Line::new(u, x as i32, y as i32);
    let position = line.at(front.distance);
    let into = bend(line.start.direction, front.normal, 1.0, index);
    if into.reflected {
        return way.store();
    }
    let length = to_back(u, faces, front.material, position, into.direction);
    way.position = position + into.direction * length;
    way.normal = Back::at(u, faces, front.material, way.position).normal;
    way.length = length;
    let out = bend(into.direction, way.normal, index, 1.0);
    way.direction = out.direction;
    // A place without a back has no normal, and one that looks against the ray is none that light leaves by.
    let leaves = dot(way.normal, into.direction) > 0.0;
    way.reflectance = select(leaves, out.reflectance, 1.0);
    way.store()
}

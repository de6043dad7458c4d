//! The nearest triangle along a ray: a walk through a bounding volume hierarchy without a stack, whose nodes name the node behind all
//! that are below them.

use super::ray::{Ray, reciprocal, slab};
use super::triangle::{meet, shear};
use crate::abi::voxels::node;
use crate::field::access::{read, read_vector};
use crate::math::min;
use spirv_std::glam::Vec3;

/// The number of nodes of a tree.
#[inline(always)]
pub fn count(nodes: &[f32]) -> i32 {
    nodes.len() as i32 / node::SIZE as i32
}

/// Moves the ray on from its next node to the node behind. The result is the node's triangle if it has one and the ray comes through its box
/// between the distances `start` and `reach`, else −1.
#[inline(always)]
pub fn step(ray: &mut Ray, start: f32, reach: f32, nodes: &[f32]) -> i32 {
    let d = ray.direction;
    let at = ray.node * node::SIZE as i32;
    let inverse = Vec3::new(reciprocal(d.x), reciprocal(d.y), reciprocal(d.z));
    let (enters, leaves) = slab(ray.position, inverse, read_vector(nodes, at), read_vector(nodes, at + 3));
    let reached = (enters <= min(leaves, reach)) & (leaves >= start);
    let triangle = read(nodes, at + node::TRIANGLE as i32) as i32;
    ray.node = if reached { ray.node + 1 } else { read(nodes, at + node::BEHIND as i32) as i32 };
    if reached { triangle } else { -1 }
}

/// Visits the ray's next node, and moves on to the node behind.
#[inline(always)]
pub fn visit(ray: &mut Ray, nodes: &[f32], corners: &[f32]) {
    let triangle = step(ray, 0.0, ray.distance, nodes);
    if triangle >= 0 {
        let hit = meet(&shear(ray.position, ray.direction), corners, triangle);
        if hit.distance < ray.distance {
            ray.distance = hit.distance;
            ray.triangle = triangle;
        }
    }
}

//! Where light leaves a body by its maps, and how that changes from texel to texel: the differences that the derivatives of a beam are.

use super::maps::{Front, Line, NO_MATERIAL, of_texel, vector_of_texel};
use super::spread::Spread;
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::way;
use crate::math::{absolute, dot, length, max};
use crate::voxels::surface::{bend, ior};
use spirv_std::glam::Vec3;

/// Cosine of the angle between the normals of two texels beside each other above which they are on one smooth surface: 45°.
const CREASE: f32 = 0.707_106_77;

/// Share of the way from one texel to the next, on a surface, by which it may lead away from the surface: more is a jump from a body to another.
const JUMP: f32 = 0.5;

/// The light of a texel where it leaves a body.
#[derive(Clone, Copy)]
pub struct Exit {
    /// Position.
    pub position: Vec3,
    /// Unit direction.
    pub direction: Vec3,
    /// Unit normal there.
    normal: Vec3,
    /// Position on the front map.
    front: Vec3,
    /// Unit normal there.
    front_normal: Vec3,
    /// The number of the front's material; none where no light leaves.
    material: i32,
}

/// The light of texel (`column`, `row`) as it leaves a body: reflected by its front, or else refracted through it.
#[inline(always)]
pub fn exit(
    u: &BeamsUniforms,
    faces: &[f32],
    ways: &[f32],
    materials: &[f32],
    column: i32,
    row: i32,
    reflects: bool,
) -> Exit {
    let texels = u.lattice.count as i32;
    let count = texels * texels;
    let number = row * texels + column;
    let front = Front::load(faces, number, count);
    let line = Line::new(u, column, row);
    let position = line.at(front.distance);
    let inside = (column >= 0) & (row >= 0) & (column < texels) & (row < texels);
    let is_body = inside & !line.misses & (front.triangle >= 0);
    let index = if is_body { ior(front.material, materials) } else { 0.0 };
    let is_one = (index > 0.0) | (reflects & (index < 0.0));
    let leaves = is_one & (reflects | (of_texel(ways, way::REFLECTANCE, number, count) < 1.0));
    let material = if leaves { front.material } else { NO_MATERIAL };
    if reflects {
        Exit {
            position,
            direction: bend(line.start.direction, front.normal, 1.0, 1.0).mirrored,
            normal: front.normal,
            front: position,
            front_normal: front.normal,
            material,
        }
    } else {
        Exit {
            position: vector_of_texel(ways, way::POSITION, number, count),
            direction: vector_of_texel(ways, way::DIRECTION, number, count),
            normal: vector_of_texel(ways, way::NORMAL, number, count),
            front: position,
            front_normal: front.normal,
            material,
        }
    }
}

impl Exit {
    /// Whether the light of another texel takes the same way over the same smooth surfaces.
    #[inline(always)]
    fn is_like(&self, other: &Self) -> bool {
        let (step, front_step) = (other.position - self.position, other.front - self.front);
        let size = length(front_step);
        (other.material >= 0)
            & (other.material == self.material)
            & (dot(self.normal, other.normal) > CREASE)
            & (dot(self.front_normal, other.front_normal) > CREASE)
            & (absolute(dot(front_step, self.front_normal)) <= JUMP * size)
            & (absolute(dot(step, self.normal)) <= JUMP * max(length(step), size))
    }
}

/// The derivatives of the light of a texel where it leaves a body: half the differences between the texels on its two sides, or the difference from one of
/// them where the other one is on no surface, or on another one; 0 where both are.
#[inline(always)]
pub fn spread(
    u: &BeamsUniforms,
    faces: &[f32],
    ways: &[f32],
    materials: &[f32],
    column: i32,
    row: i32,
    reflects: bool,
) -> Spread {
    let own = exit(u, faces, ways, materials, column, row, reflects);
    let zero = Vec3::new(0.0, 0.0, 0.0);
    let mut spread = Spread { position_u: zero, position_v: zero, direction_u: zero, direction_v: zero };
    let mut axis = 0;
    while axis < 2 {
        let (right, down) = (1 - axis, axis);
        let (mut position, mut direction, mut sides) = (zero, zero, 0.0);
        let mut side = -1;
        while side <= 1 {
            let other = exit(u, faces, ways, materials, column + side * right, row + side * down, reflects);
            if own.is_like(&other) {
                position += (other.position - own.position) * side as f32;
                direction += (other.direction - own.direction) * side as f32;
                sides += 1.0;
            }
            side += 2;
        }
        let share = 1.0 / max(sides, 1.0);
        if axis == 0 {
            spread.position_u = position * share;
            spread.direction_u = direction * share;
        } else {
            spread.position_v = position * share;
            spread.direction_v = direction * share;
        }
        axis += 1;
    }
    spread
}

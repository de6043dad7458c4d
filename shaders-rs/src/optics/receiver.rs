//! Diffuse receivers: the ground and the wall.

use crate::abi::sweep::{SweepUniforms, flag};
use crate::abi::vector::Vec4;
use crate::field::light::Light;
use crate::math::{absolute, dot, length, max, min, select, xyz};
use spirv_std::glam::Vec3;

/// Where a segment meets a receiver.
#[derive(Clone, Copy)]
pub struct Hit {
    /// Whether it does.
    pub hit: bool,
    /// Share of the segment before it, 0 to 1 (or the ray parameter of [`first_along`]).
    pub at: f32,
    /// The receiver's normal.
    pub normal: Vec3,
    /// Its reflectance.
    pub color: Vec3,
}

/// The first receiver between `from` and `to`, crossed from its visible side.
#[inline(always)]
pub fn first_between(u: &SweepUniforms, from: Vec3, to: Vec3) -> Hit {
    let (ground, ground_at) = crossing(u.ground_plane, from, to);
    let (wall, wall_at) = crossing(u.wall_plane, from, to);
    choose(u, ground, ground_at, wall, wall_at)
}

/// The first receiver on the way from `from` along `direction`, `at` being the ray parameter.
#[inline(always)]
pub fn first_along(u: &SweepUniforms, from: Vec3, direction: Vec3) -> Hit {
    let (ground, ground_at) = meeting(u.ground_plane, from, direction);
    let (wall, wall_at) = meeting(u.wall_plane, from, direction);
    choose(u, ground, ground_at, wall, wall_at)
}

#[inline(always)]
fn choose(u: &SweepUniforms, ground: bool, ground_at: f32, wall: bool, wall_at: f32) -> Hit {
    let wall_first = wall & (!ground | (wall_at < ground_at));
    let pick = |w: Vec4, g: Vec4| {
        Vec3::new(select(wall_first, w.x, g.x), select(wall_first, w.y, g.y), select(wall_first, w.z, g.z))
    };
    Hit {
        hit: ground | wall,
        at: select(wall_first, wall_at, ground_at),
        normal: pick(u.wall_plane, u.ground_plane),
        color: pick(u.wall_color, u.ground_color),
    }
}

/// An absent receiver has the plane (0, 0, 0, 0): the distance is never positive, so nothing crosses it.
#[inline(always)]
fn crossing(plane: Vec4, from: Vec3, to: Vec3) -> (bool, f32) {
    let a = dot(xyz(plane), from) + plane.w;
    let b = dot(xyz(plane), to) + plane.w;
    ((a > 0.0) & (b <= 0.0), a / max(a - b, 1e-20))
}

/// How many of the steps behind the one from `from` to `to`, all alike, cross no receiver either: that or fewer.
#[inline(always)]
pub fn free_steps(u: &SweepUniforms, from: Vec3, to: Vec3) -> f32 {
    min(free_of(u.ground_plane, from, to), free_of(u.wall_plane, from, to))
}

#[inline(always)]
fn free_of(plane: Vec4, from: Vec3, to: Vec3) -> f32 {
    let a = dot(xyz(plane), from) + plane.w;
    let b = dot(xyz(plane), to) + plane.w;
    // Only what is in front and comes nearer can meet it.
    select((b > 0.0) & (a > b), min(0.99 * b / max(a - b, 1e-20), 65536.0), 65536.0)
}

#[inline(always)]
fn meeting(plane: Vec4, from: Vec3, direction: Vec3) -> (bool, f32) {
    let distance = dot(xyz(plane), from) + plane.w;
    let speed = -dot(xyz(plane), direction);
    ((distance > 0.0) & (speed > 1e-9), distance / max(speed, 1e-9))
}

/// Radiance of light at a point: L = E / cos θ where the light buffer holds plane irradiance.
#[inline(always)]
pub fn radiance(u: &SweepUniforms, light: &Light) -> Vec3 {
    let size = length(light.direction);
    let stored = u.dispatch.w & flag::STORE_RADIANCE != 0;
    light.flux * select(stored, 1.0, size / max(light.direction.z, 1e-6 * size))
}

/// Radiance that a receiver sends back: reflectance · (L cos θ + ambient).
#[inline(always)]
pub fn shade(u: &SweepUniforms, hit: &Hit, light: &Light) -> Vec3 {
    let cosine = max(-dot(hit.normal, light.direction) / max(length(light.direction), 1e-20), 0.0);
    hit.color * (radiance(u, light) * absolute(cosine) + xyz(u.ambient))
}

/// The light where nothing is in its way.
#[inline(always)]
pub fn unoccluded(u: &SweepUniforms) -> Light {
    Light { flux: xyz(u.light_initial), direction: xyz(u.light_direction) }
}

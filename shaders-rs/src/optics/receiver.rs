//! Diffuse receivers: the ground and the wall, and what a segment meets of them.

use crate::abi::receivers::{Receiver, Receivers, ahead};
use crate::abi::vector::Affine;
use crate::math::{absolute, affine, dot, length, max, min, select, select_vector, xyz};
use spirv_std::glam::Vec3;

/// The distance of a miss.
pub const FAR: f32 = 1e30;

/// Where a segment crosses a receiver.
#[derive(Clone, Copy)]
pub struct Hit {
    /// Whether it does.
    pub hit: bool,
    /// Whether the receiver is the wall.
    pub is_wall: bool,
    /// Whether the receiver is a body within the volume.
    pub is_body: bool,
    /// Share of the segment before it, 0 to 1.
    pub at: f32,
    /// The receiver's unit normal.
    pub normal: Vec3,
    /// Its reflectance.
    pub color: Vec3,
}

/// The first receiver between `from` and `to`, crossed from its visible side.
#[inline(always)]
pub fn first_between(receivers: &Receivers, from: Vec3, to: Vec3) -> Hit {
    let Receivers { ground, wall } = receivers;
    let (ground_hit, ground_at) = crossing(ground.plane, from, to);
    let (wall_hit, wall_at) = crossing(wall.plane, from, to);
    let wall_first = wall_hit & (!ground_hit | (wall_at < ground_at));
    let (normal, color) = surface(receivers, wall_first);
    let at = select(wall_first, wall_at, ground_at);
    Hit { hit: ground_hit | wall_hit, is_wall: wall_first, is_body: false, at, normal, color }
}

impl Hit {
    /// This hit or `other`, whichever the segment meets first.
    #[inline(always)]
    #[must_use]
    pub fn or_nearer(self, other: Self) -> Self {
        let nearer = other.hit & (!self.hit | (other.at < self.at));
        Self {
            hit: self.hit | other.hit,
            is_wall: (nearer & other.is_wall) | (!nearer & self.is_wall),
            is_body: (nearer & other.is_body) | (!nearer & self.is_body),
            at: select(nearer, other.at, self.at),
            normal: select_vector(nearer, other.normal, self.normal),
            color: select_vector(nearer, other.color, self.color),
        }
    }
}

/// The unit normal and the reflectance of the wall, or of the ground.
#[inline(always)]
pub fn surface(receivers: &Receivers, wall: bool) -> (Vec3, Vec3) {
    let Receiver { plane, color } = receivers.wall;
    let ground = receivers.ground;
    (
        select_vector(wall, xyz(plane.factors), xyz(ground.plane.factors)),
        select_vector(wall, xyz(color), xyz(ground.color)),
    )
}

/// An absent receiver's distance is 0 everywhere, never positive, so nothing crosses it.
#[inline(always)]
fn crossing(plane: Affine, from: Vec3, to: Vec3) -> (bool, f32) {
    let (a, b) = (affine(plane, from), affine(plane, to));
    ((a > 0.0) & (b <= 0.0), a / max(a - b, 1e-20))
}

/// A lower bound of the number of steps behind the one from `from` to `to`, all alike, that cross no receiver either.
#[inline(always)]
pub fn free_steps(receivers: &Receivers, from: Vec3, to: Vec3) -> f32 {
    min(free_of(receivers.ground.plane, from, to), free_of(receivers.wall.plane, from, to))
}

#[inline(always)]
fn free_of(plane: Affine, from: Vec3, to: Vec3) -> f32 {
    let (a, b) = (affine(plane, from), affine(plane, to));
    // Only a point in front that comes nearer can meet it.
    select((b > 0.0) & (a > b), min(0.99 * b / max(a - b, 1e-20), 65536.0), 65536.0)
}

/// A receiver ahead of a ray.
#[derive(Clone, Copy)]
pub struct Ahead {
    /// One of [`ahead`].
    pub which: i32,
    /// The ray parameter at which it is; [`FAR`] if there is none.
    pub distance: f32,
}

/// The first receiver on the way from `position` along `direction`, each taken to be nearer by `nearer`.
#[inline(always)]
pub fn first_ahead(receivers: &Receivers, position: Vec3, direction: Vec3, nearer: f32) -> Ahead {
    let ground = distance(receivers.ground.plane, position, direction, nearer);
    let wall = distance(receivers.wall.plane, position, direction, nearer);
    let nothing = (ground >= FAR) & (wall >= FAR);
    let which = if wall < ground { ahead::WALL } else { ahead::GROUND };
    Ahead { which: if nothing { ahead::NOTHING } else { which }, distance: select(wall < ground, wall, ground) }
}

/// The ray parameter at which a ray meets a plane from its visible side; [`FAR`] if it does not.
#[inline(always)]
fn distance(plane: Affine, position: Vec3, direction: Vec3, nearer: f32) -> f32 {
    let height = affine(plane, position);
    let speed = -dot(xyz(plane.factors), direction);
    let met = (height > 0.0) & (speed > 1e-9);
    select(met, max(height / max(speed, 1e-9) - nearer, 0.0), FAR)
}

/// Radiance that a diffuse surface of unit normal `normal` sends back: reflectance · (L cos θ + ambient), for light of radiance L that travels
/// along `direction`.
#[inline(always)]
pub fn diffuse(color: Vec3, normal: Vec3, direction: Vec3, radiance: Vec3, ambient: Vec3) -> Vec3 {
    let cosine = max(-dot(normal, direction) / max(length(direction), 1e-20), 0.0);
    color * (radiance * absolute(cosine) + ambient)
}

//! The derivatives of a ray: transfer along it, reflection and refraction (Igehy 1999).

use super::facet::Facet;
use crate::math::{dot, length, max, min, sqrt};
use spirv_std::glam::Vec3;

/// Changes of a ray's position and direction over a texel of the lattice, or over a pixel, along its two coordinates.
#[derive(Clone, Copy)]
pub struct Spread {
    /// Change of the position along the first coordinate.
    pub position_u: Vec3,
    /// Change of the position along the second coordinate.
    pub position_v: Vec3,
    /// Change of the direction along the first coordinate.
    pub direction_u: Vec3,
    /// Change of the direction along the second coordinate.
    pub direction_v: Vec3,
}

/// A surface that bends a ray, and the bend.
#[derive(Clone, Copy)]
pub struct Bending {
    /// Unit direction of the ray before the surface.
    pub direction: Vec3,
    /// Unit normal that the ray is bent by, on the side that it comes from.
    pub normal: Vec3,
    /// Index of refraction on that side over the index on the other one.
    pub ratio: f32,
    /// Whether the ray is reflected.
    pub reflected: bool,
}

impl Bending {
    /// The change of the direction behind the surface for a change `change` of the direction before it and `turn` of the normal.
    #[inline(always)]
    fn change(&self, change: Vec3, turn: Vec3) -> Vec3 {
        let Self { direction, normal, ratio, reflected } = *self;
        let cosine = -dot(direction, normal);
        let cosine_change = -(dot(change, normal) + dot(direction, turn));
        if reflected {
            change + (turn * cosine + normal * cosine_change) * 2.0
        } else {
            let refracted = sqrt(max(1.0 - ratio * ratio * (1.0 - cosine * cosine), 1e-12));
            let along = ratio * cosine - refracted;
            let along_change = (ratio - ratio * ratio * cosine / refracted) * cosine_change;
            change * ratio + turn * along + normal * along_change
        }
    }
}

/// The most by which a direction is taken to change over a texel, radians: where a surface bends more within a texel, its derivative tells little of where
/// the texel's light goes, and the light is spread over this angle.
const WIDEST: f32 = 0.5;

/// A vector, no longer than [`WIDEST`].
#[inline(always)]
fn limited(v: Vec3) -> Vec3 {
    v * min(1.0, WIDEST / max(length(v), 1e-20))
}

impl Spread {
    /// The changes, of which those of the direction are limited to what a linear function of the texel describes.
    #[inline(always)]
    #[must_use]
    pub fn limited(self) -> Self {
        Self { direction_u: limited(self.direction_u), direction_v: limited(self.direction_v), ..self }
    }

    /// The changes `distance` ahead, at the same distance from the start.
    #[inline(always)]
    #[must_use]
    pub fn moved(self, distance: f32) -> Self {
        Self {
            position_u: self.position_u + self.direction_u * distance,
            position_v: self.position_v + self.direction_v * distance,
            ..self
        }
    }

    /// The changes on a plane of unit normal `plane` that the ray along `direction` meets here.
    #[inline(always)]
    #[must_use]
    pub fn on_plane(self, direction: Vec3, plane: Vec3) -> Self {
        let facing = dot(direction, plane);
        let inverse = if facing * facing > 1e-12 { 1.0 / facing } else { 0.0 };
        Self {
            position_u: self.position_u - direction * (dot(self.position_u, plane) * inverse),
            position_v: self.position_v - direction * (dot(self.position_v, plane) * inverse),
            ..self
        }
    }

    /// The changes behind a surface; those of the position are on the surface already.
    #[inline(always)]
    #[must_use]
    pub fn bent(self, bending: &Bending, facet: &Facet) -> Self {
        Self {
            direction_u: bending.change(self.direction_u, facet.turn(self.position_u)),
            direction_v: bending.change(self.direction_v, facet.turn(self.position_v)),
            ..self
        }
    }
}

//! Airlight: the light of the source that the medium scatters into a viewing ray where nothing is in its way (Sun et al. 2005), by Gauss's
//! quadrature for any phase function.

use super::medium::{phase, transmittance, way_from};
use crate::abi::beams::BeamsUniforms;
use crate::abi::light::{LightSource, kind};
use crate::math::{PI, dot, max, min, select, sqrt, xyz};
use crate::optics::light_source::arriving;
use spirv_std::glam::Vec3;

/// Parts of the ray, each with the four points of Gauss and Legendre. The faces of the medium's box leave kinks between which the rule is of
/// order 8.
const PARTS: i32 = 6;
/// Points of Gauss and Legendre on −1…1: the outer ones, then the inner ones, and their weights.
const OUTER: f32 = 0.861_136_3;
const INNER: f32 = 0.339_981_04;
const OUTER_WEIGHT: f32 = 0.347_854_85;
const INNER_WEIGHT: f32 = 0.652_145_15;

/// A part of a ray.
#[derive(Clone, Copy)]
struct Range {
    near: f32,
    far: f32,
}

/// The part of a ray that lies in a spot's cone.
#[inline(always)]
fn in_cone(source: &LightSource, from: Vec3, w: Vec3, range: Range) -> Range {
    let axis = xyz(source.direction);
    let offset = from - xyz(source.position);
    let scale = 1.0 + source.cone.tangent * source.cone.tangent;
    let (along, speed) = (dot(axis, offset), dot(axis, w));
    // Positive within the double cone: a t² + 2 b t + c.
    let a = scale * speed * speed - 1.0;
    let b = scale * speed * along - dot(offset, w);
    let c = scale * along * along - dot(offset, offset);
    let discriminant = b * b - a * c;
    let root = sqrt(discriminant);
    let inverse = 1.0 / select(a == 0.0, 1e-20, a);
    let (first, second) = ((-b - root) * inverse, (-b + root) * inverse);
    let (low, high) = (min(first, second), max(first, second));
    if a < 0.0 {
        // The ray crosses one of the two cones from side to side.
        let ahead = along + speed * (0.5 * (low + high)) > 0.0;
        let lit = (discriminant > 0.0) & ahead;
        Range { near: max(range.near, select(lit, low, range.far)), far: min(range.far, select(lit, high, range.near)) }
    } else {
        // It stays in the cone from where it enters, or leaves it once.
        let apex = -along / select(speed == 0.0, 1e-20, speed);
        let (into, out) = (select(discriminant > 0.0, high, apex), select(discriminant > 0.0, low, apex));
        Range {
            near: max(range.near, select(speed > 0.0, into, range.near)),
            far: min(range.far, select(speed > 0.0, range.far, out)),
        }
    }
}

/// A viewing ray, seen from the source: the coordinate m = tan(q/2) of the angle q from the foot of the source's perpendicular.
#[derive(Clone, Copy)]
struct Seen {
    distant: bool,
    /// Distance along the ray of the foot.
    foot: f32,
    /// Distance of the source from the ray.
    height: f32,
}

impl Seen {
    /// The coordinate of a distance along the ray.
    #[inline(always)]
    fn coordinate(&self, t: f32) -> f32 {
        let x = (t - self.foot) / self.height;
        select(self.distant, t, x / (1.0 + sqrt(1.0 + x * x)))
    }

    /// The distance along the ray of a coordinate, and its derivative.
    #[inline(always)]
    fn distance(&self, m: f32) -> (f32, f32) {
        let room = max(1.0 - m * m, 1e-9);
        let t = self.foot + self.height * (2.0 * m / room);
        let derivative = self.height * (2.0 * (1.0 + m * m) / (room * room));
        (select(self.distant, m, t), select(self.distant, 1.0, derivative))
    }
}

/// Radiance scattered into the ray at the coordinate `m`, by `m`, of a ray from `from` along `w` that enters the medium at the distance `enters`.
#[inline(always)]
fn at(u: &BeamsUniforms, pictures: &[f32], from: Vec3, w: Vec3, enters: f32, seen: &Seen, m: f32) -> Vec3 {
    let (t, derivative) = seen.distance(m);
    let position = from + w * t;
    let light = arriving(&u.light, pictures, position);
    let way = way_from(&u.medium, &u.light, position, light.direction);
    let dimmed = transmittance(&u.medium, way + max(t - enters, 0.0));
    let strength = PI * phase(&u.medium, -dot(light.direction, w)) * derivative;
    light.radiance * dimmed * xyz(u.medium.scattering) * strength
}

/// Airlight of the ray from `from` along the unit vector `w` between the distances `near` and `far`, which both are in the medium: radiance, dimmed by
/// the medium from the distance `near` on.
#[inline(always)]
pub fn airlight(u: &BeamsUniforms, pictures: &[f32], from: Vec3, w: Vec3, near: f32, far: f32) -> Vec3 {
    let mut range = Range { near, far };
    if u.light.kind == kind::SPOT {
        range = in_cone(&u.light, from, w, range);
    }
    let mut sum = Vec3::new(0.0, 0.0, 0.0);
    if range.far > range.near {
        let offset = xyz(u.light.position) - from;
        let foot = dot(offset, w);
        let across = offset - w * foot;
        let height = max(sqrt(dot(across, across)), 1e-6);
        let seen = Seen { distant: u.light.kind == kind::DISTANT, foot, height };
        let (begin, end) = (seen.coordinate(range.near), seen.coordinate(range.far));
        let half = (end - begin) * (0.5 / PARTS as f32);
        let mut part = 0;
        while part < PARTS {
            let middle = begin + half * (2.0 * part as f32 + 1.0);
            let value = |point: f32| at(u, pictures, from, w, near, &seen, middle + half * point);
            sum += (value(-OUTER) + value(OUTER)) * (half * OUTER_WEIGHT);
            sum += (value(-INNER) + value(INNER)) * (half * INNER_WEIGHT);
            part += 1;
        }
    }
    sum
}

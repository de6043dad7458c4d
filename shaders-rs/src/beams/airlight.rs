//! Airlight: the light of the source that the medium scatters into a viewing ray where nothing is in its way (Sun et al. 2005), by Gauss's
//! quadrature for any phase function.

use super::density::{density_at, optical_depth};
use super::medium::{depth_from, phase, transmittance};
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

/// A point of a ray.
#[derive(Clone, Copy)]
struct Point {
    /// Distance along the ray.
    t: f32,
    /// Its derivative by the ray's coordinate.
    derivative: f32,
    position: Vec3,
    /// The medium's density.
    density: f32,
}

/// A ray through the medium, and what its points are computed from.
#[derive(Clone, Copy)]
struct Ray<'a> {
    u: &'a BeamsUniforms,
    pictures: &'a [f32],
    materials: &'a [f32],
    from: Vec3,
    direction: Vec3,
    seen: Seen,
}

impl Ray<'_> {
    /// The point at the coordinate `m`.
    #[inline(always)]
    fn point(&self, m: f32) -> Point {
        let (t, derivative) = self.seen.distance(m);
        let position = self.from + self.direction * t;
        let medium = &self.u.medium;
        let density = if medium.nodes == 0 { 1.0 } else { density_at(medium, self.materials, position) };
        Point { t, derivative, position, density }
    }

    /// Radiance scattered into the ray at a point, by the coordinate; `depth` is the ray's optical depth up to there.
    #[inline(always)]
    fn scattered(&self, point: &Point, depth: f32) -> Vec3 {
        let Self { u, .. } = self;
        let light = arriving(&u.light, self.pictures, point.position);
        let way = depth_from(&u.medium, self.materials, &u.light, point.position, light.direction);
        let dimmed = transmittance(&u.medium, way + depth);
        let strength =
            PI * phase(&u.medium, -dot(light.direction, self.direction)) * (point.derivative * point.density);
        light.radiance * dimmed * xyz(u.medium.scattering) * strength
    }
}

/// Airlight of the ray from `from` along the unit vector `w` between the distances `near` and `far`, which both are in the medium: radiance, dimmed by
/// the medium from the distance `near` on.
#[inline(always)]
pub fn airlight(
    u: &BeamsUniforms,
    pictures: &[f32],
    materials: &[f32],
    from: Vec3,
    w: Vec3,
    near: f32,
    far: f32,
) -> Vec3 {
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
        let ray = Ray { u, pictures, materials, from, direction: w, seen };
        let homogeneous = u.medium.nodes == 0;
        let (begin, end) = (seen.coordinate(range.near), seen.coordinate(range.far));
        let parts = if 2 * PARTS < u.medium.nodes as i32 { u.medium.nodes as i32 / 2 } else { PARTS };
        let half = (end - begin) * (0.5 / parts as f32);
        // In a medium of varying density: the optical depth up to the part.
        let mut before = optical_depth(&u.medium, materials, from, w, near, range.near);
        let mut part = 0;
        while part < parts {
            let middle = begin + half * (2.0 * part as f32 + 1.0);
            let at = |point: f32| ray.point(middle + half * point);
            let (first, second, third, fourth) = (at(-OUTER), at(-INNER), at(INNER), at(OUTER));
            let measure = |point: &Point| point.density * point.derivative;
            let over = half
                * (OUTER_WEIGHT * (measure(&first) + measure(&fourth))
                    + INNER_WEIGHT * (measure(&second) + measure(&third)));
            // Within the part the depth grows in proportion to the coordinate.
            let depth = |point: &Point, place: f32| {
                select(homogeneous, max(point.t - near, 0.0), before + over * (0.5 + 0.5 * place))
            };
            let outer = ray.scattered(&first, depth(&first, -OUTER)) + ray.scattered(&fourth, depth(&fourth, OUTER));
            let inner = ray.scattered(&second, depth(&second, -INNER)) + ray.scattered(&third, depth(&third, INNER));
            sum += outer * (half * OUTER_WEIGHT);
            sum += inner * (half * INNER_WEIGHT);
            before += over;
            part += 1;
        }
    }
    sum
}

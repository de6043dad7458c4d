//! Refraction at a surface: Snell's law, total reflection, and Fresnel reflectance (Chang et al. 2010, §4.1.1, ref() in Eq. 1;
//! Fresnel's equations, Cook & Torrance 1982).

use super::ray::{Ray, attenuation};
use crate::abi::record::fate;
use crate::abi::voxels::{AIR, VoxelsUniforms, flag, material, mode};
use crate::field::access::read;
use crate::math::{dot, max, min, normalize, select, select_vector, sqrt};
use crate::optics::specular::fresnel;
use spirv_std::glam::Vec3;

/// A ray behind a surface.
#[derive(Clone, Copy)]
pub struct Bent {
    /// Unit direction behind the surface.
    pub direction: Vec3,
    /// Direction of what the surface reflects, of about unit length.
    pub mirrored: Vec3,
    /// Whether the reflection is total.
    pub reflected: bool,
    /// Fresnel reflectance, 0 to 1.
    pub reflectance: f32,
}

/// Snell's law for a ray along `direction` from index `from` to `to`, at a surface with the unit normal `normal` on either side.
#[inline(always)]
pub fn bend(direction: Vec3, normal: Vec3, from: f32, to: f32) -> Bent {
    let facing = dot(direction, normal);
    // The normal on the side that the ray comes from.
    let n = normal * select(facing > 0.0, -1.0, 1.0);
    let cosine = max(-dot(direction, n), 0.0);
    let ratio = from / to;
    let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    let reflected = squared <= 0.0;
    let passed = direction * ratio + n * (ratio * cosine - sqrt(squared));
    let mirrored = direction + n * (2.0 * cosine);
    let direction = normalize(select_vector(reflected, mirrored, passed));
    Bent { direction, mirrored, reflected, reflectance: fresnel(from, to, cosine) }
}

/// The index of refraction of a material, or of air.
#[inline(always)]
pub fn ior(medium: i32, materials: &[f32]) -> f32 {
    let index = read(materials, medium * material::SIZE as i32 + material::IOR as i32);
    select(medium == AIR, 1.0, index)
}

/// The share of the light from all sides that comes along the ray which a surface of reflectance `share` reflects, back into the medium
/// `from` that the ray is in.
///
/// It is an estimate for a body whose surfaces are all alike: each further way through the body is as long as the one that the ray has just
/// made, and has the transmittance t of that; at its end 1 − R leaves, and R goes on. With the ray's transmittance T up to here that is
/// T R (1 − R) t (1 + R t + (R t)² + …) = T R (1 − R) t / (1 − R t), the series of a plate (Born & Wolf 1999, §7.6.1, with intensities
/// in place of amplitudes). It is exact for a plate that is met straight on, and T R where nothing is absorbed. Air has t = 1.
#[inline(always)]
fn beyond(ray: &Ray, from: i32, share: f32, materials: &[f32]) -> Vec3 {
    // Before the first surface all of the way is that of an eye within a body.
    let way = select(ray.bounces == 0.0, ray.length, ray.since);
    let t = attenuation(from, way, materials);
    let leaves = |t: f32| {
        let t = select(from == AIR, 1.0, t);
        let room = 1.0 - share * t;
        // 0 where all is reflected and nothing absorbed: after many ways all of it leaves.
        select(room > 0.0, (1.0 - share) * t / max(room, 1e-9), 1.0)
    };
    ray.transmittance * Vec3::new(leaves(t.x), leaves(t.y), leaves(t.z)) * share
}

/// The sum of all channels.
#[inline(always)]
pub fn sum(color: Vec3) -> f32 {
    color.x + color.y + color.z
}

/// Surfaces that have a bit in a ray's `turns`: all whole numbers of as many bits are exact floats.
const COUNTED: i32 = 24;

/// `bits` without the highest bit that is set.
#[inline(always)]
fn without_highest(bits: i32) -> i32 {
    // The exponent of a float is the number of its highest bit.
    let highest = ((bits as f32).to_bits() >> 23) as i32 - 127;
    if bits == 0 { 0 } else { bits - (1 << highest) }
}

impl Ray {
    /// Whether the ray was reflected at the last surface that it met where it could have been refracted.
    #[inline(always)]
    pub fn has_turned(&self) -> bool {
        // Doubled, so that number 0 stands for no surface.
        let last = (2 * self.turns) >> min(self.bounces, COUNTED as f32 + 1.0) as i32;
        // While a reflection is kept, the highest bit is not a turn, and the last turn lies behind.
        (sum(self.kept) <= 0.0) & (last & 1 == 1)
    }

    /// Leaves the share of the light that the next surface reflects to the rest, or, if it is the greatest so far, keeps it for the next way.
    #[inline(always)]
    fn leave(&mut self, u: &VoxelsUniforms, from: i32, share: f32, materials: &[f32]) {
        let rest = beyond(self, from, share, materials);
        let number = self.bounces as i32;
        let keeps = (u.flags & flag::KEEPS != 0) & (number < COUNTED);
        if keeps & (sum(rest) > sum(self.kept)) {
            let turns = if sum(self.kept) > 0.0 { without_highest(self.turns) } else { self.turns };
            self.turns = turns | (1 << number);
            self.rest += self.kept;
            self.kept = rest;
        } else {
            self.rest += rest;
        }
    }
}

/// Refracts or reflects the ray at a surface with outward unit normal `normal`, from medium `from` to `to`; the ray then has a new
/// straight way. The result is whether the ray went through.
#[inline(always)]
pub fn meet(ray: &mut Ray, u: &VoxelsUniforms, mode: u32, normal: Vec3, from: i32, to: i32, materials: &[f32]) -> bool {
    let bent = bend(ray.direction, normal, ior(from, materials), ior(to, materials));
    let first = ray.bounces == 0.0;
    let share = select(u.flags & flag::FRESNEL != 0, bent.reflectance, 0.0);
    // What the first surface reflects to an eye in air is seen.
    let seen = first & (from == AIR);
    if first {
        ray.normal = normal;
        ray.reflectance = select(seen, share, 0.0);
    }
    // The bits of this surface and of those behind it: a reflection that is kept belongs to a surface before this one.
    let ahead = ray.turns >> min(ray.bounces, COUNTED as f32) as i32;
    let turns = ahead & 1 == 1;
    // Ways before this one have counted the surfaces up to its last turn.
    if !seen & !bent.reflected & (ahead == 0) {
        ray.leave(u, from, share, materials);
    }
    ray.bounces += 1.0;
    let second = (mode == mode::TWO_SURFACES) & (ray.bounces >= 2.0) & !turns;
    if bent.reflected & second {
        // Two surfaces have no place for a reflection in between: the ray leaves along the surface, as at the critical angle.
        let along = ray.direction - normal * dot(ray.direction, normal);
        ray.direction = normalize(along);
    } else if turns {
        ray.direction = normalize(bent.mirrored);
    } else {
        ray.direction = bent.direction;
    }
    if !bent.reflected {
        ray.transmittance *= select(turns, share, 1.0 - share);
    }
    ray.since = 0.0;
    ray.turn(u);
    let stays = bent.reflected | turns;
    let inside = if stays { from } else { to };
    let seeks = u.flags & flag::SEEKS != 0;
    if second & !seeks {
        ray.end(materials);
    } else if !second & !turns & (ray.bounces >= u.most_bounces as i32 as f32) & (inside != AIR) {
        ray.status = fate::TRAPPED;
    } else if seeks {
        ray.status = fate::SEEKS;
    }
    !stays
}

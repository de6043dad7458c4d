//! Refraction at a surface: Snell's law, total reflection, and Fresnel reflectance (Chang et al. 2010, §4.1.1, ref() in Eq. 1;
//! Fresnel's equations, Cook & Torrance 1982).

use super::ray::Ray;
use crate::abi::record::fate;
use crate::abi::voxels::{AIR, VoxelsUniforms, flag, material, mode};
use crate::field::access::read;
use crate::math::{dot, max, normalize, select, select_vector, sqrt};
use crate::optics::specular::fresnel;
use spirv_std::glam::Vec3;

/// A ray behind a surface.
#[derive(Clone, Copy)]
pub struct Bent {
    /// Unit direction behind the surface.
    pub direction: Vec3,
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
    Bent { direction, reflected, reflectance: fresnel(from, to, cosine) }
}

/// The index of refraction of a material, or of air.
#[inline(always)]
pub fn ior(medium: i32, materials: &[f32]) -> f32 {
    let index = read(materials, medium * material::SIZE as i32 + material::IOR as i32);
    select(medium == AIR, 1.0, index)
}

/// Refracts or reflects the ray at a surface with outward unit normal `normal`, from medium `from` to `to`; the ray then has a new
/// straight way. The result is whether the ray went through.
#[inline(always)]
pub fn meet(ray: &mut Ray, u: &VoxelsUniforms, mode: u32, normal: Vec3, from: i32, to: i32, materials: &[f32]) -> bool {
    let bent = bend(ray.direction, normal, ior(from, materials), ior(to, materials));
    let first = ray.bounces == 0.0;
    let share = select(u.flags & flag::FRESNEL != 0, bent.reflectance, 0.0);
    if first {
        ray.normal = normal;
        ray.reflectance = share;
    }
    ray.bounces += 1.0;
    let second = (mode == mode::TWO_SURFACES) & (ray.bounces >= 2.0);
    if bent.reflected & second {
        // Two surfaces have no place for a reflection in between: the ray leaves along the surface, as at the critical angle.
        let along = ray.direction - normal * dot(ray.direction, normal);
        ray.direction = normalize(along);
    } else {
        ray.direction = bent.direction;
    }
    if !bent.reflected {
        ray.transmittance *= 1.0 - share;
    }
    ray.turn(u);
    let inside = if bent.reflected { from } else { to };
    let seeks = u.flags & flag::SEEKS != 0;
    if second & !seeks {
        ray.end(materials);
    } else if !second & (ray.bounces >= u.most_bounces as i32 as f32) & (inside != AIR) {
        ray.status = fate::TRAPPED;
    } else if seeks {
        ray.status = fate::SEEKS;
    }
    !bent.reflected
}

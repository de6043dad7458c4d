//! Surfaces that reflect: layers in which η changes, of any thickness (sweep §4.3, which takes the change over one step for the surface's).
//!
//! A ray remembers η at the beginning of the layer in which it is. On each step the layer reflects by how much more it would reflect (Fresnel) if it ended
//! here: all steps together reflect as the whole layer does, whatever the distance of planes. A layer ends where η turns round, or where it hardly changes any
//! more. The first surface reflects the environment, too.

use crate::abi::record::Ray;
use crate::math::{absolute, clamp, dot, length, max, min, select, sqrt};
use crate::optics::specular::{fresnel, fresnel_from};
use spirv_std::glam::Vec3;

/// The thickest layer that is one surface, in voxels, if η changes in it as in a straight line.
const THICKEST: f32 = 12.0;
/// Reflectance of a surface from which on it is the first one: noise is none.
const FIRST: f32 = 0.004;

/// A step of a viewing ray through a layer.
pub struct Crossed {
    /// Normal of the layer, of any length; 0 where there is none.
    pub normal: Vec3,
    /// The optical direction in front of the step.
    pub v: Vec3,
    /// η in front of the step.
    pub before: f32,
    /// η behind it.
    pub behind: f32,
    /// Length of the step in voxels.
    pub voxels: f32,
    /// Whether η jumps, at a border.
    pub jumps: bool,
}

/// What a step makes of a layer.
#[derive(Clone, Copy)]
pub struct Surface {
    /// η at the layer's beginning.
    pub ior: f32,
    /// Reflectance that the step adds, in the direction of the viewing ray.
    pub reflectance: f32,
    /// The record's `layer_ior` behind the step.
    pub layer_ior: f32,
    /// The direction outside of the layer from which a mirror sends light along the ray, of unit length.
    pub mirrored: Vec3,
    /// Whether the surface is the first one.
    pub first: bool,
}

/// The layer behind a step.
#[inline(always)]
pub fn surface(ray: &Ray, known: f32, step: &Crossed) -> Surface {
    let Crossed { normal, v, before, behind, .. } = *step;
    let size = length(normal);
    let n = normal * (1.0 / max(size, 1e-20));
    let along = dot(v, n);
    let flat = size > 1e-12;

    let (change, run) = (behind - before, before - known);
    // At a border all of the surface is there.
    let begins = step.jumps | (change * run < 0.0);
    let start = select(begins, before, known);
    // An optical direction keeps its component along the layer, and its length is η.
    let side = v - n * along;
    let outside = sqrt(max(start * start - dot(side, side), 0.0));
    let cosine = outside / start;
    let added = fresnel(start, behind, cosine) - fresnel(start, before, cosine);
    let reflectance = select(flat & (change != 0.0), max(added, 0.0), 0.0);
    let mirrored = side - n * select(along < 0.0, -outside, outside);
    let mirrored = mirrored * (1.0 / max(length(mirrored), 1e-6));

    let depth = step.voxels * select(flat, absolute(along) / max(length(v), 1e-6), 1.0);
    let changes = absolute(change) * THICKEST >= absolute(behind - start) * depth;
    let forgotten = select(changes, 0.0, min(0.5 * depth, 1.0));
    let next = start + (behind - start) * forgotten;
    let next = select(step.jumps, behind, next);
    // The first surface is behind the ray where it begins another one, and where this one ends.
    let ended = (step.jumps | !changes | (begins & (run != 0.0))) & (ray.reflectance + reflectance > FIRST);
    let first = ray.layer_ior >= 0.0;
    let passed = !first | ended;
    Surface {
        ior: start,
        reflectance,
        layer_ior: select(passed, -next, next),
        mirrored,
        first: first & !(begins & !step.jumps & (ray.reflectance > FIRST)),
    }
}

/// η at the beginning of the layer in which a ray is, where `sampled` was sampled just now: a layer begins with what is sampled first.
#[inline(always)]
pub fn layer_ior(ray: &Ray, sampled: f32, unknown: bool) -> f32 {
    select(unknown | (ray.layer_ior == 0.0), sampled, max(ray.layer_ior, -ray.layer_ior))
}

/// The Fresnel reflectance that a step through `surface` adds for light that meets facets at cosine `cosine` on the step.
#[inline(always)]
pub fn added(surface: &Surface, step: &Crossed, cosine: f32) -> f32 {
    let here = length(step.v);
    let now = fresnel_from(surface.ior, step.behind, cosine, here);
    let until_now = fresnel_from(surface.ior, step.before, cosine, here);
    clamp(now - until_now, 0.0, 1.0)
}

/// The part of a ray's record that tells of surfaces.
#[derive(Clone, Copy)]
pub struct Reflected {
    /// See [`Ray`].
    pub layer_ior: f32,
    /// See [`Ray`].
    pub reflectance: f32,
    /// See [`Ray`].
    pub mirrored: Vec3,
}

impl Reflected {
    /// That of a ray.
    #[inline(always)]
    #[must_use]
    pub fn of(ray: &Ray) -> Self {
        Self { layer_ior: ray.layer_ior, reflectance: ray.reflectance, mirrored: ray.mirrored }
    }

    /// This, with what `surface` reflects, times `factor`, to the ray, which gathered `ray` until there.
    #[inline(always)]
    #[must_use]
    pub fn with(self, ray: &Ray, surface: &Surface, factor: f32) -> Self {
        let added = select(surface.first, surface.reflectance * factor, 0.0);
        let seen =
            (1.0 - ray.opacity) * ((ray.transmittance.x + ray.transmittance.y) + ray.transmittance.z) * (1.0 / 3.0);
        Self {
            layer_ior: surface.layer_ior,
            reflectance: min(self.reflectance + added, 1.0),
            mirrored: self.mirrored + surface.mirrored * (added * seen),
        }
    }
}

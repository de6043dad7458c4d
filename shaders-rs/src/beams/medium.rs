//! A medium in a box: transmittance and phase functions.

use super::density::optical_depth;
use crate::abi::beams::{Medium, phase};
use crate::abi::light::{LightSource, kind};
use crate::math::{PI, dot, exp, max, min, select, sqrt, xyz};
use crate::optics::receiver::FAR;
use crate::voxels::ray::{reciprocal, slab};
use spirv_std::glam::Vec3;

/// The part of a line that lies in the medium.
#[derive(Clone, Copy)]
pub struct Inside {
    /// Distance at which the line enters.
    pub enters: f32,
    /// Distance at which it leaves. A line that does not come into the medium enters and leaves it where it begins.
    pub leaves: f32,
}

/// The part in the medium of the line from `from` along the unit vector `direction` between the distances `near` and `far`.
#[inline(always)]
pub fn inside(medium: &Medium, from: Vec3, direction: Vec3, near: f32, far: f32) -> Inside {
    let inverse = Vec3::new(reciprocal(direction.x), reciprocal(direction.y), reciprocal(direction.z));
    let (enters, leaves) = slab(from, inverse, xyz(medium.low), xyz(medium.high));
    let (enters, leaves) = (max(enters, near), min(leaves, far));
    let crosses = leaves > enters;
    Inside { enters: select(crosses, enters, near), leaves: select(crosses, leaves, near) }
}

/// The optical depth, over the extinction coefficient where the density is 1, of the light's way from a source to `position`, where it arrives along the
/// unit vector `direction`: in voxels.
#[inline(always)]
pub fn depth_from(medium: &Medium, materials: &[f32], source: &LightSource, position: Vec3, direction: Vec3) -> f32 {
    let to_source = xyz(source.position) - position;
    let reach = select(source.kind == kind::DISTANT, FAR, sqrt(dot(to_source, to_source)));
    optical_depth(medium, materials, position, -direction, 0.0, reach)
}

/// Transmittance of an optical depth over the extinction coefficient where the density is 1, in voxels, RGB (Beer–Lambert).
#[inline(always)]
pub fn transmittance(medium: &Medium, depth: f32) -> Vec3 {
    let extinction = xyz(medium.extinction);
    Vec3::new(exp(-(extinction.x * depth)), exp(-(extinction.y * depth)), exp(-(extinction.z * depth)))
}

/// The phase function for light that is scattered by an angle of cosine `cosine`, per steradian: its integral over all directions is 1.
#[inline(always)]
pub fn phase(medium: &Medium, cosine: f32) -> f32 {
    let g = medium.anisotropy;
    let base = max(1.0 + g * g - 2.0 * g * cosine, 1e-9);
    let henyey_greenstein = (1.0 - g * g) / (base * sqrt(base));
    let rayleigh = 0.75 * (1.0 + cosine * cosine);
    select(medium.phase == phase::RAYLEIGH, rayleigh, henyey_greenstein) * (0.25 / PI)
}

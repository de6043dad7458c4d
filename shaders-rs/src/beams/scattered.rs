//! The light that the medium scatters out of a beam along a viewing ray (single scattering; Jarosz et al. 2011).

use super::medium::{phase, transmittance};
use super::nearest::Nearest;
use super::viewing::{on_plane, through};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::Beam;
use crate::math::{length, max, select, xyz};
use spirv_std::glam::Vec3;

/// Light that a beam sends along a viewing ray.
#[derive(Clone, Copy)]
pub struct Scattered {
    /// Distance from the eye, in voxels; 0 or less where the ray does not meet the beam.
    pub distance: f32,
    /// Radiance over the density of the flux and its transmittance up to where the ray enters the medium.
    pub radiance: Vec3,
}

/// The light that a beam sends along the viewing ray through the place (`column`, `row`) of the picture, which enters the medium at the distance
/// `enters`.
#[inline(always)]
pub fn scattered(u: &BeamsUniforms, beam: &Beam, column: f32, row: f32, enters: f32) -> Scattered {
    let (across, upwards) = on_plane(u, column, row);
    let (from, aim) = through(u, across, upwards);
    let size = length(aim);
    let w = aim * (1.0 / size);
    let Nearest { t, s, cosine } = Nearest::new(beam.position - from, w, beam.direction);
    let meets = (s >= 0.0) & (s < beam.length) & (t > 0.0);
    let dimmed = transmittance(&u.medium, s + max(t - enters, 0.0));
    let strength = size * phase(&u.medium, -cosine);
    let radiance = beam.flux * xyz(u.medium.scattering) * dimmed * strength;
    Scattered { distance: select(meets, t, 0.0), radiance }
}

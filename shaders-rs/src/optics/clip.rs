//! Clipping planes: which share of a segment is left.

use crate::abi::clip::Clip;
use crate::abi::vector::Affine;
use crate::math::{affine, clamp, max, min, select};
use spirv_std::glam::Vec3;

/// The shares of a segment that clipping leaves, 0 to 1.
#[derive(Clone, Copy)]
pub struct Kept {
    /// Share of the segment in which particles are kept.
    pub particles: f32,
    /// Share in which the medium is kept.
    pub medium: f32,
    /// 1 if refraction is kept at the segment's end, else 0.
    pub refraction: f32,
}

/// The share of the segment from `from` to `to` on the kept side of `plane`.
#[inline(always)]
fn share(plane: Affine, from: Vec3, to: Vec3) -> f32 {
    let (a, b) = (affine(plane, from), affine(plane, to));
    // Positive distances are removed; between signs the crossing lies at |a| / |a − b|.
    let (low, high) = (min(a, b), max(a, b));
    let crossing = clamp(-low / max(high - low, 1e-30), 0.0, 1.0);
    select(low > 0.0, 0.0, select(high <= 0.0, 1.0, crossing))
}

impl Kept {
    /// All of a segment.
    pub const ALL: Self = Self { particles: 1.0, medium: 1.0, refraction: 1.0 };

    /// The shares that `clip` leaves of these, of the segment from `from` to `to`. Shares of several planes multiply.
    #[inline(always)]
    #[must_use]
    pub fn clipped(self, clip: &Clip, from: Vec3, to: Vec3) -> Self {
        let left = share(clip.plane, from, to);
        let removed = affine(clip.plane, to) > 0.0;
        let everything = clip.everything != 0;
        Self {
            particles: self.particles * left,
            medium: self.medium * select(everything, left, 1.0),
            refraction: self.refraction * select(everything & removed, 0.0, 1.0),
        }
    }
}

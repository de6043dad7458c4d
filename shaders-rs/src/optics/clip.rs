//! Clipping planes: which parts of a segment are left.

use crate::abi::clip::Clip;
use crate::abi::vector::Affine;
use crate::math::{absolute, affine, clamp, max, select};
use crate::optics::span::Span;
use spirv_std::glam::Vec3;

/// The parts of a segment that clipping leaves.
#[derive(Clone, Copy)]
pub struct Kept {
    /// The part in which particles are kept.
    pub particles: Span,
    /// The part in which the medium is kept.
    pub medium: Span,
    /// 1 if refraction is kept at the segment's end, else 0.
    pub refraction: f32,
}

/// The part of the segment from `from` to `to` on the kept side of `plane`.
#[inline(always)]
fn part(plane: Affine, from: Vec3, to: Vec3) -> Span {
    let (a, b) = (affine(plane, from), affine(plane, to));
    // Positive distances are removed; between signs the crossing lies at |a| / |a − b|.
    let crossing = clamp(absolute(a) / max(absolute(a - b), 1e-30), 0.0, 1.0);
    let (before, behind) = (a > 0.0, b > 0.0);
    // Nothing is left of a segment that begins and ends on the removed side.
    Span {
        start: select(before, select(behind, 1.0, crossing), 0.0),
        end: select(behind, select(before, 1.0, crossing), 1.0),
    }
}

impl Kept {
    /// All of a segment.
    pub const ALL: Self = Self { particles: Span::WHOLE, medium: Span::WHOLE, refraction: 1.0 };

    /// The parts that `clip` leaves of these, of the segment from `from` to `to`.
    #[inline(always)]
    #[must_use]
    pub fn clipped(self, clip: &Clip, from: Vec3, to: Vec3) -> Self {
        let left = part(clip.plane, from, to);
        let removed = affine(clip.plane, to) > 0.0;
        let everything = clip.everything != 0;
        Self {
            particles: self.particles.within(left),
            medium: self.medium.within(left.only_if(everything)),
            refraction: self.refraction * select(everything & removed, 0.0, 1.0),
        }
    }
}

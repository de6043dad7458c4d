//! Clipping planes: which share of a segment is left.

use crate::abi::sweep::{SweepUniforms, flag};
use crate::abi::vector::Vec4;
use crate::math::{clamp, dot, max, min, select, xyz};
use spirv_std::glam::Vec3;

/// What clipping leaves of a segment.
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
fn share(plane: Vec4, from: Vec3, to: Vec3) -> f32 {
    let a = dot(xyz(plane), from) + plane.w;
    let b = dot(xyz(plane), to) + plane.w;
    // Positive distances are removed; between signs the crossing lies at |a| / |a − b|.
    let (low, high) = (min(a, b), max(a, b));
    let crossing = clamp(-low / max(high - low, 1e-30), 0.0, 1.0);
    select(low > 0.0, 0.0, select(high <= 0.0, 1.0, crossing))
}

/// What the clipping planes leave of the segment from `from` to `to`. Shares of several planes multiply.
#[inline(always)]
pub fn keep(u: &SweepUniforms, from: Vec3, to: Vec3) -> Kept {
    let mut kept = Kept { particles: 1.0, medium: 1.0, refraction: 1.0 };
    if u.dispatch.w & flag::CLIP != 0 {
        kept = apply(kept, u.clip_0, u.clip_everything.x, from, to);
        kept = apply(kept, u.clip_1, u.clip_everything.y, from, to);
        kept = apply(kept, u.clip_2, u.clip_everything.z, from, to);
        kept = apply(kept, u.clip_3, u.clip_everything.w, from, to);
    }
    kept
}

#[inline(always)]
fn apply(kept: Kept, plane: Vec4, everything: f32, from: Vec3, to: Vec3) -> Kept {
    let left = share(plane, from, to);
    let removed = dot(xyz(plane), to) + plane.w > 0.0;
    let everything = everything > 0.5;
    Kept {
        particles: kept.particles * left,
        medium: kept.medium * select(everything, left, 1.0),
        refraction: kept.refraction * select(everything & removed, 0.0, 1.0),
    }
}

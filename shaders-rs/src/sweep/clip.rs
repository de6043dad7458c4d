//! The sweep's clipping planes.

use crate::abi::sweep::{SweepUniforms, flag};
use crate::optics::clip::Kept;
use spirv_std::glam::Vec3;

/// The parts of the segment from `from` to `to` that the clipping planes leave.
#[inline(always)]
pub fn keep(u: &SweepUniforms, from: Vec3, to: Vec3) -> Kept {
    let mut kept = Kept::ALL;
    if u.flags & flag::CLIP != 0 {
        kept = kept.clipped(&u.clip_0, from, to);
        kept = kept.clipped(&u.clip_1, from, to);
        kept = kept.clipped(&u.clip_2, from, to);
        kept = kept.clipped(&u.clip_3, from, to);
    }
    kept
}

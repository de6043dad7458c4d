//! Beams of curved texels go: their light is that of the beams of the four texels into which they are split ([`super::split_texels`]).

use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Beam, beam};
use crate::field::access::read;
use crate::optics::receiver::FAR;
use spirv_std::glam::Vec3;

pub use crate::voxels::ray::level;

/// The level of work: whether the texel is curved.
#[inline(always)]
pub fn level(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, _before: [f32; beam::SIZE], curved: &[f32]) -> u32 {
    if read(curved, (y * u.dispatch.width + x) as i32) > 0.0 { level::WORK } else { level::ENDED }
}

/// The beam without flux.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    _x: u32,
    _y: u32,
    _u: &BeamsUniforms,
    _mode: u32,
    before: [f32; beam::SIZE],
    _curved: &[f32],
) -> [f32; beam::SIZE] {
    Beam { flux: Vec3::new(0.0, 0.0, 0.0), radius: -FAR, ..Beam::load(&before) }.store()
}

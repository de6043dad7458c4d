//! The light on the first plane: unoccluded (Algorithm 1, line 1).

use crate::abi::record::light;
use crate::abi::sweep::SweepUniforms;
use crate::sweep::light::unoccluded;

/// The light of texel (x, y) on the first plane.
#[inline(always)]
pub fn invoke(_x: u32, _y: u32, u: &SweepUniforms, _mode: u32) -> [f32; light::SIZE] {
    unoccluded::light(u)
}

//! Sums of a receiver to 0, before cells land on it.

use crate::abi::record::landed;
use crate::abi::sweep::SweepUniforms;

/// No contributions.
#[inline(always)]
pub fn invoke(_x: u32, _y: u32, _u: &SweepUniforms, _mode: u32) -> [f32; landed::SIZE] {
    // The bits of 0.0 are those of 0.
    [0.0; landed::SIZE]
}

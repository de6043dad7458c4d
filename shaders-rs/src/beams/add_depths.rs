//! Optical depths of straight pieces up to their nodes: the sums of those of their parts.

use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{OpticalDepth, optical_depth};
use crate::field::access::read;

/// The optical depth up to node `y` + 1 of piece number `x`; those of the round's parts follow one another.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, parts: &[f32]) -> [f32; optical_depth::SIZE] {
    let mut depth = 0.0;
    let mut node = 0;
    while node <= y {
        depth += read(parts, (node * u.dispatch.width + x) as i32);
        node += 1;
    }
    OpticalDepth { depth }.store()
}

//! Sheets of light: one for each direction of a soft light, each with a node at every corner between light texels.
//!
//! Sheet k has rows k · (texel rows + 1) to (k + 1) · (texel rows + 1) − 1 of the buffer.

use crate::abi::sweep::SweepUniforms;
use crate::field::access::read_vector;
use spirv_std::glam::Vec3;

/// Rows of nodes that a sheet has; never 0, so that dividing by it cannot panic.
#[inline(always)]
pub fn rows(u: &SweepUniforms) -> u32 {
    let rows = u.light_grid.height + 1;
    if rows > 0 { rows } else { 1 }
}

/// The direction in which the sheet of row `y` of nodes started.
#[inline(always)]
pub fn source(u: &SweepUniforms, sources: &[f32], y: u32) -> Vec3 {
    let at = (y / rows(u) * 3) as i32;
    read_vector(sources, at)
}

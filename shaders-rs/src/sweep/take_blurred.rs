//! The wavefront's nodes with the light that [`super::blur_nodes`] has left them.

use crate::abi::record::{Node, blurred, node as record};
use crate::abi::sweep::SweepUniforms;
use crate::field::access::read;
use crate::sweep::blur_nodes::is_blurred;
use crate::sweep::light::wavefront::{columns, nodes};
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The node's light stays as it is.
    pub const ENDED: u32 = 0;
    /// The node's light was blurred.
    pub const WORK: u32 = 3;
}

/// The level that a node needs.
#[inline(always)]
pub fn level(_x: u32, _y: u32, _u: &SweepUniforms, _mode: u32, before: [f32; record::SIZE], _blurred: &[f32]) -> u32 {
    if is_blurred(before[record::STATUS]) { level::WORK } else { level::ENDED }
}

/// Node (x, y).
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    _mode: u32,
    before: [f32; record::SIZE],
    blurred_in: &[f32],
) -> [f32; record::SIZE] {
    let w = &u.wavefront;
    let count = nodes(w) as i32;
    let at = (y * columns(w) + x) as i32;
    let flux = Vec3::new(
        read(blurred_in, blurred::FLUX as i32 * count + at),
        read(blurred_in, (blurred::FLUX + 1) as i32 * count + at),
        read(blurred_in, (blurred::FLUX + 2) as i32 * count + at),
    );
    let absorbed_at = read(blurred_in, blurred::ABSORBED_AT as i32 * count + at);
    Node { flux, absorbed_at, ..Node::load(&before) }.store()
}

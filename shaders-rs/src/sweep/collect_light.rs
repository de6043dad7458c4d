//! The wavefront's light around the samples of a plane that something looks at.

use crate::abi::record::{Carried, carried as record};
use crate::abi::sweep::SweepUniforms;
use crate::sweep::light::samples::light;

/// The light at sample (x, y) of the plane's bricks, one brick behind the other.
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    chosen: u32,
    sums: &[u32],
    nodes: &[f32],
    bricks: &[u32],
) -> [f32; record::SIZE] {
    let index = y * u.dispatch.width + x;
    let found = light(u, chosen, sums, nodes, bricks, index);
    Carried { share: found.share, direction: found.direction }.store()
}

//! As [`super::collect_light`], in a clear medium that does not bend light: it has one colour and one direction.

use crate::abi::record::{CarriedStraight, carried_straight as record};
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
    CarriedStraight { share: found.share.x }.store()
}

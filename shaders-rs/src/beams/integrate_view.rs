//! Optical depths of the parts of viewing rays' first straight pieces, between one node and the next.

use super::density::over_part;
use super::viewing;
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{OpticalDepth, optical_depth, sight};
use crate::field::access::read;

/// The optical depth of the part before node `y` + 1 of the ray of pixel number `x`, row by row.
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    sights: &[f32],
    materials: &[f32],
) -> [f32; optical_depth::SIZE] {
    let (column, row) = (x % u.picture.width, x / u.picture.width);
    let start = viewing::start(u, column as i32, row as i32);
    let component = |component: usize| read(sights, (component as u32 * u.dispatch.width + x) as i32);
    let (enters, leaves) = (component(sight::ENTERS), component(sight::LEAVES));
    let step = (leaves - enters) / u.medium.nodes as f32;
    let begin = enters + step * y as f32;
    OpticalDepth { depth: over_part(&u.medium, materials, start.position, start.direction, begin, begin + step) }
        .store()
}

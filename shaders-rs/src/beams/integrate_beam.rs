//! Optical depths of the parts of beams, between one node and the next.

use super::density::over_part;
use super::store_beam::{beam_of, has_flux};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{OpticalDepth, optical_depth};

/// The optical depth of the part before node `y` + 1 of the beam number `x`.
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    beams: &[f32],
    materials: &[f32],
) -> [f32; optical_depth::SIZE] {
    let first = (u.limits.round * u.limits.pitch) as i32;
    let (number, count) = (x as i32, u.dispatch.width as i32);
    let mut depth = 0.0;
    if has_flux(beams, first, number, count) {
        let beam = beam_of(beams, first, number, count);
        let step = beam.length / u.medium.nodes as f32;
        let begin = step * y as f32;
        depth = over_part(&u.medium, materials, beam.position, beam.direction, begin, begin + step);
    }
    OpticalDepth { depth }.store()
}

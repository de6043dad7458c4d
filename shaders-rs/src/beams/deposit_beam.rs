//! Light of beams in the cells of the medium ([`super::cells`]): flux times length, which over the cell's volume is the fluence. What bodies take away is
//! negative.

use super::cells::number_at;
use super::density::over_part;
use super::medium::transmittance;
use super::store_beam::{beam_of, has_flux};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::deposit;
use crate::field::sums::{Sums, add_words, words};
use crate::math::{floor_to_int, min, select};

/// Parts of a beam at most.
const PARTS: f32 = 64.0;

/// Adds the light of beam number `x`.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    _y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    beams: &[f32],
    materials: &[f32],
    sums: &mut S,
) {
    let (number, count) = (x as i32, u.dispatch.width as i32);
    let first = (u.limits.round * u.limits.pitch) as i32;
    if !has_flux(beams, first, number, count) {
        return;
    }
    let beam = beam_of(beams, first, number, count);
    let edge = u.cells.edge;
    let parts = floor_to_int(2.0 * beam.length / min(min(edge.x, edge.y), edge.z), 0.0, PARTS - 1.0) + 1;
    let step = beam.length / parts as f32;
    let sign = select(u.limits.round == 0, -u.cells.scale, u.cells.scale);
    let mut before = 0.0;
    let mut part = 0;
    while part < parts {
        let near = part as f32 * step;
        let within = if u.medium.nodes == 0 {
            step
        } else {
            over_part(&u.medium, materials, beam.position, beam.direction, near, near + step)
        };
        let light = beam.flux * transmittance(&u.medium, before + 0.5 * within) * (step * sign);
        let flow = beam.direction * (((light.x + light.y) + light.z) * (1.0 / 3.0));
        let at = number_at(u, beam.position + beam.direction * (near + 0.5 * step)) * deposit::SIZE as i32;
        let (low, high) = words(light.x);
        add_words(sums, at, low, high);
        let (low, high) = words(light.y);
        add_words(sums, at + 2, low, high);
        let (low, high) = words(light.z);
        add_words(sums, at + 4, low, high);
        let (low, high) = words(flow.x);
        add_words(sums, at + 6, low, high);
        let (low, high) = words(flow.y);
        add_words(sums, at + 8, low, high);
        let (low, high) = words(flow.z);
        add_words(sums, at + 10, low, high);
        before += within;
        part += 1;
    }
}

//! Transmittance e^−Σ along the light, in front of and behind each voxel (Chang et al. 2010, §3, step 4; one coefficient for all:
//! Eisemann & Décoret 2006).
//!
//! The paper has the sum alone (§3, step 4); as an optical depth, with the minus sign, it is a transmittance.

use crate::abi::record::absorption;
use crate::abi::shadow::{ShadowUniforms, mode, row_words};
use crate::field::access::read;
use crate::field::sums::{Sums, to_number};
use crate::math::{exp, floor_to_int};

/// Transmittance e^−τ of an optical depth τ, in units of 1 / 65535.
#[inline(always)]
fn left(low: u32, high: u32) -> u32 {
    let depth = to_number(low, high) * (1.0 / absorption::SCALE);
    floor_to_int(exp(-depth) * 65535.0 + 0.5, 0.0, 65535.0) as u32
}

/// The optical depth behind a voxel, as a 64-bit sum (`low`, `high`), and the transmittance that is left there in 1 / 65535, from those
/// in front of it. The row begins at voxel `row`; beyond its end nothing absorbs.
#[inline(always)]
fn behind(
    u: &ShadowUniforms,
    mode: u32,
    depths: &[u32],
    row: i32,
    voxel: i32,
    channel: i32,
    (low, high, transmittance): (u32, u32, u32),
) -> (u32, u32, u32) {
    let channels = u.channels as i32;
    let at = ((row + voxel) * channels + channel) * absorption::SIZE as i32;
    let (more, carry) = (read(depths, at), read(depths, at + 1));
    if (voxel < u.width as i32) & ((more | carry) != 0) {
        let (more, carry) = if mode == mode::UNIFORM { (u.uniform_depth, 0) } else { (more, carry) };
        let sum = low.wrapping_add(more);
        let carried = high.wrapping_add(carry).wrapping_add((sum < low) as u32);
        (sum, carried, left(sum, carried))
    } else {
        (low, high, transmittance)
    }
}

/// Does row y · width + x of the slab, channels one behind the other: 16 bits in front of the row's first voxel and behind each.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(x: u32, y: u32, u: &ShadowUniforms, mode: u32, depths: &[u32], light: &mut S) {
    let row = y * u.dispatch.width + x;
    if row < u.work {
        let rows = (u.height * u.layers) as i32;
        // The dispatch has the rows of all channels.
        let mut channel = 0;
        let mut line = row as i32;
        while line >= rows {
            line -= rows;
            channel += 1;
        }
        let length = u.width as i32;
        let words = row_words(u.width) as i32;
        let layers_before = channel * u.depth as i32 + u.first_layer as i32;
        let base = u.first_word as i32 + (layers_before * u.height as i32 + line) * words;
        let mut sum = (0, 0, 65535);
        let mut word = 0;
        while word < words {
            // Two voxels a word, one after the other and not in a loop of their own, which naga cannot translate.
            let first = 2 * word;
            let in_front = sum.2;
            sum = behind(u, mode, depths, line * length, first, channel, sum);
            let between = sum.2;
            sum = behind(u, mode, depths, line * length, first + 1, channel, sum);
            light.add((base + word) as usize, in_front | between << 16);
            word += 1;
        }
    }
}

//! Sums up what voxels absorb along the light: what is left of it in front of and behind each voxel, e^−Σ.
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

/// Does row y · width + x of the slab, channels one behind the other: 16 bits in front of the row's first voxel and behind each.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(x: u32, y: u32, u: &ShadowUniforms, mode: u32, depths: &[u32], light: &mut S) {
    let row = y * u.dispatch.width + x;
    if row < u.work {
        let channels = u.channels as i32;
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
        let base = (layers_before * u.height as i32 + line) * words;
        let (mut low, mut high) = (0u32, 0u32);
        let mut now = 65535;
        let mut word = 0;
        while word < words {
            // In front of voxel 2 word, and behind it.
            let mut pair = now;
            let mut half = 0;
            while half < 2 {
                let voxel = 2 * word + half;
                if voxel < length {
                    let at = ((line * length + voxel) * channels + channel) * absorption::SIZE as i32;
                    let (more, carry) = (read(depths, at), read(depths, at + 1));
                    if (more | carry) != 0 {
                        let (more, carry) = if mode == mode::UNIFORM { (u.uniform_depth, 0) } else { (more, carry) };
                        let before = low;
                        low = low.wrapping_add(more);
                        high = high.wrapping_add(carry).wrapping_add((low < before) as u32);
                        now = left(low, high);
                    }
                }
                if half == 0 {
                    pair |= now << 16;
                }
                half += 1;
            }
            light.add((base + word) as usize, pair);
            word += 1;
        }
    }
}

//! Soft light on a receiver from its differences: their sums along rows, then along columns.

use crate::abi::record::landed;
use crate::abi::sweep::{SweepUniforms, along};
use crate::field::sums::Sums;

/// Sums up line `line`, along rows or columns as `chosen`, one of [`along`], says.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(_x: u32, line: u32, u: &SweepUniforms, chosen: u32, sums: &mut S) {
    let size = u.wavefront.map.size;
    let rows = chosen == along::ROWS;
    let (length, step) = if rows { (size.width, 1) } else { (size.height, size.width) };
    let first = if rows { line * size.width } else { line };
    let mut channel = 0;
    while channel < landed::SIZE as u32 {
        let (mut low, mut high) = (0u32, 0u32);
        let mut at = (first * landed::SIZE as u32 + channel) as usize;
        let mut texel = 0;
        while texel < length {
            let (own_low, own_high) = (sums.add(at, 0), sums.add(at + 1, 0));
            sums.add_pair(at, low, high);
            let sum = low.wrapping_add(own_low);
            high = high.wrapping_add(own_high).wrapping_add((sum < low) as u32);
            low = sum;
            at += step as usize * landed::SIZE;
            texel += 1;
        }
        channel += 2;
    }
}

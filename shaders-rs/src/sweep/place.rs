//! The places of viewing rays on the picture.
//!
//! A pass has a ray for each place, or, where a picture is refined, squares of `refined` × `refined` rays, each of them in one of some pixels. The
//! squares lie side by side, in the order of the list of pixels.

use crate::abi::sweep::SweepUniforms;
use crate::field::access::read;

/// Bits of a pixel's column in a list of pixels; its row is above them.
pub const COLUMN_BITS: u32 = 16;

/// The word of a pixel in a list.
#[must_use]
pub fn word(column: u32, row: u32) -> u32 {
    row << COLUMN_BITS | column
}

/// The place of ray (x, y) of the pass on the picture, in rays from its left upper corner.
#[inline(always)]
pub fn place(u: &SweepUniforms, pixels: &[u32], x: u32, y: u32) -> (u32, u32) {
    let is_whole = u.refined == 0;
    let edge = if is_whole { 1 } else { u.refined };
    let (column, row) = (x / edge, y / edge);
    let word = read(pixels, (row * (u.picture.width / edge) + column) as i32);
    let (across, down) = (word & ((1 << COLUMN_BITS) - 1), word >> COLUMN_BITS);
    if is_whole { (x, y) } else { (across * edge + x % edge, down * edge + y % edge) }
}

/// The first ray and the last one beside ray `at` of `count` along an axis whose directions tell how fast directions change: its neighbours, within
/// its own pixel where rays beside it may be another pixel's.
#[inline(always)]
pub fn beside(u: &SweepUniforms, at: i32, count: i32) -> (i32, i32) {
    let edge = if u.refined == 0 { count } else { u.refined as i32 };
    let first = at - at % edge;
    let end = first + edge - 1;
    (if at > first { at - 1 } else { first }, if at < end { at + 1 } else { end })
}

//! Rows of stored voxels, as floats.

use super::access::{read, read_bytes};
use crate::abi::grid::format;

/// Voxels `at` and `at + 1`.
#[inline(always)]
pub fn pair<const FORMAT: u32>(voxels: &[u32], at: i32) -> (f32, f32) {
    if FORMAT == format::U8 {
        let word = read_bytes(voxels, at);
        ((word & 0xff) as i32 as f32, (word >> 8 & 0xff) as i32 as f32)
    } else if FORMAT == format::U16 {
        let word = read_bytes(voxels, at * 2);
        ((word & 0xffff) as i32 as f32, (word >> 16) as i32 as f32)
    } else {
        (f32::from_bits(read(voxels, at)), f32::from_bits(read(voxels, at + 1)))
    }
}

/// Voxels `at − 1` to `at + 2`.
#[inline(always)]
pub fn quad<const FORMAT: u32>(voxels: &[u32], at: i32) -> (f32, f32, f32, f32) {
    if FORMAT == format::U8 {
        let word = read_bytes(voxels, at - 1);
        (
            (word & 0xff) as i32 as f32,
            (word >> 8 & 0xff) as i32 as f32,
            (word >> 16 & 0xff) as i32 as f32,
            (word >> 24) as i32 as f32,
        )
    } else {
        let (a, b) = pair::<FORMAT>(voxels, at - 1);
        let (c, d) = pair::<FORMAT>(voxels, at + 1);
        (a, b, c, d)
    }
}

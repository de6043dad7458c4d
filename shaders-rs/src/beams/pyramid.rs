//! The pyramid of pictures in which beams are drawn: level l has pixels of 2^l × 2^l viewing rays. Level 0 is the picture itself.

use crate::abi::beams::{BeamsUniforms, Sums};
use crate::abi::record::inscattered;
use crate::abi::vector::Size;

/// `count` over 2^`level`, rounded up.
#[inline(always)]
fn halved(count: u32, level: u32) -> u32 {
    (count + (1 << level) - 1) >> level
}

/// Pixels of a level across and down.
#[inline(always)]
pub fn size(picture: Size, level: u32) -> Size {
    Size { width: halved(picture.width, level), height: halved(picture.height, level) }
}

/// The number of pixels of the levels below `level`.
#[inline(always)]
pub fn pixels_below(picture: Size, level: u32) -> u32 {
    let mut sum = 0;
    let mut below = 0;
    while below < level {
        let Size { width, height } = size(picture, below);
        sum += width * height;
        below += 1;
    }
    sum
}

/// The index of the first word of a pixel's sums.
#[inline(always)]
pub fn sums_of(u: &BeamsUniforms, level: u32, column: i32, row: i32) -> i32 {
    let Sums { pixels_1, pixels_2, pixels_3, pixels_4, .. } = u.sums;
    // From the uniform block, where a loop would count among those of which drivers end long ones.
    let first = of_level(level, [0, pixels_1, pixels_2, pixels_3, pixels_4]);
    let number = first as i32 + row * size(u.picture, level).width as i32 + column;
    number * inscattered::SIZE as i32
}

/// The first of the rows of a level among those of all levels from 1 on, one below the other: records of depths have as many columns as level 1.
#[inline(always)]
pub fn first_row(u: &BeamsUniforms, level: u32) -> u32 {
    let Sums { rows_2, rows_3, rows_4, .. } = u.sums;
    of_level(level, [0, 0, rows_2, rows_3, rows_4])
}

/// The number of a level out of those of all.
#[inline(always)]
fn of_level(level: u32, [own, first, second, third, fourth]: [u32; 5]) -> u32 {
    if level == 0 {
        own
    } else if level == 1 {
        first
    } else if level == 2 {
        second
    } else if level == 3 {
        third
    } else {
        fourth
    }
}

/// Rows of the levels from 1 on before `level`.
#[inline(always)]
pub fn rows_before(picture: Size, level: u32) -> u32 {
    let mut sum = 0;
    let mut before = 1;
    while before < level {
        sum += size(picture, before).height;
        before += 1;
    }
    sum
}

//! The depths of the viewing rays of the pixels of the pyramid's levels.

use super::pyramid::{first_row, size};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Depths, depths, sight};
use crate::field::access::read;
use crate::math::{max, min};
use crate::optics::receiver::FAR;

/// The level of row `y` of all levels, which stand one below the other from level 1 on.
#[inline(always)]
pub fn level_of_row(u: &BeamsUniforms, y: u32) -> u32 {
    let mut level = 1;
    while (level < u.sums.levels) & (y >= first_row(u, level + 1)) {
        level += 1;
    }
    level
}

/// The depths of the pixel in column `x` and row `y` of all levels.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, sights: &[f32]) -> [f32; depths::SIZE] {
    let level = level_of_row(u, y);
    let row = (y - first_row(u, level)) as i32;
    let edge = 1 << level;
    let (width, height) = (u.picture.width as i32, u.picture.height as i32);
    let count = width * height;
    let mut found = Depths { nearest: FAR, farthest: 0.0, enters: 0.0 };
    let mut own = 0.0;
    let mut j = row * edge;
    while (j < (row + 1) * edge) & (j < height) {
        let mut i = x as i32 * edge;
        while (i < (x as i32 + 1) * edge) & (i < width) {
            let depth = read(sights, sight::DEPTH as i32 * count + j * width + i);
            found.nearest = min(found.nearest, depth);
            found.farthest = max(found.farthest, depth);
            found.enters += read(sights, sight::ENTERS as i32 * count + j * width + i);
            own += 1.0;
            i += 1;
        }
        j += 1;
    }
    found.enters *= 1.0 / max(own, 1.0);
    found.store()
}

/// The index of a pixel's record, and the number of all records.
#[inline(always)]
pub fn place(u: &BeamsUniforms, level: u32, column: i32, row: i32) -> (i32, i32) {
    let columns = size(u.picture, 1).width as i32;
    let count = columns * u.sums.rows as i32;
    ((first_row(u, level) as i32 + row) * columns + column, count)
}

//! The depths of viewing rays around the pixels of the pyramid's levels: a beam that is nearer than all of them, or farther, may be drawn
//! there in coarse pixels.

use super::find_depths::{level_of_row, place};
use super::pyramid::{first_row, size};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Around, around, depths};
use crate::field::access::read;
use crate::math::{max, min};
use crate::optics::receiver::FAR;

/// The depths around the pixel in column `x` and row `y` of all levels, which stand one below the other from level 1 on.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, records: &[f32]) -> [f32; around::SIZE] {
    let level = level_of_row(u, y);
    let (column, row) = (x as i32, (y - first_row(u, level)) as i32);
    let of_level = size(u.picture, level);
    let (width, height) = (of_level.width as i32, of_level.height as i32);
    let mut found = Around { nearest: FAR, farthest: 0.0, least: FAR, enters: 0.0 };
    let mut j = row - 2;
    while j <= row + 2 {
        let mut i = column - 2;
        while i <= column + 2 {
            if (i >= 0) & (i < width) & (j >= 0) & (j < height) {
                let (at, count) = place(u, level, i, j);
                let nearest = read(records, depths::NEAREST as i32 * count + at);
                let farthest = read(records, depths::FARTHEST as i32 * count + at);
                let beside = (i >= column - 1) & (i <= column + 1) & (j >= row - 1) & (j <= row + 1);
                found.least = min(found.least, nearest);
                found.nearest = min(found.nearest, if beside { nearest } else { FAR });
                found.farthest = max(found.farthest, if beside { farthest } else { 0.0 });
            }
            i += 1;
        }
        j += 1;
    }
    let (at, count) = place(u, level, column, row);
    found.enters = read(records, depths::ENTERS as i32 * count + at);
    found.store()
}

/// The depths around a pixel of a level of the pyramid.
#[inline(always)]
pub fn depths_around(u: &BeamsUniforms, records: &[f32], level: u32, column: i32, row: i32) -> Around {
    let (at, count) = place(u, level, column, row);
    let component = |component: usize| read(records, component as i32 * count + at);
    Around {
        nearest: component(around::NEAREST),
        farthest: component(around::FARTHEST),
        least: component(around::LEAST),
        enters: component(around::ENTERS),
    }
}

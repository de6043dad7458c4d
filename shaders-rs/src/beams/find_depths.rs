//! The depths of viewing rays around the pixels of the pyramid's levels: a beam that is nearer than all of them, or farther, may be drawn
//! there in coarse pixels.

use super::pyramid::{rows_before, size};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Depths, depths, sight};
use crate::field::access::read;
use crate::math::{max, min};
use crate::optics::receiver::FAR;

/// The depths around the pixel in column `x` and row `y` of all levels, which stand one below the other from level 1 on.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, sights: &[f32]) -> [f32; depths::SIZE] {
    let mut level = 1;
    while (level < u.sums.levels) & (y >= rows_before(u.picture, level + 1)) {
        level += 1;
    }
    let row = (y - rows_before(u.picture, level)) as i32;
    let column = x as i32;
    let edge = 1 << level;
    let (width, height) = (u.picture.width as i32, u.picture.height as i32);
    let count = width * height;
    let mut found = Depths { nearest: FAR, farthest: 0.0, enters: 0.0 };
    let mut enters = 0.0;
    let mut own = 0.0;
    let mut j = (row - 1) * edge;
    while j < (row + 2) * edge {
        let mut i = (column - 1) * edge;
        while i < (column + 2) * edge {
            if (i >= 0) & (i < width) & (j >= 0) & (j < height) {
                let depth = read(sights, sight::DEPTH as i32 * count + j * width + i);
                found.nearest = min(found.nearest, depth);
                found.farthest = max(found.farthest, depth);
                if (i >= column * edge) & (i < (column + 1) * edge) & (j >= row * edge) & (j < (row + 1) * edge) {
                    enters += read(sights, sight::ENTERS as i32 * count + j * width + i);
                    own += 1.0;
                }
            }
            i += 1;
        }
        j += 1;
    }
    found.enters = enters / max(own, 1.0);
    found.store()
}

/// The depths around a pixel of a level of the pyramid.
#[inline(always)]
pub fn depths_around(u: &BeamsUniforms, records: &[f32], level: u32, column: i32, row: i32) -> Depths {
    let columns = size(u.picture, 1).width as i32;
    let count = columns * rows_before(u.picture, u.sums.levels + 1) as i32;
    let at = (rows_before(u.picture, level) as i32 + row) * columns + column;
    let component = |component: usize| read(records, component as i32 * count + at);
    Depths {
        nearest: component(depths::NEAREST),
        farthest: component(depths::FARTHEST),
        enters: component(depths::ENTERS),
    }
}

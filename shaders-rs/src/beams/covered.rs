//! The part of a picture's axis that a beam covers, and the levels of the pyramid in whose pixels its blocks of columns are drawn.

use super::drawn::Drawn;
use crate::abi::beams::{BLOCK, BeamsUniforms};
use crate::abi::record::projection;
use crate::field::access::read;

/// Width of a beam's picture in blocks that have an end of the beam, over the width for which its level is chosen, inverted.
const AT_ENDS: f32 = 1.0 / 8.0;

/// The level in whose pixels a beam is drawn that is `width` pixels wide: at least four pixels of that level.
#[inline(always)]
fn level_for(width: f32, levels: u32) -> u32 {
    let mut level = 0;
    let mut least = 8.0;
    while (level < levels) & (width >= least) {
        level += 1;
        least *= 2.0;
    }
    level
}

/// The part of the major axis that a beam covers: the columns of any of it, and the columns across which it has no end.
#[derive(Clone, Copy)]
pub struct Covered {
    /// The first column with any of the beam; behind `end` where the beam does not come into the picture.
    pub begin: f32,
    /// The last column with any of the beam.
    pub end: f32,
    inner_begin: f32,
    inner_end: f32,
}

impl Covered {
    /// The columns that beam number `number` of `count` covers; projections begin at float `first`.
    #[inline(always)]
    pub fn of(projections: &[f32], first: i32, number: i32, count: i32) -> Self {
        let component = |component: usize| read(projections, first + component as i32 * count + number);
        Self {
            begin: component(projection::BEGIN),
            end: component(projection::END),
            inner_begin: component(projection::INNER_BEGIN),
            inner_end: component(projection::INNER_END),
        }
    }

    /// Whether the beam is in the block whose first column is `left`.
    #[inline(always)]
    pub fn is_in_block(&self, left: i32) -> bool {
        let right = left + BLOCK as i32;
        (self.begin <= self.end) & (self.end >= left as f32) & (self.begin <= (right - 1) as f32)
    }

    /// The level of the block whose first column is `left`.
    #[inline(always)]
    fn level(&self, u: &BeamsUniforms, drawn: &Drawn, left: i32) -> u32 {
        let right = left + BLOCK as i32;
        let middle = drawn.section(left as f32 + 0.5 * (BLOCK as f32 - 1.0));
        let width = 2.0 * drawn.half_width(&middle, 1.0);
        let level = level_for(width, u.sums.levels);
        let margin = (1 << level) as f32;
        let within = (left as f32 - margin > self.inner_begin) & (right as f32 + margin < self.inner_end);
        // Coarse pixels do not show where exactly a beam ends: in blocks with an end they are finer.
        if within { level } else { level_for(width * AT_ENDS, u.sums.levels) }
    }
}

/// Whether beam number `number` of `count` is in the block whose first column is `left`; projections begin at float `first`. Most beams are not in most
/// blocks: one number at a time is read.
#[inline(always)]
pub fn reaches_block(projections: &[f32], first: i32, number: i32, count: i32, left: i32) -> bool {
    let component = |component: usize| read(projections, first + component as i32 * count + number);
    if component(projection::END) < left as f32 {
        return false;
    }
    let begin = component(projection::BEGIN);
    if begin > (left + BLOCK as i32 - 1) as f32 {
        return false;
    }
    begin <= component(projection::END)
}

/// The levels of a block of columns and of the blocks beside it.
#[derive(Clone, Copy)]
pub struct Levels {
    /// The first column of the block.
    pub first: i32,
    left: u32,
    /// The level of the block.
    pub own: u32,
    right: u32,
}

impl Levels {
    /// The levels of the block whose first column is `first`, of an axis of `columns`. Beside it, blocks without any of the beam have its own.
    #[inline(always)]
    pub fn new(u: &BeamsUniforms, drawn: &Drawn, covered: &Covered, first: i32, columns: i32) -> Self {
        let own = covered.level(u, drawn, first);
        let (left, right) = (first - BLOCK as i32, first + BLOCK as i32);
        Self {
            first,
            left: if (left >= 0) & covered.is_in_block(left) { covered.level(u, drawn, left) } else { own },
            own,
            right: if (right < columns) & covered.is_in_block(right) { covered.level(u, drawn, right) } else { own },
        }
    }

    /// The level in which a column along the major axis is drawn; columns are at most one block away.
    #[inline(always)]
    pub fn at(&self, column: i32) -> u32 {
        let right = column >= self.first + BLOCK as i32;
        let own = if right { self.right } else { self.own };
        if column < self.first { self.left } else { own }
    }

    /// Whether the block on the left, or the block on the right, has another level.
    #[inline(always)]
    pub fn borders(&self) -> (bool, bool) {
        (self.left != self.own, self.right != self.own)
    }

    /// The coarse levels among them, each once: 0 stands in the place of none.
    #[inline(always)]
    pub fn coarse(&self) -> [u32; 3] {
        let Self { left, own, right, .. } = *self;
        [own, if left == own { 0 } else { left }, if (right == own) | (right == left) { 0 } else { right }]
    }
}

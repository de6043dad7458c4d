//! Where light is still as it left its source, so that the CPU can leave it out.

use super::host::LANES;
use crate::field::unoccluded::Reach;

/// Which blocks of [`LANES`] invocations hold nothing but unoccluded light, row by row. A kernel that keeps such light as it is looks
/// at the marks of what it reads, and keeps those of what it writes. In all passes that share marks, unoccluded light is the same.
#[derive(Default)]
pub struct Marks<'a> {
    /// Those of the chunk's blocks; the records of a marked one are all unoccluded light's.
    pub own: &'a mut [bool],
    /// For a kernel that updates: the depth up to which a marked block of the chunk has nothing in its way.
    pub free_to: &'a mut [f32],
    /// Those of each buffer of floats that is read, for all rows. Empty if there are none.
    pub reads: &'a [&'a [bool]],
    /// Rows in all.
    pub height: u32,
}

impl Marks<'_> {
    /// Whether block `number` of the chunk holds nothing but unoccluded light.
    #[inline(always)]
    pub(super) fn is_set(&self, number: usize) -> bool {
        self.own.get(number) == Some(&true)
    }

    #[inline(always)]
    pub(super) fn set(&mut self, number: usize, value: bool) {
        if let Some(mark) = self.own.get_mut(number) {
            *mark = value;
        }
        if let (false, Some(depth)) = (value, self.free_to.get_mut(number)) {
            *depth = f32::NEG_INFINITY;
        }
    }

    /// Whether nothing is in a marked block's way to `depth`.
    #[inline(always)]
    pub(super) fn is_free_to(&self, number: usize, depth: f32) -> bool {
        self.free_to.get(number).is_some_and(|free_to| depth <= *free_to)
    }

    #[inline(always)]
    pub(super) fn set_free_to(&mut self, number: usize, depth: f32) {
        if let Some(free_to) = self.free_to.get_mut(number) {
            *free_to = depth;
        }
    }

    /// Whether all texels that those of the block of row `y` from column `x` on look at, out of `width` columns, hold unoccluded
    /// light; beyond the grid they do.
    #[inline(never)]
    pub(super) fn around(&self, reach: &Reach, x: u32, y: u32, width: u32) -> bool {
        let blocks = width.div_ceil(LANES as u32) as usize;
        let block = |column: i32| column.clamp(0, width as i32 - 1) as usize / LANES;
        let (x, y) = (x as i32, y as i32);
        let columns = block(x - reach.left)..=block(x + LANES as i32 - 1 + reach.right);
        let row = |row: i32| row.clamp(0, self.height as i32 - 1) as usize * blocks;
        let is_set = |marks: &[bool], at: usize| marks.get(at) == Some(&true);
        // Most blocks that fail do so at their own place.
        if !self.reads.iter().all(|marks| is_set(marks, row(y) + block(x))) {
            return false;
        }
        for marks in self.reads {
            for line in y - reach.below..=y + reach.above {
                let start = row(line);
                for column in columns.clone() {
                    if !is_set(marks, start + column) {
                        return false;
                    }
                }
            }
        }
        true
    }
}

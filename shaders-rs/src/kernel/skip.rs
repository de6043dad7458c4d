//! Blocks of invocations that the CPU leaves out, because running them would change no bit.
//!
//! A kernel has one of two ways to say so, beside its `level`:
//!
//! - *until*: its `until` says for how many passes an invocation at level 1 will be at that level. Its block is left out for as many, and
//!   [`FOREVER`] where all are at level 0.
//! - *same*: its `same` names a record that it keeps as it is wherever nothing else is in [`Reach`] ([`Same`]). Blocks that hold nothing but
//!   that record are marked ([`Marks`]); where all blocks in reach are marked, a block is left out. If the kernel updates, something may be in
//!   the record's way: `until` says for how many passes there is nothing.

#[cfg(not(target_arch = "spirv"))]
use super::chunk::LANES;

/// Passes that a block is left out of when there is nothing more to do.
pub const FOREVER: u32 = u32::MAX;

/// The record that a kernel keeps as it is, if there is no other in reach.
#[derive(Clone, Copy)]
pub struct Same<const N: usize> {
    /// The record.
    pub record: [f32; N],
    /// Where an invocation looks.
    pub reach: Reach,
}

/// Invocations beyond its own whose records an invocation looks at, in each direction.
#[derive(Clone, Copy, Default)]
pub struct Reach {
    /// Towards smaller x.
    pub left: i32,
    /// Towards larger x.
    pub right: i32,
    /// Towards smaller y.
    pub below: i32,
    /// Towards larger y.
    pub above: i32,
}

impl Reach {
    /// The neighbours of its own.
    pub const NEIGHBOURS: Self = Self { left: 1, right: 1, below: 1, above: 1 };
    /// None beyond its own.
    pub const OWN: Self = Self { left: 0, right: 0, below: 0, above: 0 };
}

/// Which blocks of [`LANES`] invocations hold nothing but the record that kernels keep as it is, row by row. Such a kernel looks at the marks
/// of the buffers that it reads, and keeps the marks of the buffer that it writes. In all passes that share marks, that record is the same light.
#[cfg(not(target_arch = "spirv"))]
#[derive(Default)]
pub struct Marks<'a> {
    /// Marks of the chunk's blocks.
    pub own: &'a mut [bool],
    /// For a kernel that updates: the position of passes up to which a marked block of the chunk has nothing in its way.
    pub free_to: &'a mut [f32],
    /// Marks of each buffer of floats that is read, for all rows. Empty if there are none.
    pub reads: &'a [&'a [bool]],
    /// Rows in all.
    pub height: u32,
}

#[cfg(not(target_arch = "spirv"))]
impl Marks<'_> {
    /// Whether block `number` of the chunk is marked.
    #[inline(always)]
    pub(super) fn is_set(&self, number: usize) -> bool {
        self.own.get(number) == Some(&true)
    }

    #[inline(always)]
    pub(super) fn set(&mut self, number: usize, value: bool) {
        if let Some(mark) = self.own.get_mut(number) {
            *mark = value;
        }
        if let (false, Some(position)) = (value, self.free_to.get_mut(number)) {
            *position = f32::NEG_INFINITY;
        }
    }

    /// Whether nothing is in a marked block's way up to `position`.
    #[inline(always)]
    pub(super) fn is_free_to(&self, number: usize, position: f32) -> bool {
        self.free_to.get(number).is_some_and(|free_to| position <= *free_to)
    }

    #[inline(always)]
    pub(super) fn set_free_to(&mut self, number: usize, position: f32) {
        if let Some(free_to) = self.free_to.get_mut(number) {
            *free_to = position;
        }
    }

    /// Whether all blocks are marked that are in reach of the block of row `y` from column `x` on, out of `width` columns; beyond the grid
    /// they are.
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

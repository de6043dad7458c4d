//! Rows of a dispatch, as the CPU backend hands them to a kernel.

#[cfg(target_endian = "big")]
compile_error!("kernels read packed voxels as little-endian words");

use super::skip::Marks;
use core::ops::Range;
use core::sync::atomic::AtomicU32;

/// Invocations in a block of the CPU dispatch; one AVX-512 register of floats.
pub const LANES: usize = 16;

/// Rows of a dispatch, for the CPU.
pub struct Chunk<'a> {
    /// The first row.
    pub first_row: u32,
    /// Rows in the chunk.
    pub rows: u32,
    /// Invocations in a row.
    pub width: u32,
    /// Its rows that are run, counted from its first.
    pub inside: Range<u32>,
    /// The columns that are run; the first is that of a block.
    pub columns: Range<u32>,
    /// The uniform block.
    pub uniforms: &'a [u8],
    /// The buffers that are read, in order of their bindings. Not empty.
    pub reads: &'a [&'a [u32]],
    /// For each component of the output, this chunk's part: `rows · width` floats. Empty for a kernel that adds.
    pub output: &'a mut [&'a mut [f32]],
    /// Sums that a kernel adds to; empty for the others.
    pub sums: &'a [AtomicU32],
    /// For a kernel that skips *until* a pass: row by row for each block of [`LANES`] invocations the passes that it is to be left out of,
    /// from this one on, or [`super::skip::FOREVER`]; the kernel keeps count. All 0 before its first pass over a record. Empty for the others.
    pub rests: &'a mut [u32],
    /// For a kernel that skips *same* records: where they are.
    pub marks: Marks<'a>,
}

impl Chunk<'_> {
    /// The number of the block that begins at column `x` of the chunk's row `row`.
    #[inline(always)]
    pub(super) fn block(&self, row: u32, x: u32) -> usize {
        (row * self.width.div_ceil(LANES as u32) + x / LANES as u32) as usize
    }
}

/// The part of a dispatch's invocations that a pass runs over; the records of the others stay as they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// The first column, a multiple of [`LANES`], and the first row.
    pub first: [u32; 2],
    /// The column, a multiple of [`LANES`] or the width, and the row before which it ends.
    pub end: [u32; 2],
}

impl Window {
    /// All of `width` × `height` invocations.
    #[must_use]
    pub fn whole(width: u32, height: u32) -> Self {
        Self { first: [0, 0], end: [width, height] }
    }

    /// No invocation.
    #[must_use]
    pub fn empty() -> Self {
        Self { first: [0, 0], end: [0, 0] }
    }

    /// The invocations from `first` on before `end`, out of `width` in a row, and as many columns more as make whole blocks: the same ones on
    /// every backend, since an invocation that is not run keeps its record.
    #[must_use]
    pub fn around(first: [u32; 2], end: [u32; 2], width: u32) -> Self {
        let lanes = LANES as u32;
        Self { first: [first[0] / lanes * lanes, first[1]], end: [end[0].next_multiple_of(lanes).min(width), end[1]] }
    }
}

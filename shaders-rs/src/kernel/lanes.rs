//! A block's records: read where they lie in the chunk's buffers, written from local arrays.

use super::chunk::{Chunk, LANES};
use crate::math::select;

/// The lanes of a block in rows of [`LANES`] columns or more: [`LANES`], of which the compiler can tell no more than that it is that number or 0.
///
/// Knowing the number, the compiler would unroll short loops instead of making vector code of them. Not knowing that there is at most one round
/// of vector code, it would keep a loop around that round, and put every constant of the loop on the stack before it.
#[inline(always)]
pub(crate) fn whole() -> usize {
    (usize::from(core::hint::black_box(1u16)) & 1) * LANES
}

/// The column of a lane.
#[inline(always)]
pub(super) fn column(x: u32, lane: usize) -> u32 {
    debug_assert!(x.checked_add(lane as u32).is_some());
    // SAFETY: `x + lane` is below the dispatch's width, a `u32`. Knowing that the sum does not wrap lets neighbouring lanes' reads
    // become one contiguous load.
    unsafe { x.unchecked_add(lane as u32) }
}

/// The chunk's part of a planar buffer: for each component, where its floats start.
#[derive(Clone, Copy)]
pub(super) struct Records<const N: usize>([*mut f32; N]);

impl<const N: usize> Records<N> {
    /// All records of the chunk: at least `rows · width`.
    #[inline(always)]
    pub(super) fn new(chunk: &mut Chunk<'_>) -> Self {
        let count = chunk.rows as usize * chunk.width as usize;
        let output = &mut *chunk.output;
        assert!(output.len() == N && output.iter().all(|component| component.len() >= count));
        let mut starts = [core::ptr::null_mut(); N];
        for (start, component) in starts.iter_mut().zip(output) {
            *start = component.as_mut_ptr();
        }
        Self(starts)
    }

    /// Those from number `at` on.
    ///
    /// # Safety
    /// `at` must be at most their number.
    #[inline(always)]
    pub(super) unsafe fn at(&self, at: usize) -> Self {
        // SAFETY: the caller's promise.
        Self(self.0.map(|start| unsafe { start.add(at) }))
    }
}

/// The record of a lane, straight from the buffer: only components that a level uses are read.
#[inline(always)]
pub(super) fn take<const N: usize>(before: &Records<N>, lane: usize) -> [f32; N] {
    let mut record = [0.0; N];
    for (component, start) in record.iter_mut().zip(before.0) {
        // SAFETY: lanes count the invocations of a block, for each of which there is a record.
        *component = unsafe { *start.add(lane) };
    }
    record
}

#[inline(always)]
pub(super) fn put<const N: usize>(lanes: &mut [[f32; LANES]; N], lane: usize, record: [f32; N]) {
    for (lanes, component) in lanes.iter_mut().zip(record) {
        // SAFETY: `lane` counts to at most `LANES`. See `take`.
        unsafe { *lanes.get_unchecked_mut(lane) = component };
    }
}

/// Remembers the level that a lane needs.
#[inline(always)]
pub(super) fn put_level(levels: &mut [u32; LANES], lane: usize, level: u32) {
    // SAFETY: as in `put`.
    unsafe { *levels.get_unchecked_mut(lane) = level };
}

/// The level that a lane needs.
#[inline(always)]
pub(super) fn level_of(levels: &[u32; LANES], lane: usize) -> u32 {
    // SAFETY: as in `put`.
    unsafe { *levels.get_unchecked(lane) }
}

/// `record` if it has `changed`, else `before`.
#[inline(always)]
pub(super) fn choose<const N: usize>(changed: bool, mut record: [f32; N], before: [f32; N]) -> [f32; N] {
    for (component, before) in record.iter_mut().zip(before) {
        *component = select(changed, *component, before);
    }
    record
}

/// Writes the records of the lanes from `first` on and before `end` to the buffers.
#[inline(always)]
pub(super) fn copy_out<const N: usize>(lanes: &[[f32; LANES]; N], output: &Records<N>, first: usize, end: usize) {
    // Of a length that is known, a copy is two instructions instead of a call.
    if (first > 0) | (end < LANES) {
        // A copy is handed over: the array itself must not leave this function, see `drive::run`.
        let lanes = *lanes;
        return copy_some(&lanes, output, first, end.min(LANES));
    }
    for (lanes, start) in lanes.iter().zip(output.0) {
        // SAFETY: there is a record for each of the block's `LANES` invocations; nothing else refers to the chunk's part of the
        // buffer while the kernel runs.
        unsafe { start.cast::<[f32; LANES]>().write_unaligned(*lanes) };
    }
}

#[inline(never)]
fn copy_some<const N: usize>(lanes: &[[f32; LANES]; N], output: &Records<N>, first: usize, end: usize) {
    for (lanes, start) in lanes.iter().zip(output.0) {
        // SAFETY: as in `copy_out`, for the lanes from `first` on before `end`.
        unsafe { start.add(first).copy_from_nonoverlapping(lanes.as_ptr().add(first), end - first) };
    }
}

/// Writes `record` to `n` invocations.
#[inline(always)]
pub(super) fn fill<const N: usize>(output: &Records<N>, record: &[f32; N], n: usize) {
    for (component, start) in record.iter().zip(output.0) {
        for lane in 0..n {
            // SAFETY: as in `copy_out`, for `n` invocations.
            unsafe { *start.add(lane) = *component };
        }
    }
}

/// Whether `n` invocations have the bits of `record`.
#[inline(always)]
pub(super) fn all_are<const N: usize>(output: &Records<N>, record: &[f32; N], n: usize) -> bool {
    let mut differs = 0;
    for (component, start) in record.iter().zip(output.0) {
        for lane in 0..n {
            // SAFETY: as in `take`.
            differs |= unsafe { *start.add(lane) }.to_bits() ^ component.to_bits();
        }
        // Most blocks that differ do so in their first component.
        if differs != 0 {
            return false;
        }
    }
    true
}

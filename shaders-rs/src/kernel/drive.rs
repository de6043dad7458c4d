//! The loops of the CPU dispatch over a chunk's invocations.
//!
//! Rows are run in blocks of [`LANES`] invocations. A block's records live in local arrays, so that the loop over its lanes has
//! no aliasing stores and becomes vector code. A block runs at the union of the levels that its lanes need.
//!
//! Everything here is inlined into one function for each kernel and instruction set, where the mode is a constant. Kernels are given by the
//! traits below, and not as closures: a closure that is called from several places is not inlined, and the loop around it does not become
//! vector code.

use super::chunk::{Chunk, LANES};
use super::lanes::{Records, all_are, choose, column, copy_out, fill, level_of, put, put_level, take};
use super::skip::{FOREVER, Same};
use crate::field::sums::SharedSums;

/// Empty stretches, one behind the other, that a block looks over to find how long it rests.
const LOOKS: u32 = 8;

/// A kernel that adds to sums.
pub(super) trait Scatter {
    /// Runs invocation (x, y).
    fn scatter(&self, x: u32, y: u32, sums: &mut SharedSums<'_>);
}

/// A kernel with one body.
pub(super) trait Plain<const N: usize> {
    /// The record of invocation (x, y); `before` is its record so far if the kernel updates.
    fn record(&self, x: u32, y: u32, before: [f32; N]) -> [f32; N];
}

/// A kernel with a body for each of some levels.
pub(super) trait Leveled<const N: usize> {
    /// Whether it updates its record. It is then left alone at the levels 0 (nothing to do in this frame any more) and 1 (nothing now).
    const UPDATES: bool;

    /// The level that invocation (x, y) needs.
    fn level(&self, x: u32, y: u32, before: [f32; N]) -> u32;

    /// The record of invocation (x, y) at a level that has all bits of the level that it needs.
    fn record<const LEVEL: u32>(&self, x: u32, y: u32, before: [f32; N]) -> [f32; N];

    /// [`run`]s a block at the first of the kernel's levels that has all bits of `needed`.
    fn run(&self, needed: u32, block: &Block<N>, levels: &[u32; LANES]);
}

/// A kernel that can tell for how many passes an invocation has nothing to do.
pub(super) trait Until<const N: usize>: Leveled<N> {
    /// Passes behind the next one for which invocation (x, y), at level 1 now and for the first `known` of them, stays at that level.
    fn until(&self, x: u32, y: u32, before: [f32; N], known: f32) -> f32;
}

/// A kernel that keeps a record as it is.
pub(super) trait Keeps<const N: usize>: Leveled<N> {
    /// That record.
    fn same(&self) -> Option<Same<N>>;

    /// The position of the pass among the passes, and how far it is to the next.
    fn position(&self) -> (f32, f32);
}

/// Invocations of a row that run together.
///
/// Loops over lanes take [`LANES`] rounds, so that there is no scalar code for fewer: a block at the end of a row that has fewer invocations
/// of its own begins in the block before, whose lanes count for what the block needs, and are computed again but not written.
pub(super) struct Block<const N: usize> {
    /// The column of the first lane.
    x: u32,
    y: u32,
    /// The first lane that is the block's own.
    first: usize,
    lanes: usize,
    /// Records from the first lane's on.
    records: Records<N>,
}

/// The lanes of a block in rows of `width` columns.
#[inline(always)]
pub(super) fn lanes_in(width: u32) -> usize {
    LANES.min(width as usize)
}

impl<const N: usize> Block<N> {
    /// The block from column `x` of the chunk's row `row` on; `records` are all of the chunk, whose rows have `lanes` columns at least.
    #[inline(always)]
    fn new(chunk: &Chunk<'_>, records: &Records<N>, row: u32, x: u32, lanes: usize) -> Self {
        let first = lanes.min(LANES).saturating_sub((chunk.columns.end - x) as usize);
        // Buffers have less than 2³¹ words, and rows less columns: from these bits the compiler can tell that counting on from there does not
        // wrap, without which it would keep scalar code for the case that it does.
        let x = (x - first as u32) & (u32::MAX >> 1);
        // SAFETY: rows of the chunk have `width` records, so the first lane's and those of the other lanes are among them.
        let records = unsafe { records.at((row * chunk.width + x) as usize) };
        Self { x, y: chunk.first_row + row, first, lanes, records }
    }

    /// Its own records.
    #[inline(always)]
    fn own(&self) -> Records<N> {
        // SAFETY: `first` is below the number of lanes, for each of which there is a record.
        unsafe { self.records.at(self.first) }
    }

    /// How many these are.
    #[inline(always)]
    fn count(&self) -> usize {
        self.lanes.min(LANES) - self.first
    }

    /// The levels that the lanes need, and their union.
    #[inline(always)]
    fn levels<K: Leveled<N>>(&self, kernel: &K, levels: &mut [u32; LANES]) -> u32 {
        let mut needed = 0;
        for lane in 0..self.lanes {
            let level = kernel.level(column(self.x, lane), self.y, self.before::<K>(lane));
            needed |= level;
            put_level(levels, lane, level);
        }
        needed
    }

    #[inline(always)]
    fn before<K: Leveled<N>>(&self, lane: usize) -> [f32; N] {
        if K::UPDATES { take(&self.records, lane) } else { [0.0; N] }
    }

    /// Whether the block's own records are all the one that the kernel keeps.
    #[inline(always)]
    fn holds(&self, same: &Option<Same<N>>) -> bool {
        match same {
            Some(kept) => all_are(&self.own(), &kept.record, self.count()),
            None => false,
        }
    }

    /// The fewest passes for which all lanes have nothing to do, if that is so for `known`.
    #[inline(always)]
    fn until<K: Until<N>>(&self, kernel: &K, known: f32) -> f32 {
        // Numbers that are not negative have the order of their bits, whose least one vector code finds.
        let mut least = u32::MAX;
        for lane in 0..self.lanes {
            let passes = kernel.until(column(self.x, lane), self.y, self.before::<K>(lane), known);
            least = least.min(passes.to_bits());
        }
        f32::from_bits(least)
    }

    /// Passes that the block rests: looks ahead, each time from the end of the passes known so far.
    #[inline(always)]
    fn rest<K: Until<N>>(&self, kernel: &K) -> u32 {
        let mut known = 0;
        for _ in 0..LOOKS {
            // The cast cuts off and saturates.
            let found = self.until(kernel, known as f32) as u32;
            let farther = found > known;
            known = known.max(found);
            if !farther || known == FOREVER {
                break;
            }
        }
        known
    }

    /// Runs the lanes at the levels that they need; whether any had work to do.
    #[inline(always)]
    fn work<K: Leveled<N>>(&self, kernel: &K) -> bool {
        let mut levels = [0; LANES];
        let needed = self.levels(kernel, &mut levels);
        if needed > K::UPDATES as u32 {
            kernel.run(needed, self, &levels);
        }
        needed > 0
    }
}

/// Runs the lanes of a block at one level, and writes their records.
///
/// Each level has arrays of its own: LLVM looks at no more than 100 uses of an array to find out that nothing else points to it,
/// and without knowing that it does not make vector code.
#[inline(always)]
pub(super) fn run<K: Leveled<N>, const N: usize, const LEVEL: u32>(
    kernel: &K,
    block: &Block<N>,
    levels: &[u32; LANES],
) {
    let mut outputs = [[0.0f32; LANES]; N];
    for lane in 0..block.lanes {
        let record = kernel.record::<LEVEL>(column(block.x, lane), block.y, block.before::<K>(lane));
        // A lane that needs less leaves its record alone, though its block does more.
        let record =
            if K::UPDATES { choose(level_of(levels, lane) > 1, record, take(&block.records, lane)) } else { record };
        put(&mut outputs, lane, record);
    }
    copy_out(&outputs, &block.records, block.first, block.lanes);
}

/// Runs a kernel that adds to sums: there is no record to put in order, and nothing to gain from blocks.
#[inline(always)]
pub(super) fn scatter<K: Scatter>(kernel: &K, chunk: &mut Chunk<'_>, _lanes: usize) -> bool {
    let mut sums = SharedSums(chunk.sums);
    for row in chunk.inside.clone() {
        for x in chunk.columns.clone() {
            kernel.scatter(x, chunk.first_row + row, &mut sums);
        }
    }
    true
}

/// Runs a kernel with one body.
#[inline(always)]
pub(super) fn plain<K: Plain<N>, const N: usize>(kernel: &K, chunk: &mut Chunk<'_>, lanes: usize) -> bool {
    let records = Records::<N>::new(chunk);
    for row in chunk.inside.clone() {
        let mut x = chunk.columns.start;
        while x < chunk.columns.end {
            let block = Block::new(chunk, &records, row, x, lanes);
            let mut outputs = [[0.0f32; LANES]; N];
            for lane in 0..block.lanes {
                let record = kernel.record(column(block.x, lane), block.y, take(&block.records, lane));
                put(&mut outputs, lane, record);
            }
            copy_out(&outputs, &block.records, block.first, block.lanes);
            x += LANES as u32;
        }
    }
    true
}

/// Runs a kernel with levels; whether any invocation had work to do.
#[inline(always)]
pub(super) fn leveled<K: Leveled<N>, const N: usize>(kernel: &K, chunk: &mut Chunk<'_>, lanes: usize) -> bool {
    let records = Records::<N>::new(chunk);
    let mut any = false;
    for row in chunk.inside.clone() {
        let mut x = chunk.columns.start;
        while x < chunk.columns.end {
            let block = Block::new(chunk, &records, row, x, lanes);
            any |= block.work(kernel);
            x += LANES as u32;
        }
    }
    any
}

/// Runs a kernel that updates, but for blocks that have nothing to do until a later pass; whether any invocation had work to do.
#[inline(always)]
pub(super) fn skip_until<K: Until<N>, const N: usize>(kernel: &K, chunk: &mut Chunk<'_>, lanes: usize) -> bool {
    let records = Records::<N>::new(chunk);
    let mut any = false;
    for row in chunk.inside.clone() {
        let mut x = chunk.columns.start;
        while x < chunk.columns.end {
            let block = Block::new(chunk, &records, row, x, lanes);
            let number = chunk.block(row, x);
            x += LANES as u32;
            let Some(rest) = chunk.rests.get_mut(number) else { break };
            if *rest > 0 {
                any |= *rest != FOREVER;
                *rest -= (*rest != FOREVER) as u32;
                continue;
            }
            let mut levels = [0; LANES];
            let needed = block.levels(kernel, &mut levels);
            match needed {
                0 => *rest = FOREVER,
                1 => *rest = block.rest(kernel),
                _ => kernel.run(needed, &block, &levels),
            }
            any |= needed > 0;
        }
    }
    any
}

/// Runs a kernel that writes, but for blocks around which all records are the same; whether any invocation had work to do.
#[inline(always)]
pub(super) fn skip_same<K: Keeps<N>, const N: usize>(kernel: &K, chunk: &mut Chunk<'_>, lanes: usize) -> bool {
    let records = Records::<N>::new(chunk);
    let same = kernel.same();
    let mut any = false;
    for row in chunk.inside.clone() {
        let mut x = chunk.columns.start;
        while x < chunk.columns.end {
            let block = Block::new(chunk, &records, row, x, lanes);
            let number = chunk.block(row, x);
            let first = x;
            x += LANES as u32;
            if let Some(kept) = &same
                && chunk.marks.around(&kept.reach, first, block.y, chunk.width)
            {
                if !chunk.marks.is_set(number) {
                    fill(&block.own(), &kept.record, block.count());
                    chunk.marks.set(number, true);
                }
                continue;
            }
            any |= block.work(kernel);
            let untouched = block.holds(&same);
            chunk.marks.set(number, untouched);
        }
    }
    any
}

/// Runs a kernel that updates, but for blocks around which all records are the same and have nothing in their way; whether any invocation
/// had work to do.
#[inline(always)]
pub(super) fn skip_same_until<K: Keeps<N> + Until<N>, const N: usize>(
    kernel: &K,
    chunk: &mut Chunk<'_>,
    lanes: usize,
) -> bool {
    let records = Records::<N>::new(chunk);
    let same = kernel.same();
    let (position, step) = kernel.position();
    let mut any = false;
    for row in chunk.inside.clone() {
        let mut x = chunk.columns.start;
        while x < chunk.columns.end {
            let block = Block::new(chunk, &records, row, x, lanes);
            let number = chunk.block(row, x);
            let first = x;
            x += LANES as u32;
            if let Some(kept) = &same
                && chunk.marks.is_set(number)
                && chunk.marks.around(&kept.reach, first, block.y, chunk.width)
            {
                if chunk.marks.is_free_to(number, position) {
                    continue;
                }
                let needed = block.levels(kernel, &mut [0; LANES]);
                if needed <= 1 {
                    chunk.marks.set_free_to(number, position + block.until(kernel, 0.0) * step);
                    any |= needed > 0;
                    continue;
                }
            }
            any |= block.work(kernel);
            let untouched = block.holds(&same);
            chunk.marks.set(number, untouched);
        }
    }
    any
}

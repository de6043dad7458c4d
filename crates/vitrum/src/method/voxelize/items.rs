//! Division of the work: a large triangle among many invocations, and all triangles among several batches.

use crate::backend::{Buffer, Pass, PassList};
use bytemuck::bytes_of;
use rayon::prelude::*;
use vitrum_kernels::abi::dispatch::Dispatch;
use vitrum_kernels::abi::voxelize::{VoxelizeUniforms, item, triangle};
use vitrum_kernels::kernel::{Kernel, Window};

/// Rows up to which a triangle is one item.
const SMALL: u32 = triangle::SMALL as u32;

/// Items in a batch, unless a single triangle has more.
const BATCH: u64 = 1 << 20;

/// Invocations in a row of a dispatch; eight such rows are the chunk that a processor's core takes at a time.
const WIDTH: u32 = 64;
/// The most rows of a dispatch.
const MOST_ROWS: u32 = 65535 * 8;

/// A triangle's slices, from `first` on.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::method) struct Slices {
    pub first: u32,
    pub count: u32,
    /// Number of rows of a slice.
    pub rows: u32,
}

impl Slices {
    fn items(self) -> u32 {
        if self.count > 1 && self.count.saturating_mul(self.rows) > SMALL { self.count } else { self.count.min(1) }
    }
}

/// A batch: the triangles `first`…`end` with their items.
pub(in crate::method) struct Batch {
    pub first: usize,
    pub end: usize,
    /// The items as words in the layout of [`item`]; triangles are counted from `first`.
    pub items: Vec<u32>,
}

impl Batch {
    pub(in crate::method) fn items(&self) -> u32 {
        (self.items.len() / item::SIZE) as u32
    }
}

/// The plan of the items: the index of each triangle's first item in the list of all items, and their number.
pub(in crate::method) struct Plan<'a> {
    slices: &'a [Slices],
    begins: Vec<u64>,
}

impl<'a> Plan<'a> {
    pub(in crate::method) fn new(slices: &'a [Slices]) -> Self {
        let mut begins = Vec::with_capacity(slices.len() + 1);
        let mut sum = 0;
        for slices in slices {
            begins.push(sum);
            sum += u64::from(slices.items());
        }
        begins.push(sum);
        Self { slices, begins }
    }

    /// The number of items of all triangles.
    pub(in crate::method) fn total(&self) -> u64 {
        self.begins[self.slices.len()]
    }

    /// Batches in order; those without items are left out.
    pub(in crate::method) fn batches(&self) -> impl Iterator<Item = Batch> + '_ {
        let mut first = 0;
        std::iter::from_fn(move || {
            while first < self.slices.len() {
                let limit = self.begins[first] + BATCH;
                let fitting = self.begins.partition_point(|&begin| begin <= limit) - 1;
                let range = first..fitting.max(first + 1);
                first = range.end;
                let batch = self.batch(range.start, range.end);
                if !batch.items.is_empty() {
                    return Some(batch);
                }
            }
            None
        })
    }

    fn batch(&self, first: usize, end: usize) -> Batch {
        let count = (self.begins[end] - self.begins[first]) as usize;
        let mut items = vec![0; count * item::SIZE];
        // Each thread gets the triangles of a part, and the items that are theirs.
        let part = (end - first).div_ceil(4 * rayon::current_num_threads()).max(1);
        let mut rest = items.as_mut_slice();
        let mut parts = Vec::new();
        for start in (first..end).step_by(part) {
            let stop = (start + part).min(end);
            let words = (self.begins[stop] - self.begins[start]) as usize * item::SIZE;
            let (head, tail) = rest.split_at_mut(words);
            rest = tail;
            parts.push((start..stop, head));
        }
        parts.into_par_iter().for_each(|(triangles, words)| {
            let mut words = words.chunks_exact_mut(item::SIZE);
            for index in triangles {
                let Slices { first: slice, count, .. } = self.slices[index];
                let items = self.slices[index].items();
                for (number, words) in (0..items).zip(&mut words) {
                    words[item::TRIANGLE] = (index - first) as u32;
                    words[item::FIRST] = slice + number;
                    words[item::COUNT] = if items == 1 { count } else { 1 };
                }
            }
        });
        Batch { first, end, items }
    }
}

/// Invocations across and down for `count` pieces of work.
pub(in crate::method) fn dispatch(count: u32) -> [u32; 2] {
    let width = WIDTH.max(count.div_ceil(MOST_ROWS));
    [width, count.div_ceil(width).max(1)]
}

/// A pass of `count` pieces of work; the rest of the uniforms is the caller's.
pub(in crate::method) fn pass(
    kernel: &'static Kernel,
    count: u32,
    mode: u32,
    mut uniforms: VoxelizeUniforms,
    buffers: &[Buffer],
) -> PassList {
    let [width, height] = dispatch(count);
    uniforms.dispatch = Dispatch { width, height, mode };
    uniforms.work = count;
    let pass = Pass {
        kernel,
        uniforms: bytes_of(&uniforms).to_vec(),
        buffers: buffers.to_vec(),
        width,
        height,
        start: 0,
        window: Window::whole(width, height),
    };
    PassList { passes: vec![pass], ..PassList::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_triangles_are_cut_and_small_ones_are_not() {
        let slices = [
            Slices { first: 0, count: 4, rows: 8 },
            Slices::default(),
            Slices { first: 7, count: 3, rows: 20 },
            Slices { first: 0, count: 1, rows: 500 },
        ];
        let plan = Plan::new(&slices);
        assert_eq!(plan.total(), 5);
        let batches: Vec<Batch> = plan.batches().collect();
        assert_eq!(batches.len(), 1);
        assert_eq!(batches[0].items, [0, 0, 4, 2, 7, 1, 2, 8, 1, 2, 9, 1, 3, 0, 1]);
    }

    #[test]
    fn batches_have_every_triangle_once() {
        let slices = vec![Slices { first: 0, count: 1 << 12, rows: 1 << 12 }; 1000];
        let plan = Plan::new(&slices);
        let batches: Vec<Batch> = plan.batches().collect();
        assert!(batches.len() > 3);
        assert_eq!(batches.iter().map(|batch| u64::from(batch.items())).sum::<u64>(), plan.total());
        assert!(batches.windows(2).all(|pair| pair[0].end == pair[1].first));
        assert!(batches.iter().all(|batch| u64::from(batch.items()) <= BATCH));
    }

    #[test]
    fn a_dispatch_has_room_for_all_and_few_rows() {
        for count in [1, 63, 64, 65, 1 << 20, u32::MAX >> 2] {
            let [width, height] = dispatch(count);
            assert!(u64::from(width) * u64::from(height) >= u64::from(count) && height <= MOST_ROWS);
        }
    }
}

//! Buffers of pages: a table with an entry for each page, slots that one value fills, and slots of pages that come and go.

use super::residency::Residency;
use super::schedule::{Batch, peak_pages, schedule};
use crate::backend::{Backend, BackendError, Buffer, Contents, Fill, Write};
use crate::method::sweep::uploaded::UploadedVolumes;
use crate::method::sweep::voxels::bytes;
use bytemuck::Pod;
use rayon::prelude::*;
use std::sync::Arc;
use vitrum_io::{Volume, Voxels};
use vitrum_kernels::abi::format::{Format, page};

/// Largest number of words of one write.
const WORDS_PER_WRITE: usize = 1 << 22;

/// Largest number of unchanged table entries between two changed ones that are written again, instead of beginning another write.
const ENTRIES_BETWEEN: u32 = 256;

/// The buffer of a volume's pages, with the schedule of the writes to it.
pub(in crate::method::sweep) struct Pool {
    pub(in crate::method::sweep) buffer: Buffer,
    volume: Volume,
    residency: Residency,
    layout: Layout,
    batches: Vec<Batch>,
}

/// The layout of a pool's buffer: the page table, then slots that one value fills, then slots of pages that come and go.
#[derive(Clone, Copy)]
struct Layout {
    stored: Format,
    table_words: u64,
    slot_words: u64,
    voxels_per_word: u64,
    fills: u32,
}

impl Layout {
    fn new(stored: Format, residency: &Residency) -> Self {
        let voxels_per_word = 4 / stored.bytes();
        Self {
            stored,
            table_words: residency.filled.len() as u64,
            slot_words: page::STRIDE as u64 / voxels_per_word,
            voxels_per_word,
            fills: residency.fills.len() as u32,
        }
    }

    fn bytes(&self, slots: usize) -> u64 {
        (self.table_words + (u64::from(self.fills) + slots as u64) * self.slot_words) * 4
    }

    /// The number of slots that fit a buffer of `bytes` bytes.
    fn slots(&self, bytes: u64) -> usize {
        usize::try_from((bytes - self.bytes(0)) / (self.slot_words * 4)).unwrap_or(usize::MAX)
    }

    /// Offset of a slot in words; slots are counted from the first one that one value fills.
    fn start(&self, slot: u32) -> u64 {
        self.table_words + u64::from(slot) * self.slot_words
    }

    /// The table's entry of a page in `slot`. The limit on the buffer keeps it below 2³¹.
    fn entry(&self, slot: u32) -> u32 {
        (self.start(slot) * self.voxels_per_word) as u32
    }
}

/// The shares of `limit` bytes for several volumes, each given by its least and its largest useful number of bytes. The bytes beyond
/// the sum of the least are divided in proportion to the useful ones; `None` if the limit is below that sum.
fn shares(limit: u64, wanted: &[[u64; 2]]) -> Option<Vec<u64>> {
    let least: u64 = wanted.iter().map(|[least, _]| least).sum();
    let rest = limit.checked_sub(least)?;
    let usable: u64 = wanted.iter().map(|[least, all]| all - least).sum();
    let part = |beyond: u64| u128::from(rest.min(usable)) * u128::from(beyond) / u128::from(usable.max(1));
    Some(wanted.iter().map(|[least, all]| least + part(all - least) as u64).collect())
}

/// The pools of `volumes`, one each: within the backend's limits together, or with the fewest slots that suffice.
///
/// # Errors
/// Where the pages that one plane needs are too many.
pub(in crate::method::sweep) fn pools(
    volumes: &[&Volume],
    residencies: Vec<Residency>,
    uploaded: &UploadedVolumes,
    backend: &mut dyn Backend,
) -> Result<Vec<Pool>, BackendError> {
    let layouts: Vec<Layout> = residencies.iter().map(|residency| Layout::new(uploaded.format, residency)).collect();
    let of_each = layouts.iter().zip(&residencies);
    let wanted = of_each
        .map(|(layout, residency)| [peak_pages(&residency.needed), residency.needed.len()].map(|n| layout.bytes(n)));
    let wanted: Vec<[u64; 2]> = wanted.collect();
    // Kernels count stored voxels by a signed 32-bit number.
    let largest = backend.largest_buffer().min(i32::MAX as u64 * uploaded.format.bytes());
    let limit = backend.volume_limit();
    let too_small = |needed: u64, limit: u64, of: &[&Volume], asked_for: bool| BackendError::VolumeLimit {
        whole: of.iter().map(|volume| bytes(volume, uploaded.format)).sum(),
        needed,
        limit,
        asked_for,
        adapter: backend.adapter(),
    };
    if let Some(at) = wanted.iter().position(|&[least, _]| least > largest) {
        return Err(too_small(wanted[at][0], largest, &volumes[at..=at], false));
    }
    let shares = shares(limit, &wanted).ok_or_else(|| {
        let streamed: u64 = wanted.iter().map(|[least, _]| least).sum();
        // Pages overlap: a small volume takes less in one piece.
        let sizes = volumes.iter().map(|volume| bytes(volume, uploaded.format));
        let whole = sizes.clone().all(|size| size <= largest).then(|| sizes.sum());
        too_small(streamed.min(whole.unwrap_or(u64::MAX)), limit, volumes, true)
    })?;
    let mut pools = Vec::new();
    for ((((volume, residency), layout), share), [least, _]) in
        volumes.iter().zip(residencies).zip(layouts).zip(shares).zip(wanted)
    {
        let room = layout.slots(if uploaded.tight { least } else { share.min(largest) });
        let slots = residency.needed.len().min(room);
        let buffer = backend.create("voxels", Contents::Zeros(layout.bytes(slots)))?;
        let batches = schedule(&residency.needed, slots);
        pools.push(Pool { buffer, volume: (*volume).clone(), residency, layout, batches });
    }
    Ok(pools)
}

impl Pool {
    /// The writes to the buffer in the course of a frame; `passes` has the number of the first pass of each plane.
    pub(in crate::method::sweep) fn writes(self, passes: &[usize]) -> Vec<Write> {
        let Self { buffer, volume, residency, layout, batches } = self;
        let mut writes = Vec::new();
        let mut add = |before: usize, start: u64, words: usize, fill: Arc<Fill>| {
            writes.push(Write { before, buffer: buffer.clone(), start, words, fill });
        };
        let mut table: Vec<u32> = residency.filled.iter().map(|&fill| layout.entry(u32::from(fill))).collect();
        add(0, 0, table.len(), copy(table.clone()));
        for (slot, &value) in (0..).zip(&residency.fills) {
            add(0, layout.start(slot), layout.slot_words as usize, constant(layout.stored, value));
        }
        let source = Arc::new(Source { volume, pages: residency.pages, stored: layout.stored });
        for Batch { plane, pages } in batches {
            let before = passes[plane as usize];
            let follows = |a: &(u32, u32), b: &(u32, u32)| a.0 + 1 == b.0;
            let most = WORDS_PER_WRITE / layout.slot_words as usize;
            for run in pages.chunk_by(follows).flat_map(|run| run.chunks(most)) {
                let numbers: Vec<u32> = run.iter().map(|&(_, page)| page).collect();
                let words = run.len() * layout.slot_words as usize;
                add(
                    before,
                    layout.start(layout.fills + run[0].0),
                    words,
                    source.fill(numbers, layout.slot_words as usize),
                );
            }
            for &(slot, page) in &pages {
                table[page as usize] = layout.entry(layout.fills + slot);
            }
            let mut numbers: Vec<u32> = pages.iter().map(|&(_, page)| page).collect();
            numbers.sort_unstable();
            for run in numbers.chunk_by(|a, b| b - a <= ENTRIES_BETWEEN) {
                let entries = &table[run[0] as usize..=run[run.len() - 1] as usize];
                add(before, u64::from(run[0]), entries.len(), copy(entries.to_vec()));
            }
        }
        writes
    }
}

/// A fill that copies words.
fn copy(words: Vec<u32>) -> Arc<Fill> {
    Arc::new(move |to| to.copy_from_slice(&words))
}

/// A fill that repeats a stored value.
fn constant(stored: Format, value: f32) -> Arc<Fill> {
    let word = match stored.bytes() {
        1 => u32::from_le_bytes([value as u8; 4]),
        2 => u32::from(value as u16) * 0x1_0001,
        _ => value.to_bits(),
    };
    Arc::new(move |to| to.fill(word))
}

/// The source of pages: a volume's voxels, and the format in which a slot stores them.
struct Source {
    volume: Volume,
    pages: [u32; 3],
    stored: Format,
}

impl Source {
    /// A fill that writes pages one after the other.
    fn fill(self: &Arc<Self>, numbers: Vec<u32>, slot_words: usize) -> Arc<Fill> {
        let source = Arc::clone(self);
        Arc::new(move |to| {
            to.par_chunks_exact_mut(slot_words).zip(&numbers).for_each(|(to, &number)| source.write(number, to));
        })
    }

    /// Writes a page. One that cannot be read is zeros, and the frame fails at its end.
    fn write(&self, number: u32, to: &mut [u32]) {
        let Some(paged) = &self.volume.paged else {
            return self.copy(&self.volume.voxels, ([0; 3], self.volume.dimensions), number, to);
        };
        let first = self.first(number);
        let inside = |at: i64, axis: usize| at.clamp(0, i64::from(self.volume.dimensions[axis]) - 1) as u32;
        let low = [0, 1, 2].map(|axis| inside(first[axis], axis));
        let size = [0, 1, 2].map(|axis| inside(first[axis] + i64::from(page::ROW) - 1, axis) - low[axis] + 1);
        match paged.read(low, size) {
            Some(block) => self.copy(&block, (low, size), number, to),
            None => to.fill(0),
        }
    }

    /// Copies a page's voxels from the block that has `size` voxels from `low` on.
    fn copy(&self, voxels: &Voxels, block: ([u32; 3], [u32; 3]), number: u32, to: &mut [u32]) {
        let floats = self.stored.bytes() == 4;
        match voxels {
            Voxels::U8(voxels) if floats => self.page::<_, f32>(voxels, block, number, to),
            Voxels::U16(voxels) if floats => self.page::<_, f32>(voxels, block, number, to),
            Voxels::U8(voxels) => self.page::<_, u8>(voxels, block, number, to),
            Voxels::U16(voxels) => self.page::<_, u16>(voxels, block, number, to),
            Voxels::F32(voxels) => self.page::<_, f32>(voxels, block, number, to),
        }
    }

    /// The first place of a page, which may lie before the grid.
    fn first(&self, number: u32) -> [i64; 3] {
        [0, 1, 2].map(|axis| {
            let at = number / self.pages[..axis].iter().product::<u32>() % self.pages[axis];
            i64::from(at) * i64::from(page::EDGE) - 1 - i64::from(page::BEFORE)
        })
    }

    /// As [`Self::copy`], with the nearest voxel of the grid for places beyond it.
    fn page<T: Copy, U: From<T> + Pod>(
        &self,
        voxels: &[T],
        (low, sizes): ([u32; 3], [u32; 3]),
        number: u32,
        to: &mut [u32],
    ) {
        let to: &mut [U] = bytemuck::cast_slice_mut(to);
        let first = self.first(number);
        // Places beyond the grid lie beyond the block, too, which ends there.
        let limited = |at: i64, axis: usize| (at - i64::from(low[axis])).clamp(0, i64::from(sizes[axis]) - 1) as usize;
        let [width, height, _] = sizes.map(|n| n as usize);
        let edge = page::ROW as usize;
        for (row, to) in to[..edge * edge * edge].chunks_exact_mut(edge).enumerate() {
            let y = limited(first[1] + (row % edge) as i64, 1);
            let z = limited(first[2] + (row / edge) as i64, 2);
            let from = &voxels[(z * height + y) * width..][..width];
            for (x, to) in (first[0]..).zip(to) {
                *to = U::from(from[limited(x, 0)]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::shares;

    #[test]
    fn what_is_allowed_is_shared() {
        assert_eq!(shares(99, &[[40, 100], [60, 60]]), None);
        assert_eq!(shares(100, &[[40, 100], [60, 60]]), Some(vec![40, 60]));
        assert_eq!(shares(u64::MAX, &[[40, 100], [60, 80]]), Some(vec![100, 80]));
        assert_eq!(shares(130, &[[40, 100], [20, 80]]), Some(vec![75, 55]));
        assert_eq!(shares(130, &[[40, 40]]), Some(vec![40]));
    }
}

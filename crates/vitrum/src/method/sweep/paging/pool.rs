//! The buffer that pages come to: a table with an entry for each page, slots for those that are filled with one value, and slots for
//! those that come and go.

use super::needs::Needs;
use super::schedule::{Batch, busiest, schedule};
use crate::backend::{Backend, BackendError, Buffer, Fill, Write};
use bytemuck::Pod;
use rayon::prelude::*;
use std::sync::Arc;
use vitrum_io::{Volume, Voxels};
use vitrum_kernels::abi::grid::{format, page};

/// Words that are written at once.
const WORDS_PER_WRITE: usize = 1 << 22;

/// Entries of the table that are written again rather than begin another write.
const ENTRIES_BETWEEN: u32 = 256;

/// Pages along each axis.
pub(in crate::method::sweep) fn count(dimensions: [u32; 3]) -> [u32; 3] {
    dimensions.map(|n| (n >> page::SHIFT) + 1)
}

/// The format of a volume in pages, if it can be stored so.
pub(in crate::method::sweep) fn paged(voxels: &Voxels) -> Option<u32> {
    match voxels {
        Voxels::U8(_) => Some(format::U8_PAGED),
        Voxels::U16(_) => Some(format::U16_PAGED),
        Voxels::F32(_) => None,
    }
}

/// The buffer, and when pages come to it.
pub(in crate::method::sweep) struct Pool {
    pub(in crate::method::sweep) buffer: Buffer,
    layout: Layout,
    batches: Vec<Batch>,
}

/// Where things lie in the buffer.
#[derive(Clone, Copy)]
struct Layout {
    table_words: u64,
    slot_words: u64,
    voxels_per_word: u64,
    fills: u32,
}

impl Layout {
    fn new(volume: &Volume, needs: &Needs) -> Self {
        let voxels_per_word = if paged(&volume.voxels) == Some(format::U8_PAGED) { 4 } else { 2 };
        Self {
            table_words: needs.filled.len() as u64,
            slot_words: page::STRIDE as u64 / voxels_per_word,
            voxels_per_word,
            fills: needs.fills.len() as u32,
        }
    }

    fn words(&self, slots: usize) -> u64 {
        self.table_words + (u64::from(self.fills) + slots as u64) * self.slot_words
    }

    /// The first word of a slot, counted from the first that is filled with one value.
    fn start(&self, slot: u32) -> u64 {
        self.table_words + u64::from(slot) * self.slot_words
    }

    /// The entry of a page in `slot`. It is below 2³¹ by the limit of the buffer.
    fn entry(&self, slot: u32) -> u32 {
        (self.start(slot) * self.voxels_per_word) as u32
    }
}

impl Pool {
    /// A buffer within the backend's limit, or with as few slots as will do if it is to be `tight`.
    ///
    /// # Errors
    /// Where the pages that one plane needs are too many.
    pub(in crate::method::sweep) fn new(
        volume: &Volume,
        needs: &Needs,
        tight: bool,
        backend: &mut dyn Backend,
    ) -> Result<Self, BackendError> {
        let layout = Layout::new(volume, needs);
        // Kernels count stored voxels by a signed 32-bit number.
        let most = (i32::MAX as u64 / layout.voxels_per_word * 4).min(backend.volume_limit());
        let busiest = busiest(&needs.needed);
        let least = layout.words(busiest) * 4;
        if least > most {
            return Err(BackendError::VolumeLimit {
                whole: volume.bytes() as u64,
                needed: least,
                limit: most,
                adapter: backend.adapter(),
            });
        }
        let room = (most / 4 - layout.words(0)) / layout.slot_words;
        let room = if tight { busiest } else { usize::try_from(room).unwrap_or(usize::MAX) };
        let slots = needs.needed.len().min(room);
        let batches = schedule(&needs.needed, slots);
        let buffer = backend.create_zeroed("voxels", layout.words(slots) * 4)?;
        Ok(Self { buffer, layout, batches })
    }

    /// What is written to it in the course of a frame; `passes` says which is the first of each plane.
    pub(in crate::method::sweep) fn writes(self, volume: &Volume, needs: &Needs, passes: &[usize]) -> Vec<Write> {
        let Self { buffer, layout, batches } = self;
        let mut writes = Vec::new();
        let mut add = |before: usize, start: u64, words: usize, fill: Arc<Fill>| {
            writes.push(Write { before, buffer, start, words, fill });
        };
        let mut table: Vec<u32> = needs.filled.iter().map(|&fill| layout.entry(u32::from(fill))).collect();
        add(0, 0, table.len(), copy(table.clone()));
        for (slot, &value) in (0..).zip(&needs.fills) {
            add(0, layout.start(slot), layout.slot_words as usize, constant(&volume.voxels, value));
        }
        let source = Arc::new(Source { volume: volume.clone(), pages: needs.pages });
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

/// Writes these words.
fn copy(words: Vec<u32>) -> Arc<Fill> {
    Arc::new(move |to| to.copy_from_slice(&words))
}

/// Writes a stored value again and again.
fn constant(voxels: &Voxels, value: f32) -> Arc<Fill> {
    let word = match voxels {
        Voxels::U8(_) => u32::from_le_bytes([value as u8; 4]),
        Voxels::U16(_) => u32::from(value as u16) * 0x1_0001,
        Voxels::F32(_) => value.to_bits(),
    };
    Arc::new(move |to| to.fill(word))
}

/// What pages are made of.
struct Source {
    volume: Volume,
    pages: [u32; 3],
}

impl Source {
    /// Writes pages one after the other.
    fn fill(self: &Arc<Self>, numbers: Vec<u32>, slot_words: usize) -> Arc<Fill> {
        let source = Arc::clone(self);
        Arc::new(move |to| {
            to.par_chunks_exact_mut(slot_words).zip(&numbers).for_each(|(to, &number)| match &source.volume.voxels {
                Voxels::U8(voxels) => source.page::<u8>(voxels, number, bytemuck::cast_slice_mut(to)),
                Voxels::U16(voxels) => source.page::<u16>(voxels, number, bytemuck::cast_slice_mut(to)),
                Voxels::F32(voxels) => source.page::<f32>(voxels, number, bytemuck::cast_slice_mut(to)),
            });
        })
    }

    /// Copies a page's voxels; beyond the grid the nearest ones.
    fn page<T: Pod>(&self, voxels: &[T], number: u32, to: &mut [T]) {
        let sizes = self.volume.dimensions.map(|n| n as usize);
        let first = |axis: usize| {
            let at = number / self.pages[..axis].iter().product::<u32>() % self.pages[axis];
            i64::from(at) * i64::from(page::EDGE) - 1 - i64::from(page::BEFORE)
        };
        let limited = |at: i64, axis: usize| at.clamp(0, sizes[axis] as i64 - 1) as usize;
        let edge = page::ROW as usize;
        for (row, to) in to[..edge * edge * edge].chunks_exact_mut(edge).enumerate() {
            let y = limited(first(1) + (row % edge) as i64, 1);
            let z = limited(first(2) + (row / edge) as i64, 2);
            let from = &voxels[(z * sizes[1] + y) * sizes[0]..][..sizes[0]];
            for (x, to) in (first(0)..).zip(to) {
                *to = from[limited(x, 0)];
            }
        }
    }
}

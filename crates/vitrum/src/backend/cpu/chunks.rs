//! Passes over the same records, chunk by chunk.

use super::asked::Asked;
use crate::backend::{Buffer, Pass};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};
use vitrum_kernels::kernel::skip::Marks;
use vitrum_kernels::kernel::{Access, Chunk, Element, InstructionSet, LANES, Skip, Window};
use web_time::Instant;

/// Invocations in a chunk of work of a kernel that adds, if rows are long.
const CHUNK_INVOCATIONS: u32 = 1 << 13;

/// Rows in a chunk of work: small enough to balance, large enough that handing it out costs nothing.
const CHUNK_ROWS: u32 = 8;

/// Bytes of records that go through several passes before the next ones do: half of a processor's second-level cache.
const CACHED_BYTES: usize = 1 << 19;

/// Invocations of passes that run together, not many more than a second's work.
const INVOCATIONS_TOGETHER: u64 = 1 << 27;

/// Records that a pass writes: the number of their buffer, and where they start in it.
pub(super) type Written = (usize, u64);

/// The state of the blocks of a buffer's records, by which blocks are skipped.
#[derive(Default)]
pub(super) struct BlockState {
    /// Invocations across and down.
    size: (u32, u32),
    /// The kernel that wrote the records last.
    kernel: Option<&'static str>,
    /// For each block, the number of that kernel's passes that skip it, see [`Chunk::rests`].
    rests: Vec<u32>,
    /// Marks of the blocks that hold only the record that kernels keep as it is, see [`Marks`]; empty if they are unknown.
    same: Vec<bool>,
    /// For each marked block, the position of a pass up to which its light meets only empty space.
    free_to: Vec<f32>,
}

impl BlockState {
    /// Marks of the blocks of the pass's invocations that hold only the record that kernels keep as it is; empty if they are unknown.
    pub(super) fn same(&self, pass: &Pass) -> &[bool] {
        if self.size == (pass.width, pass.height) { &self.same } else { &[] }
    }
}

/// A pass, with the data that its chunks share.
pub(super) struct PreparedPass<'a> {
    pass: &'a Pass,
    reads: Vec<&'a [u32]>,
    /// The marks of the buffers of floats.
    marks: Vec<&'a [bool]>,
    uniforms: Vec<Aligned>,
    busy: AtomicBool,
    /// Time of the pass on all threads together, in nanoseconds.
    nanoseconds: AtomicU64,
}

impl<'a> PreparedPass<'a> {
    /// The pass that writes the buffer `written`; `contents` gives the words of a buffer that it reads, `same` the marks of its blocks.
    pub(super) fn new(
        pass: &'a Pass,
        written: &Buffer,
        contents: impl Fn(&Buffer) -> Option<&'a [u32]>,
        same: impl Fn(&Buffer) -> &'a [bool],
    ) -> Self {
        let read = pass.buffers.iter().filter(|buffer| *buffer != written);
        let bound = pass.buffers.iter().zip(pass.kernel.declaration.buffers());
        let floats = bound.filter(|(_, binding)| (binding.access, binding.element) == (Access::Read, Element::F32));
        Self {
            pass,
            reads: read.filter_map(contents).collect(),
            marks: floats.map(|(buffer, _)| same(buffer)).collect(),
            // The kernels' uniform blocks are aligned to 16 bytes.
            uniforms: pass.uniforms.chunks(16).map(Aligned::from_bytes).collect(),
            busy: AtomicBool::new(false),
            nanoseconds: AtomicU64::new(0),
        }
    }

    /// Time of the pass on all threads together, in nanoseconds.
    pub(super) fn nanoseconds(&self) -> f64 {
        self.nanoseconds.load(Ordering::Relaxed) as f64
    }

    /// Whether any invocation had work to do.
    pub(super) fn was_busy(self) -> bool {
        self.busy.into_inner()
    }
}

/// Whether `next` only changes, record by record, what `pass` wrote: then a part of the records can go through both before the
/// next part does, while it is in a processor's cache.
pub(super) fn follows(pass: &Pass, next: &Pass) -> bool {
    let updates = next.kernel.declaration.bindings.iter().any(|binding| binding.access == Access::Update);
    let alike = (next.width, next.height, next.window) == (pass.width, pass.height, pass.window);
    updates && alike && (next.output(), next.start) == (pass.output(), pass.start)
}

/// Passes that run together at most.
pub(super) fn most_together(pass: &Pass) -> usize {
    (INVOCATIONS_TOGETHER / pass.invocations().max(1)).max(1) as usize
}

/// Rows in a chunk of passes that run together.
fn chunk_rows(passes: &[PreparedPass]) -> u32 {
    let pass = passes[0].pass;
    let row = pass.width as usize * pass.kernel.declaration.components * 4;
    if passes.len() > 1 {
        (CACHED_BYTES / row.max(1)).clamp(1, CHUNK_ROWS as usize) as u32
    } else if pass.adds() {
        (CHUNK_INVOCATIONS / pass.width.max(1)).clamp(1, CHUNK_ROWS)
    } else {
        CHUNK_ROWS
    }
}

/// Runs passes over all their rows, chunk by chunk; once the caller has cancelled the rest is left out.
pub(super) fn rows(
    passes: &[PreparedPass],
    set: InstructionSet,
    output: &mut [u32],
    state: &mut BlockState,
    asked: &Asked<'_>,
) {
    let pass = passes[0].pass;
    let (width, height) = (pass.width, pass.height);
    let count = width as usize * height as usize;
    let Window { first, end } = pass.window;
    if first[0] >= end[0] || first[1] >= end[1] {
        return;
    }
    let chunk_rows = chunk_rows(passes);
    let chunk_len = width as usize * chunk_rows as usize;
    let adds = pass.adds();
    let output = &mut output[pass.start as usize..];
    let (sums, output): (&[AtomicU32], &mut [u32]) = if adds { (shared(output), &mut []) } else { (&[], output) };
    let components = if adds { 0 } else { pass.kernel.declaration.components };
    // Those in which the window has rows.
    let first_chunk = (first[1] / chunk_rows) as usize;
    let number = end[1].div_ceil(chunk_rows) as usize - first_chunk;
    // Chunk by chunk, each component's part.
    let mut chunks: Vec<Vec<&mut [f32]>> = (0..number).map(|_| Vec::with_capacity(components)).collect();
    for plane in bytemuck::cast_slice_mut::<u32, f32>(output)[..count * components].chunks_mut(count) {
        for (chunk, part) in chunks.iter_mut().zip(plane.chunks_mut(chunk_len).skip(first_chunk)) {
            chunk.push(part);
        }
    }
    let blocks = width.div_ceil(LANES as u32) as usize;
    let all = blocks * height as usize;
    if state.size != (width, height) {
        *state = BlockState { size: (width, height), ..BlockState::default() };
    }
    state.rests.resize(all, 0);
    // Whoever else writes the records does not keep the marks.
    let keeps = passes.iter().all(|pass| pass.pass.kernel.declaration.skip == Skip::Same);
    let marked = if keeps { all } else { 0 };
    state.same.resize(marked, false);
    state.free_to.resize(marked, f32::NEG_INFINITY);
    let before = state.kernel;
    state.kernel = passes.last().map(|pass| pass.pass.kernel.declaration.name);
    let part = blocks * chunk_rows as usize;
    let rests = parts(&mut state.rests, part, first_chunk, number);
    let same = parts(&mut state.same, part, first_chunk, number);
    let free_to = parts(&mut state.free_to, part, first_chunk, number);
    chunks.par_iter_mut().zip(rests).zip(same).zip(free_to).enumerate().for_each(|(index, chunk)| {
        let (((output, rests), same), free_to) = chunk;
        let first_row = (first_chunk + index) as u32 * chunk_rows;
        let mut before = before;
        for PreparedPass { pass, reads, marks, uniforms, busy, nanoseconds } in passes {
            if asked.is_cancelled() {
                return;
            }
            let started = Instant::now();
            // How long records rest is only known while nothing else changes them.
            if before != Some(pass.kernel.declaration.name) {
                rests.fill(0);
                before = Some(pass.kernel.declaration.name);
            }
            let uniforms = &bytemuck::cast_slice(uniforms)[..pass.uniforms.len()];
            let rows = chunk_rows.min(height - first_row);
            let mut output: Vec<&mut [f32]> = output.iter_mut().map(|component| &mut **component).collect();
            let output = output.as_mut_slice();
            let marks = Marks { own: &mut *same, free_to: &mut *free_to, reads: marks, height };
            let inside = first[1].saturating_sub(first_row)..rows.min(end[1] - first_row);
            let columns = first[0]..end[0];
            let rests = &mut *rests;
            let chunk =
                &mut Chunk { first_row, rows, width, inside, columns, uniforms, reads, output, sums, rests, marks };
            if (pass.kernel.run)(set, chunk) {
                busy.store(true, Ordering::Relaxed);
            }
            nanoseconds.fetch_add(started.elapsed().as_nanos() as u64, Ordering::Relaxed);
        }
    });
}

/// Parts of `length` each, `count` in all, from number `first` on: empty ones of nothing.
fn parts<T: Send>(all: &mut [T], length: usize, first: usize, count: usize) -> rayon::vec::IntoIter<&mut [T]> {
    let mut parts: Vec<&mut [T]> = all.chunks_mut(length).skip(first).take(count).collect();
    parts.resize_with(count, Default::default);
    parts.into_par_iter()
}

/// Words that threads add to.
fn shared(words: &mut [u32]) -> &[AtomicU32] {
    // SAFETY: an atomic word has the size, the alignment (4 on every target that has one) and the bits of a word, and for as long
    // as the result lives the exclusive borrow leaves no other way to the words.
    unsafe { &*(std::ptr::from_mut(words) as *const [AtomicU32]) }
}

/// Sixteen aligned bytes.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C, align(16))]
struct Aligned([u8; 16]);

impl Aligned {
    fn from_bytes(bytes: &[u8]) -> Self {
        let mut aligned = Self([0; 16]);
        aligned.0[..bytes.len()].copy_from_slice(bytes);
        aligned
    }
}

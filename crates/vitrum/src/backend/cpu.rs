//! The CPU backend: the kernels' own functions over rows, in parallel.

use super::times::{self, KernelTime};
use super::{Backend, BackendError, Buffer, Pass, PassList, Write};
use rayon::prelude::*;
use std::collections::HashMap;
use std::ops::Deref;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};
use std::time::Instant;
use vitrum_io::Words;
use vitrum_kernels::kernel::{Access, Chunk, InstructionSet, LANES};

/// Rows in a chunk of work: small enough to balance, large enough that handing it out costs nothing.
const CHUNK_ROWS: u32 = 8;

/// Bytes of records that go through several passes before the next ones do: half of a processor's second-level cache.
const CACHED_BYTES: usize = 1 << 19;

/// Invocations of passes that run together, not many more than a second's work.
const INVOCATIONS_TOGETHER: u64 = 1 << 27;

/// Passes between two calls of the progress function.
const PASSES_PER_REPORT: usize = 24;

/// Runs kernels natively, compiled per instruction set.
pub struct CpuBackend {
    pool: rayon::ThreadPool,
    set: InstructionSet,
    buffers: Vec<Option<Contents>>,
    times: Vec<KernelTime>,
    volume_limit: Option<u64>,
}

impl CpuBackend {
    /// A backend with `threads` worker threads (all processors if `None`) and the machine's best instruction set.
    pub fn new(threads: Option<usize>) -> Result<Self, BackendError> {
        Self::with_instruction_set(threads, InstructionSet::best())
    }

    /// A backend that uses `set`, which must be available on this machine (else the best one is used).
    pub fn with_instruction_set(threads: Option<usize>, set: InstructionSet) -> Result<Self, BackendError> {
        let threads = threads.unwrap_or(0);
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .thread_name(|index| format!("vitrum-{index}"))
            .build()
            .map_err(|error| BackendError::Threads { threads, reason: error.to_string() })?;
        let set = if set.is_available() { set } else { InstructionSet::best() };
        Ok(Self { pool, set, buffers: Vec::new(), times: Vec::new(), volume_limit: None })
    }

    fn add(&mut self, contents: Contents) -> Buffer {
        let free = self.buffers.iter().position(Option::is_none);
        let index = free.unwrap_or_else(|| {
            self.buffers.push(None);
            self.buffers.len() - 1
        });
        self.buffers[index] = Some(contents);
        Buffer(index)
    }

    /// Runs passes that [`follows`] puts together; for each, whether any invocation had work to do.
    fn run_together(
        &mut self,
        passes: &[&Pass],
        resting: &mut HashMap<Buffer, Resting>,
    ) -> Result<Vec<bool>, BackendError> {
        for pass in passes {
            pass.check(|buffer| self.buffers[buffer.0].as_ref().map(|words| words.len() as u64 * 4))?;
        }
        let Some(written) = passes[0].output() else {
            return Ok(vec![false; passes.len()]);
        };
        // Taken out for the time of the passes, so that the others can be borrowed beside it.
        let mut output = self.buffers[written.0].take().map_or(Vec::new(), Contents::into_own);
        let prepared: Vec<Prepared> = passes.iter().map(|pass| self.prepare(pass, written)).collect();
        let started = Instant::now();
        self.pool.install(|| rows(&prepared, self.set, &mut output, resting.entry(written).or_default()));
        // Shared out by what the threads took for each.
        let elapsed = started.elapsed().as_secs_f64() * 1e3;
        let nanoseconds = prepared.iter().map(|pass| pass.nanoseconds.load(Ordering::Relaxed) as f64);
        let shares: Vec<f64> = nanoseconds.collect();
        let whole: f64 = shares.iter().sum();
        let busy = prepared.into_iter().map(|pass| pass.busy.into_inner()).collect();
        for (pass, share) in passes.iter().zip(shares) {
            times::add(&mut self.times, pass.kernel.declaration.name, elapsed * share / whole.max(1.0));
        }
        self.buffers[written.0] = Some(Contents::Own(output));
        Ok(busy)
    }

    /// Writes what comes before a pass.
    fn write(&mut self, writes: Vec<&Write>) -> Result<(), BackendError> {
        for write in writes {
            write.check(|buffer| self.buffers[buffer.0].as_ref().map(|words| words.len() as u64 * 4))?;
            let words = self.buffers[write.buffer.0].take().map_or(Vec::new(), Contents::into_own);
            let words = self.buffers[write.buffer.0].insert(Contents::Own(words));
            let Contents::Own(words) = words else { continue };
            let part = &mut words[write.start as usize..][..write.words];
            self.pool.install(|| (write.fill)(part));
        }
        Ok(())
    }

    fn prepare<'a>(&'a self, pass: &'a Pass, written: Buffer) -> Prepared<'a> {
        let read = pass.buffers.iter().filter(|buffer| **buffer != written);
        Prepared {
            pass,
            reads: read.filter_map(|buffer| self.buffers[buffer.0].as_deref()).collect(),
            // The kernels' uniform blocks are aligned to 16 bytes.
            uniforms: pass.uniforms.chunks(16).map(Aligned::from_bytes).collect(),
            busy: AtomicBool::new(false),
            nanoseconds: AtomicU64::new(0),
        }
    }
}

/// What a buffer holds.
enum Contents {
    Own(Vec<u32>),
    /// Memory of somebody else, too.
    Shared(Words),
}

impl Contents {
    /// The words, to be changed.
    fn into_own(self) -> Vec<u32> {
        match self {
            Self::Own(words) => words,
            Self::Shared(words) => words.to_vec(),
        }
    }
}

impl Deref for Contents {
    type Target = [u32];

    fn deref(&self) -> &[u32] {
        match self {
            Self::Own(words) => words,
            Self::Shared(words) => words,
        }
    }
}

/// How long blocks of a buffer's records rest, and from which kernel: see [`Chunk::rests`].
#[derive(Default)]
struct Resting {
    kernel: Option<&'static str>,
    blocks: Vec<u32>,
}

/// A pass, and what its chunks share.
struct Prepared<'a> {
    pass: &'a Pass,
    reads: Vec<&'a [u32]>,
    uniforms: Vec<Aligned>,
    busy: AtomicBool,
    /// What all threads took for it.
    nanoseconds: AtomicU64,
}

/// Whether `next` only changes, record by record, what `pass` wrote: then a part of the records can go through both before the
/// next part does, while it is in a processor's cache.
fn follows(pass: &Pass, next: &Pass) -> bool {
    let updates = next.kernel.declaration.bindings.iter().any(|binding| binding.access == Access::Update);
    updates && next.output() == pass.output() && (next.width, next.height) == (pass.width, pass.height)
}

/// Passes that run together at most: they cannot be cancelled on the way.
fn most_together(pass: &Pass) -> usize {
    let invocations = u64::from(pass.width) * u64::from(pass.height);
    (INVOCATIONS_TOGETHER / invocations.max(1)).max(1) as usize
}

/// Rows in a chunk of passes that run together.
fn chunk_rows(passes: &[Prepared]) -> u32 {
    let pass = passes[0].pass;
    let row = pass.width as usize * pass.kernel.declaration.components * 4;
    if passes.len() > 1 { (CACHED_BYTES / row.max(1)).clamp(1, CHUNK_ROWS as usize) as u32 } else { CHUNK_ROWS }
}

/// Runs passes over all their rows, chunk by chunk.
fn rows(passes: &[Prepared], set: InstructionSet, output: &mut [u32], resting: &mut Resting) {
    let pass = passes[0].pass;
    let (width, height) = (pass.width, pass.height);
    let count = width as usize * height as usize;
    if count == 0 {
        return;
    }
    let chunk_rows = chunk_rows(passes);
    let chunk_len = width as usize * chunk_rows as usize;
    let adds = pass.kernel.declaration.bindings.iter().any(|binding| binding.access == Access::Add);
    let (sums, output): (&[AtomicU32], &mut [u32]) = if adds { (shared(output), &mut []) } else { (&[], output) };
    let components = if adds { 0 } else { pass.kernel.declaration.components };
    // Chunk by chunk, each component's part.
    let mut chunks: Vec<Vec<&mut [f32]>> =
        (0..count.div_ceil(chunk_len)).map(|_| Vec::with_capacity(components)).collect();
    for plane in bytemuck::cast_slice_mut::<u32, f32>(output)[..count * components].chunks_mut(count) {
        for (chunk, part) in chunks.iter_mut().zip(plane.chunks_mut(chunk_len)) {
            chunk.push(part);
        }
    }
    let blocks = width.div_ceil(LANES as u32) as usize;
    resting.blocks.resize(blocks * height as usize, 0);
    let before = resting.kernel;
    resting.kernel = passes.last().map(|pass| pass.pass.kernel.declaration.name);
    let rests = resting.blocks.par_chunks_mut(blocks * chunk_rows as usize);
    chunks.par_iter_mut().zip(rests).enumerate().for_each(|(index, (output, rests))| {
        let first_row = index as u32 * chunk_rows;
        let mut before = before;
        for Prepared { pass, reads, uniforms, busy, nanoseconds } in passes {
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
            let chunk = &mut Chunk { first_row, rows, width, uniforms, reads, output, sums, rests: &mut *rests };
            if (pass.kernel.run)(set, chunk) {
                busy.store(true, Ordering::Relaxed);
            }
            nanoseconds.fetch_add(started.elapsed().as_nanos() as u64, Ordering::Relaxed);
        }
    });
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

impl Backend for CpuBackend {
    fn name(&self) -> &'static str {
        "cpu"
    }

    fn adapter(&self) -> String {
        format!("{} threads, {:?}", self.pool.current_num_threads(), self.set)
    }

    fn largest_buffer(&self) -> u64 {
        // Kernels index words by a signed 32-bit number.
        (i32::MAX as u64) * 4
    }

    fn volume_limit(&self) -> u64 {
        self.volume_limit.unwrap_or(u64::MAX).min(self.largest_buffer())
    }

    fn set_volume_limit(&mut self, bytes: Option<u64>) {
        self.volume_limit = bytes;
    }

    fn create(&mut self, label: &str, contents: &[u8]) -> Result<Buffer, BackendError> {
        self.check_size(label, contents.len() as u64)?;
        Ok(self.add(Contents::Own(bytemuck::pod_collect_to_vec(contents))))
    }

    fn create_with(
        &mut self,
        label: &str,
        bytes: u64,
        fill: &mut dyn FnMut(&mut [u32]),
    ) -> Result<Buffer, BackendError> {
        let mut words = self.zeros(label, bytes)?;
        fill(&mut words);
        Ok(self.add(Contents::Own(words)))
    }

    fn share(&mut self, label: &str, words: &Words) -> Result<Buffer, BackendError> {
        self.check_size(label, size_of_val(&**words) as u64)?;
        Ok(self.add(Contents::Shared(words.clone())))
    }

    fn create_zeroed(&mut self, label: &str, bytes: u64) -> Result<Buffer, BackendError> {
        let words = self.zeros(label, bytes)?;
        Ok(self.add(Contents::Own(words)))
    }

    fn run(&mut self, passes: &PassList, progress: &mut dyn FnMut(usize) -> bool) -> Result<(), BackendError> {
        let mut idle = false;
        let mut resting = HashMap::new();
        let (mut done, mut reported) = (0, None);
        // Written as soon as a pass that runs reads it.
        let mut waiting: Vec<&Write> = Vec::new();
        let parts = passes.runs().flat_map(|(writes, run)| {
            let parts = run.chunk_by(follows).flat_map(|together| together.chunks(most_together(&together[0])));
            parts.enumerate().map(move |(index, part)| (if index == 0 { writes } else { &[] }, part))
        });
        for (writes, together) in parts {
            waiting.extend(writes);
            if reported.is_none_or(|reported| done >= reported + PASSES_PER_REPORT) {
                reported = Some(done);
                if !progress(done) {
                    return Err(BackendError::Cancelled);
                }
            }
            done += together.len();
            let needed = |pass: &&Pass| !(idle && passes.while_busy.contains(&pass.kernel.declaration.name));
            let together: Vec<&Pass> = together.iter().filter(needed).collect();
            if together.is_empty() {
                continue;
            }
            let reads = |write: &Write| together.iter().any(|pass| pass.buffers.contains(&write.buffer));
            let (now, later) = waiting.into_iter().partition(|write| reads(write));
            waiting = later;
            self.write(now)?;
            let busy = self.run_together(&together, &mut resting)?;
            let ends = |pass: &Pass| passes.ends_with == Some(pass.kernel.declaration.name);
            idle |= together.iter().zip(busy).any(|(pass, busy)| !busy && ends(pass));
        }
        // For passes of another list; none are left where nothing goes on.
        if !idle {
            self.write(waiting)?;
        }
        progress(done);
        Ok(())
    }

    fn read(&mut self, buffer: Buffer) -> Result<Vec<u8>, BackendError> {
        Ok(self.buffers[buffer.0].as_deref().map(|words| bytemuck::cast_slice(words).to_vec()).unwrap_or_default())
    }

    fn free(&mut self, buffer: Buffer) {
        self.buffers[buffer.0] = None;
    }

    fn take_kernel_times(&mut self) -> Vec<KernelTime> {
        std::mem::take(&mut self.times)
    }

    fn device_bytes(&self) -> Option<u64> {
        None
    }
}

impl CpuBackend {
    fn zeros(&self, label: &str, bytes: u64) -> Result<Vec<u32>, BackendError> {
        self.check_size(label, bytes)?;
        let count = usize::try_from(bytes / 4).unwrap_or(usize::MAX);
        let mut words = Vec::new();
        words.try_reserve_exact(count).map_err(|_| BackendError::OutOfMemory {
            adapter: self.adapter(),
            what: format!("{label}, {bytes} bytes"),
        })?;
        words.resize(count, 0);
        Ok(words)
    }

    fn check_size(&self, label: &str, bytes: u64) -> Result<(), BackendError> {
        debug_assert!(bytes > 0 && bytes.is_multiple_of(4), "{label} has {bytes} bytes");
        if bytes > self.largest_buffer() {
            return Err(BackendError::TooLarge {
                label: label.to_owned(),
                needed: bytes,
                limit: self.largest_buffer(),
                adapter: "the CPU backend".to_owned(),
            });
        }
        Ok(())
    }
}

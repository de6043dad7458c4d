//! The CPU backend: the kernels' own functions over rows, in parallel.

mod chunks;
mod contents;
mod course;

use super::pass::check_part;
use super::times::{self, KernelTime};
use super::{Backend, BackendError, Buffer, Pass, PassList, Write};
use chunks::{Known, Prepared, Written, rows};
use contents::Contents;
use course::{Course, Part, parts};
use rayon::prelude::*;
use std::collections::HashMap;
use std::time::Instant;
use vitrum_io::Words;
use vitrum_kernels::kernel::InstructionSet;

/// Passes between two calls of the progress function.
const PASSES_PER_REPORT: usize = 24;

/// Words that a thread clears at a time.
const CLEARED_TOGETHER: usize = 1 << 16;

/// Runs kernels natively, compiled per instruction set.
pub struct CpuBackend {
    pool: rayon::ThreadPool,
    set: InstructionSet,
    memory: Memory,
    volume_limit: Option<u64>,
}

/// Buffers, and what was measured while passes changed them.
#[derive(Default)]
struct Memory {
    buffers: Vec<Option<Contents>>,
    times: Vec<KernelTime>,
}

impl CpuBackend {
    /// A backend with `threads` worker threads (all processors if `None`) and the machine's best instruction set.
    ///
    /// # Errors
    /// [`BackendError::Threads`] where the threads cannot be started.
    pub fn new(threads: Option<usize>) -> Result<Self, BackendError> {
        Self::with_instruction_set(threads, InstructionSet::best())
    }

    /// A backend that uses `set`, which must be available on this machine (else the best one is used).
    ///
    /// # Errors
    /// [`BackendError::Threads`] where the threads cannot be started.
    pub fn with_instruction_set(threads: Option<usize>, set: InstructionSet) -> Result<Self, BackendError> {
        let threads = threads.unwrap_or(0);
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .thread_name(|index| format!("vitrum-{index}"))
            .build()
            .map_err(|error| BackendError::Threads { threads, reason: error.to_string() })?;
        let set = if set.is_available() { set } else { InstructionSet::best() };
        Ok(Self { pool, set, memory: Memory::default(), volume_limit: None })
    }
}

impl Memory {
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
        set: InstructionSet,
        known: &mut HashMap<Written, Known>,
    ) -> Result<Vec<bool>, BackendError> {
        for pass in passes {
            pass.check(|buffer| self.buffers[buffer.0].as_ref().map(|words| words.len() as u64 * 4))?;
        }
        let Some(written) = passes[0].output() else {
            return Ok(vec![false; passes.len()]);
        };
        // Taken out for the time of the passes, so that the others can be borrowed beside it.
        let start = passes[0].start;
        let mut written_known = known.remove(&(written, start)).unwrap_or_default();
        let mut output = self.buffers[written.0].take().map_or(Vec::new(), Contents::into_own);
        let prepared: Vec<Prepared> = passes
            .iter()
            .map(|pass| {
                let same = |buffer| known.get(&(buffer, 0)).map_or(&[][..], |known| known.same(pass));
                Prepared::new(pass, written, |buffer| self.buffers[buffer.0].as_deref(), same)
            })
            .collect();
        let started = Instant::now();
        rows(&prepared, set, &mut output, &mut written_known);
        // Shared out by what the threads took for each.
        let elapsed = started.elapsed().as_secs_f64() * 1e3;
        let shares: Vec<f64> = prepared.iter().map(Prepared::nanoseconds).collect();
        let whole: f64 = shares.iter().sum();
        let busy = prepared.into_iter().map(Prepared::was_busy).collect();
        for (pass, share) in passes.iter().zip(shares) {
            times::add(&mut self.times, pass.kernel.declaration.name, 1, elapsed * share / whole.max(1.0));
        }
        self.buffers[written.0] = Some(Contents::Own(output));
        known.insert((written, start), written_known);
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
            (write.fill)(part);
        }
        Ok(())
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
        self.volume_limit.unwrap_or(u64::MAX)
    }

    fn set_volume_limit(&mut self, bytes: Option<u64>) {
        self.volume_limit = bytes;
    }

    fn create(&mut self, label: &str, contents: &[u8]) -> Result<Buffer, BackendError> {
        self.check_size(label, contents.len() as u64)?;
        Ok(self.memory.add(Contents::Own(bytemuck::pod_collect_to_vec(contents))))
    }

    fn create_with(
        &mut self,
        label: &str,
        bytes: u64,
        fill: &mut dyn FnMut(&mut [u32]),
    ) -> Result<Buffer, BackendError> {
        let mut words = self.zeros(label, bytes)?;
        fill(&mut words);
        Ok(self.memory.add(Contents::Own(words)))
    }

    fn share(&mut self, label: &str, words: &Words) -> Result<Buffer, BackendError> {
        self.check_size(label, size_of_val(&**words) as u64)?;
        Ok(self.memory.add(Contents::Shared(words.clone())))
    }

    fn create_zeroed(&mut self, label: &str, bytes: u64) -> Result<Buffer, BackendError> {
        let words = self.zeros(label, bytes)?;
        Ok(self.memory.add(Contents::Own(words)))
    }

    fn overwrite(
        &mut self,
        buffer: Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError> {
        let contents = self.memory.buffers[buffer.0].take().map_or(Vec::new(), Contents::into_own);
        let Contents::Own(contents) = self.memory.buffers[buffer.0].insert(Contents::Own(contents)) else {
            return Ok(());
        };
        check_part(0, words as u64 * 4, Some(contents.len() as u64 * 4))?;
        let part = &mut contents[..words];
        self.pool.install(|| fill(part));
        Ok(())
    }

    fn clear(&mut self, buffer: Buffer) -> Result<(), BackendError> {
        let all = self.words(buffer)?.len();
        self.overwrite(buffer, all, &mut |words| {
            words.par_chunks_mut(CLEARED_TOGETHER).for_each(|words| words.fill(0));
        })
    }

    fn run(&mut self, passes: &PassList, progress: &mut dyn FnMut(usize) -> bool) -> Result<(), BackendError> {
        let mut course = Course::new(passes, self.set);
        let parts: Vec<Part> = parts(passes).collect();
        let (pool, memory) = (&self.pool, &mut self.memory);
        let (mut done, mut next) = (0, 0);
        while next < parts.len() {
            if !progress(done) {
                return Err(BackendError::Cancelled);
            }
            let reported = done;
            let first = next;
            while next < parts.len() && done < reported + PASSES_PER_REPORT {
                done += parts[next].1.len();
                next += 1;
            }
            // Handing work to the pool from outside takes as long as a small pass, so that it gets many at once.
            pool.install(|| parts[first..next].iter().try_for_each(|part| course.run(part, memory)))?;
        }
        pool.install(|| course.end(memory))?;
        progress(done);
        Ok(())
    }

    fn leaves_out_idle_passes(&self) -> bool {
        true
    }

    fn read(&mut self, buffer: Buffer) -> Result<Vec<u8>, BackendError> {
        Ok(bytemuck::cast_slice(self.words(buffer)?).to_vec())
    }

    fn read_part(&mut self, buffer: Buffer, start: u64, bytes: u64) -> Result<Vec<u8>, BackendError> {
        Ok(self.part(buffer, start, bytes)?.to_vec())
    }

    fn look(
        &mut self,
        buffer: Buffer,
        start: u64,
        bytes: u64,
        see: &mut (dyn FnMut(&[u8]) + Send),
    ) -> Result<(), BackendError> {
        let part = self.part(buffer, start, bytes)?;
        self.pool.install(|| see(part));
        Ok(())
    }

    fn take(&mut self, buffer: Buffer) -> Result<Vec<u32>, BackendError> {
        Ok(self.memory.buffers[buffer.0].take().map_or(Vec::new(), Contents::into_own))
    }

    fn free(&mut self, buffer: Buffer) {
        self.memory.buffers[buffer.0] = None;
    }

    fn take_kernel_times(&mut self) -> Vec<KernelTime> {
        std::mem::take(&mut self.memory.times)
    }

    fn device_bytes(&self) -> Option<u64> {
        None
    }
}

impl CpuBackend {
    fn words(&self, buffer: Buffer) -> Result<&[u32], BackendError> {
        let freed = || BackendError::Misuse { kernel: "-", what: format!("buffer {} is freed", buffer.0) };
        self.memory.buffers[buffer.0].as_deref().ok_or_else(freed)
    }

    /// `bytes` bytes of a buffer from byte `start` on.
    fn part(&self, buffer: Buffer, start: u64, bytes: u64) -> Result<&[u8], BackendError> {
        let contents: &[u8] = bytemuck::cast_slice(self.words(buffer)?);
        check_part(start, bytes, Some(contents.len() as u64))?;
        Ok(&contents[start as usize..][..bytes as usize])
    }

    fn zeros(&self, label: &str, bytes: u64) -> Result<Vec<u32>, BackendError> {
        self.check_size(label, bytes)?;
        let count = usize::try_from(bytes / 4).unwrap_or(usize::MAX);
        // Whether there is the memory, since the next line would end the program. It gets pages that the system has cleared.
        Vec::<u32>::new().try_reserve_exact(count).map_err(|_| BackendError::OutOfMemory {
            adapter: self.adapter(),
            what: format!("{label}, {bytes} bytes"),
        })?;
        Ok(vec![0; count])
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

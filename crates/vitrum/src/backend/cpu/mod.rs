//! The CPU backend: the kernels' own functions over rows, in parallel.

mod asked;
mod chunks;
mod contents;
mod executor;

use super::buffer::Buffers;
use super::pass::check_part;
use super::times::{self, KernelTime};
use super::{Backend, BackendError, Buffer, Pass, PassList, Threads, Write, buffer};
use asked::Asked;
use chunks::{BlockState, PreparedPass, Written, rows};
use contents::Contents;
use executor::{Executor, Part, parts};
use rayon::prelude::*;
use std::collections::HashMap;
use std::ops::Range;
use vitrum_kernels::kernel::InstructionSet;
use web_time::Instant;

/// Passes between two calls of the progress function.
const PASSES_PER_REPORT: usize = 24;

/// Words that a thread clears at a time.
const CLEARED_TOGETHER: usize = 1 << 16;

/// Runs kernels natively, compiled per instruction set.
pub struct CpuBackend {
    threads: Threads,
    set: InstructionSet,
    memory: Memory,
    volume_limit: Option<u64>,
}

/// Buffers, and what was measured while passes changed them.
#[derive(Default)]
struct Memory {
    buffers: Buffers<Contents>,
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
        let threads = Threads::start(threads)?;
        let set = if set.is_available() { set } else { InstructionSet::best() };
        Ok(Self { threads, set, memory: Memory::default(), volume_limit: None })
    }
}

impl Memory {
    /// Runs passes that [`follows`] puts together; for each, whether any invocation had work to do.
    fn run_together(
        &mut self,
        passes: &[&Pass],
        set: InstructionSet,
        states: &mut HashMap<Written, BlockState>,
        asked: &Asked<'_>,
    ) -> Result<Vec<bool>, BackendError> {
        for pass in passes {
            pass.check(|buffer| self.size(buffer))?;
        }
        let Some(written) = passes[0].output() else {
            return Ok(vec![false; passes.len()]);
        };
        // Taken out for the time of the passes, so that the others can be borrowed beside it.
        let start = passes[0].start;
        let mut written_state = states.remove(&(written.number(), start)).unwrap_or_default();
        let mut output = self.own(written)?;
        let prepared: Vec<PreparedPass> = passes
            .iter()
            .map(|pass| {
                let same =
                    |buffer: &Buffer| states.get(&(buffer.number(), 0)).map_or(&[][..], |state| state.same(pass));
                PreparedPass::new(pass, written, |buffer| self.buffers.find(buffer).map(|words| &**words), same)
            })
            .collect();
        let started = Instant::now();
        rows(&prepared, set, &mut output, &mut written_state, asked);
        // Shared out by what the threads took for each.
        let elapsed = started.elapsed().as_secs_f64() * 1e3;
        let shares: Vec<f64> = prepared.iter().map(PreparedPass::nanoseconds).collect();
        let whole: f64 = shares.iter().sum();
        let busy = prepared.into_iter().map(PreparedPass::was_busy).collect();
        for (pass, share) in passes.iter().zip(shares) {
            times::add(&mut self.times, pass.kernel.declaration.name, 1, elapsed * share / whole.max(1.0));
        }
        *self.buffers.slot(written)? = Some(Contents::Own(output));
        states.insert((written.number(), start), written_state);
        Ok(busy)
    }

    /// The size of a buffer, in bytes.
    fn size(&self, buffer: &Buffer) -> Option<u64> {
        self.buffers.find(buffer).map(|words| words.len() as u64 * 4)
    }

    /// Takes the words of a buffer out of it, to be changed; memory that is shared with somebody else is copied.
    fn own(&mut self, buffer: &Buffer) -> Result<Vec<u32>, BackendError> {
        Ok(self.buffers.slot(buffer)?.take().map_or(Vec::new(), Contents::into_own))
    }

    /// Has `change` change the words of a buffer.
    fn change<T>(&mut self, buffer: &Buffer, change: impl FnOnce(&mut [u32]) -> T) -> Result<T, BackendError> {
        let mut words = self.own(buffer)?;
        let result = change(&mut words);
        *self.buffers.slot(buffer)? = Some(Contents::Own(words));
        Ok(result)
    }

    /// Does the writes that come before a pass.
    fn write(&mut self, writes: Vec<&Write>) -> Result<(), BackendError> {
        for write in writes {
            write.check(|buffer| self.size(buffer))?;
            self.change(&write.buffer, |words| (write.fill)(&mut words[write.start as usize..][..write.words]))?;
        }
        Ok(())
    }
}

impl Backend for CpuBackend {
    fn name(&self) -> &'static str {
        "cpu"
    }

    fn adapter(&self) -> String {
        format!("{} threads, {:?}", self.threads.count(), self.set)
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

    fn threads(&self) -> Threads {
        self.threads.clone()
    }

    fn create(&mut self, label: &str, contents: buffer::Contents<'_>) -> Result<Buffer, BackendError> {
        // Before the memory is taken, not behind it: what was dropped makes room.
        self.memory.buffers.collect();
        let bytes = contents.bytes();
        self.check_size(label, bytes)?;
        let contents = match contents {
            buffer::Contents::Bytes(bytes) => Contents::Own(bytemuck::pod_collect_to_vec(bytes)),
            buffer::Contents::Shared(words) => Contents::Shared(words.clone()),
            buffer::Contents::Zeros(_) => Contents::Own(self.zeros(label, bytes)?),
            buffer::Contents::Written(_, fill) => {
                let mut words = self.zeros(label, bytes)?;
                self.threads.run(|| fill(&mut words));
                Contents::Own(words)
            }
        };
        Ok(self.memory.buffers.add(contents))
    }

    fn write(
        &mut self,
        buffer: &Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError> {
        check_part(0, words as u64 * 4, self.memory.size(buffer))?;
        let threads = &self.threads;
        self.memory.change(buffer, |contents| threads.run(|| fill(&mut contents[..words])))
    }

    fn clear(&mut self, buffer: &Buffer) -> Result<(), BackendError> {
        let all = self.bytes(buffer)? as usize / 4;
        self.write(buffer, all, &mut |words| {
            words.par_chunks_mut(CLEARED_TOGETHER).for_each(|words| words.fill(0));
        })
    }

    fn run(&mut self, passes: &PassList, progress: &mut (dyn FnMut(usize) -> bool + Send)) -> Result<(), BackendError> {
        self.memory.buffers.collect();
        let asked = Asked::new(progress);
        let mut executor = Executor::new(passes, self.set, &asked);
        let parts: Vec<Part> = parts(passes).collect();
        let (threads, memory) = (&self.threads, &mut self.memory);
        let (mut done, mut next) = (0, 0);
        while next < parts.len() {
            asked.report(done)?;
            let reported = done;
            let first = next;
            while next < parts.len() && done < reported + PASSES_PER_REPORT {
                done += parts[next].1.len();
                next += 1;
            }
            // Handing work to other threads takes as long as a small pass, so that it gets many at once.
            threads.run(|| parts[first..next].iter().try_for_each(|part| executor.run(part, memory)))?;
        }
        threads.run(|| executor.end(memory))?;
        // It is all done: cancelling comes too late.
        let _ = asked.report(done);
        Ok(())
    }

    fn read(
        &mut self,
        buffer: &Buffer,
        range: Range<u64>,
        see: &mut (dyn FnMut(&[u8]) + Send),
    ) -> Result<(), BackendError> {
        let contents: &[u8] = bytemuck::cast_slice(self.memory.buffers.get(buffer)?);
        check_part(range.start, range.end.saturating_sub(range.start), Some(contents.len() as u64))?;
        let part = &contents[range.start as usize..range.end as usize];
        self.threads.run(|| see(part));
        Ok(())
    }

    fn bytes(&self, buffer: &Buffer) -> Result<u64, BackendError> {
        Ok(self.memory.buffers.get(buffer)?.len() as u64 * 4)
    }

    fn take(&mut self, buffer: Buffer) -> Result<Vec<u32>, BackendError> {
        if buffer.is_last() { self.memory.own(&buffer) } else { Ok(self.memory.buffers.get(&buffer)?.to_vec()) }
    }

    fn take_kernel_times(&mut self) -> Vec<KernelTime> {
        std::mem::take(&mut self.memory.times)
    }

    fn device_bytes(&self) -> Option<u64> {
        None
    }
}

impl CpuBackend {
    /// Bytes of host memory that buffers take, and memory that they share with volumes.
    #[must_use]
    pub fn buffer_bytes(&self) -> u64 {
        self.memory.buffers.living().map(|words| words.len() as u64 * 4).sum()
    }

    fn zeros(&self, label: &str, bytes: u64) -> Result<Vec<u32>, BackendError> {
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

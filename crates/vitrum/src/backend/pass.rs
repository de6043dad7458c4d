//! Passes, and lists of them.

use super::{BackendError, Buffer};
use std::sync::Arc;
use vitrum_kernels::kernel::{Access, Kernel, LANES, Window};

/// Alignment of the offsets of records in a buffer, in words: no device asks for more.
pub const START_ALIGNMENT: u64 = 64;

/// One dispatch of a kernel over `width` × `height` invocations.
#[derive(Clone)]
pub struct Pass {
    /// The kernel.
    pub kernel: &'static Kernel,
    /// The uniform block's bytes.
    pub uniforms: Vec<u8>,
    /// A buffer for each of the kernel's [`Declaration::buffers`](vitrum_kernels::kernel::Declaration::buffers).
    pub buffers: Vec<Buffer>,
    /// Offset of the records in the written buffer, in words: a multiple of [`START_ALIGNMENT`].
    pub start: u64,
    /// Invocations across.
    pub width: u32,
    /// Invocations down.
    pub height: u32,
    /// The invocations that run, as the uniform block has them, too.
    pub window: Window,
}

/// Writes all words of a part of a buffer.
pub type Fill = dyn Fn(&mut [u32]) + Send + Sync;

/// A write of the host to a buffer between two passes.
#[derive(Clone)]
pub struct Write {
    /// Number of the pass before which the words are written.
    pub before: usize,
    /// The buffer.
    pub buffer: Buffer,
    /// Offset of the part, in words.
    pub start: u64,
    /// Number of words of the part.
    pub words: usize,
    /// Contents of the part.
    pub fill: Arc<Fill>,
}

/// A list of passes that run in order.
#[derive(Clone, Default)]
pub struct PassList {
    /// The passes.
    pub passes: Vec<Pass>,
    /// The writes between passes, in the order of the passes.
    pub writes: Vec<Write>,
    /// The passes that a backend may leave out.
    pub while_busy: Vec<WhileBusy>,
}

/// Passes that only matter while some invocation of a kernel has work to do: once a pass of it was idle, a backend may leave the rest of
/// them out, up to the next pass of a kernel that gives new work. The results are the same. No host is asked: the CPU knows the answer from the kernel's return value, and on a GPU a pass with work
/// raises the numbers of workgroups of the next ones, where the kernel reports work and all the passes have the same size.
#[derive(Clone)]
pub struct WhileBusy {
    /// The kernel whose idleness counts.
    pub kernel: &'static str,
    /// The kernels of the passes.
    pub passes: Vec<&'static str>,
    /// The kernel that gives new work: behind a pass of it the passes matter again.
    pub until: Option<&'static str>,
}

impl PassList {
    /// The part of the list from pass `first` to before pass `last`, with the writes before each of them; no pass of it may be left
    /// out.
    #[must_use]
    pub fn part(&self, first: usize, last: usize) -> Self {
        let writes = self.writes.iter().filter(|write| (first..last).contains(&write.before));
        Self {
            passes: self.passes[first..last].to_vec(),
            writes: writes.map(|write| Write { before: write.before - first, ..write.clone() }).collect(),
            ..Self::default()
        }
    }

    /// Runs of passes without a write between them, each with the writes before it.
    pub(super) fn runs(&self) -> impl Iterator<Item = (&[Write], &[Pass])> {
        let mut starts: Vec<usize> = self.writes.iter().map(|write| write.before).collect();
        starts.push(0);
        starts.sort_unstable();
        starts.dedup();
        let ends: Vec<usize> = starts[1..].iter().copied().chain([self.passes.len()]).collect();
        starts.into_iter().zip(ends).map(|(start, end)| {
            let first = self.writes.partition_point(|write| write.before < start);
            let last = self.writes.partition_point(|write| write.before <= start);
            (&self.writes[first..last], &self.passes[start..end])
        })
    }
}

/// Checks that `bytes` bytes from byte `start` on lie inside a buffer of `size` bytes, which is `None` if there is no such buffer.
pub(super) fn check_part(start: u64, bytes: u64, size: Option<u64>) -> Result<(), BackendError> {
    if start.checked_add(bytes).zip(size).is_some_and(|(end, size)| end <= size) {
        return Ok(());
    }
    let what = format!("{bytes} bytes from byte {start} on are not inside a buffer of {size:?} bytes");
    Err(BackendError::Misuse { kernel: "-", what })
}

impl Write {
    /// Checks that the part lies inside the buffer; `bytes` gives a buffer's size.
    pub(super) fn check(&self, bytes: impl Fn(&Buffer) -> Option<u64>) -> Result<(), BackendError> {
        check_part(self.start.saturating_mul(4), self.words as u64 * 4, bytes(&self.buffer))
    }
}

impl Pass {
    /// The number of invocations that run.
    #[must_use]
    pub fn invocations(&self) -> u64 {
        let Window { first, end } = self.window;
        u64::from(end[0] - first[0]) * u64::from(end[1] - first[1])
    }

    /// Whether its kernel adds to sums.
    pub(super) fn adds(&self) -> bool {
        self.kernel.declaration.bindings.iter().any(|binding| binding.access == Access::Add)
    }

    /// The buffer that the pass writes.
    pub fn output(&self) -> Option<&Buffer> {
        let writes = |access: Access| matches!(access, Access::Write | Access::Update | Access::Add);
        let written = self.kernel.declaration.buffers().iter().position(|binding| writes(binding.access))?;
        self.buffers.get(written)
    }

    /// Checks that buffers fit the declaration: their number, that none is bound twice where one use writes, and that the
    /// written one holds a record for each invocation. `bytes` gives a buffer's size.
    pub(super) fn check(&self, bytes: impl Fn(&Buffer) -> Option<u64>) -> Result<(), BackendError> {
        let declaration = &self.kernel.declaration;
        let wrong = |what: String| Err(BackendError::Misuse { kernel: declaration.name, what });
        if self.uniforms.len() != declaration.uniform_bytes {
            return wrong(format!(
                "{} bytes of uniforms where {} are declared",
                self.uniforms.len(),
                declaration.uniform_bytes
            ));
        }
        if self.buffers.len() != declaration.buffers().len() {
            return wrong(format!("{} buffers where {} are declared", self.buffers.len(), declaration.buffers().len()));
        }
        let Window { first, end } = self.window;
        let whole_blocks =
            first[0].is_multiple_of(LANES as u32) && (end[0].is_multiple_of(LANES as u32) || end[0] == self.width);
        if !whole_blocks || first[0] > end[0] || first[1] > end[1] || end[0] > self.width || end[1] > self.height {
            return wrong(format!("{:?} of {} × {} invocations", self.window, self.width, self.height));
        }
        if !self.start.is_multiple_of(START_ALIGNMENT) {
            return wrong(format!("records start at word {}, not at a multiple of {START_ALIGNMENT}", self.start));
        }
        for (buffer, binding) in self.buffers.iter().zip(declaration.buffers()) {
            let Some(size) = bytes(buffer) else {
                return wrong(format!("binding {} ({}) is a buffer of another backend", binding.binding, binding.name));
            };
            let records = u64::from(self.width) * u64::from(self.height) * declaration.components as u64 * 4;
            // Sums have a place for a texel, not for an invocation; adding beyond the end does nothing.
            let needed = self.start.saturating_mul(4) + if binding.access == Access::Add { 4 } else { records };
            if matches!(binding.access, Access::Write | Access::Update | Access::Add) {
                if size < needed {
                    return wrong(format!("binding {} holds {size} bytes where {needed} are written", binding.binding));
                }
                if self.buffers.iter().filter(|other| *other == buffer).count() > 1 {
                    return wrong(format!("binding {} is read and written", binding.binding));
                }
            }
        }
        Ok(())
    }
}

//! A backend that does something else than it should, to see whether a check says so, or that tells what it is asked to do.

use std::ops::Range;

use vitrum::backend::{Backend, BackendError, Buffer, Contents, CpuBackend, PassList};

use crate::Failure;

/// Changes passes before they run.
type ChangePasses = Box<dyn Fn(&mut PassList) + Send>;
/// Changes the bytes of a buffer as they are read.
type ChangeBytes = Box<dyn Fn(&mut [u8]) + Send>;

/// A backend, altered.
pub struct Altered<B> {
    backend: B,
    passes: ChangePasses,
    bytes: ChangeBytes,
}

/// The CPU, altered.
pub type AlteredCpu = Altered<CpuBackend>;

impl AlteredCpu {
    /// Runs passes as `change` leaves them.
    pub fn of_passes(change: impl Fn(&mut PassList) + Send + 'static) -> Result<Self, Failure> {
        Ok(Self { backend: CpuBackend::new(None)?, passes: Box::new(change), bytes: Box::new(|_| {}) })
    }

    /// A backend whose reads return the bytes that `change` makes of them.
    pub fn of_bytes(change: impl Fn(&mut [u8]) + Send + 'static) -> Result<Self, Failure> {
        Ok(Self::reading(CpuBackend::new(None)?, change))
    }
}

impl<B> Altered<B> {
    /// Gives what is read from `backend` as `change` leaves it.
    pub fn reading(backend: B, change: impl Fn(&mut [u8]) + Send + 'static) -> Self {
        Self { backend, passes: Box::new(|_| {}), bytes: Box::new(change) }
    }
}

impl<B: Backend> Backend for Altered<B> {
    fn name(&self) -> &'static str {
        self.backend.name()
    }

    fn adapter(&self) -> String {
        self.backend.adapter()
    }

    fn largest_buffer(&self) -> u64 {
        self.backend.largest_buffer()
    }

    fn create(&mut self, label: &str, contents: Contents<'_>) -> Result<Buffer, BackendError> {
        self.backend.create(label, contents)
    }

    fn write(
        &mut self,
        buffer: &Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError> {
        self.backend.write(buffer, words, fill)
    }

    fn clear(&mut self, buffer: &Buffer) -> Result<(), BackendError> {
        self.backend.clear(buffer)
    }

    fn run(&mut self, passes: &PassList, progress: &mut (dyn FnMut(usize) -> bool + Send)) -> Result<(), BackendError> {
        let mut passes = passes.clone();
        (self.passes)(&mut passes);
        self.backend.run(&passes, progress)
    }

    fn read(
        &mut self,
        buffer: &Buffer,
        range: Range<u64>,
        see: &mut (dyn FnMut(&[u8]) + Send),
    ) -> Result<(), BackendError> {
        let change = &self.bytes;
        let mut words = Vec::<u32>::new();
        self.backend.read(buffer, range, &mut |bytes| words = bytemuck::pod_collect_to_vec(bytes))?;
        let bytes = bytemuck::cast_slice_mut(&mut words);
        change(bytes);
        see(bytes);
        Ok(())
    }

    fn bytes(&self, buffer: &Buffer) -> Result<u64, BackendError> {
        self.backend.bytes(buffer)
    }

    fn device_bytes(&self) -> Option<u64> {
        self.backend.device_bytes()
    }
}

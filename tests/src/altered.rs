//! A CPU that does something else than it should, to see whether a check says so.

use std::ops::Range;

use vitrum::backend::{Backend, BackendError, Buffer, Contents, CpuBackend, PassList};

use crate::Failure;

/// Changes passes before they run.
type ChangePasses = Box<dyn Fn(&mut PassList) + Send>;
/// Changes the bytes of a buffer as they are read.
type ChangeBytes = Box<dyn Fn(&mut [u8]) + Send>;

/// The CPU, altered.
pub struct AlteredCpu {
    cpu: CpuBackend,
    passes: ChangePasses,
    bytes: ChangeBytes,
}

impl AlteredCpu {
    /// Runs passes as `change` leaves them.
    pub fn of_passes(change: impl Fn(&mut PassList) + Send + 'static) -> Result<Self, Failure> {
        Ok(Self { cpu: CpuBackend::new(None)?, passes: Box::new(change), bytes: Box::new(|_| {}) })
    }

    /// A backend whose reads return the bytes that `change` makes of them.
    pub fn of_bytes(change: impl Fn(&mut [u8]) + Send + 'static) -> Result<Self, Failure> {
        Ok(Self { cpu: CpuBackend::new(None)?, passes: Box::new(|_| {}), bytes: Box::new(change) })
    }
}

impl Backend for AlteredCpu {
    fn name(&self) -> &'static str {
        self.cpu.name()
    }

    fn adapter(&self) -> String {
        self.cpu.adapter()
    }

    fn largest_buffer(&self) -> u64 {
        self.cpu.largest_buffer()
    }

    fn create(&mut self, label: &str, contents: Contents<'_>) -> Result<Buffer, BackendError> {
        self.cpu.create(label, contents)
    }

    fn write(
        &mut self,
        buffer: &Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError> {
        self.cpu.write(buffer, words, fill)
    }

    fn clear(&mut self, buffer: &Buffer) -> Result<(), BackendError> {
        self.cpu.clear(buffer)
    }

    fn run(&mut self, passes: &PassList, progress: &mut dyn FnMut(usize) -> bool) -> Result<(), BackendError> {
        let mut passes = passes.clone();
        (self.passes)(&mut passes);
        self.cpu.run(&passes, progress)
    }

    fn leaves_out_idle_passes(&self) -> bool {
        self.cpu.leaves_out_idle_passes()
    }

    fn read(
        &mut self,
        buffer: &Buffer,
        range: Range<u64>,
        see: &mut (dyn FnMut(&[u8]) + Send),
    ) -> Result<(), BackendError> {
        let change = &self.bytes;
        let mut words = Vec::<u32>::new();
        self.cpu.read(buffer, range, &mut |bytes| words = bytemuck::pod_collect_to_vec(bytes))?;
        let bytes = bytemuck::cast_slice_mut(&mut words);
        change(bytes);
        see(bytes);
        Ok(())
    }

    fn bytes(&self, buffer: &Buffer) -> Result<u64, BackendError> {
        self.cpu.bytes(buffer)
    }

    fn device_bytes(&self) -> Option<u64> {
        self.cpu.device_bytes()
    }
}

//! A CPU that does something else than it should, to see whether a check says so.

use vitrum::backend::{Backend, BackendError, Buffer, CpuBackend, PassList};

use crate::Failure;

/// Passes before they run.
type ChangePasses = Box<dyn Fn(&mut PassList)>;
/// A buffer as it is read.
type ChangeBytes = Box<dyn Fn(&mut [u8])>;

/// The CPU, altered.
pub struct AlteredCpu {
    cpu: CpuBackend,
    passes: ChangePasses,
    bytes: ChangeBytes,
}

impl AlteredCpu {
    /// Runs passes as `change` leaves them.
    pub fn of_passes(change: impl Fn(&mut PassList) + 'static) -> Result<Self, Failure> {
        Ok(Self { cpu: CpuBackend::new(None)?, passes: Box::new(change), bytes: Box::new(|_| {}) })
    }

    /// Gives what is read as `change` leaves it.
    pub fn of_bytes(change: impl Fn(&mut [u8]) + 'static) -> Result<Self, Failure> {
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

    fn create(&mut self, label: &str, contents: &[u8]) -> Result<Buffer, BackendError> {
        self.cpu.create(label, contents)
    }

    fn create_zeroed(&mut self, label: &str, bytes: u64) -> Result<Buffer, BackendError> {
        self.cpu.create_zeroed(label, bytes)
    }

    fn overwrite(
        &mut self,
        buffer: Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError> {
        self.cpu.overwrite(buffer, words, fill)
    }

    fn clear(&mut self, buffer: Buffer) -> Result<(), BackendError> {
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

    fn read(&mut self, buffer: Buffer) -> Result<Vec<u8>, BackendError> {
        let mut bytes = self.cpu.read(buffer)?;
        (self.bytes)(&mut bytes);
        Ok(bytes)
    }

    fn read_part(&mut self, buffer: Buffer, start: u64, bytes: u64) -> Result<Vec<u8>, BackendError> {
        let mut bytes = self.cpu.read_part(buffer, start, bytes)?;
        (self.bytes)(&mut bytes);
        Ok(bytes)
    }

    fn free(&mut self, buffer: Buffer) {
        self.cpu.free(buffer);
    }

    fn device_bytes(&self) -> Option<u64> {
        self.cpu.device_bytes()
    }
}

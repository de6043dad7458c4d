//! Backends: where kernels run.
//!
//! A method is written once, against [`Backend`]: it makes buffers, lists passes, reads buffers. No method knows which backend
//! runs it.

mod choice;
mod cpu;
mod error;
mod gpu;
mod pass;
pub(crate) mod times;

pub use choice::{Choice, DeviceInfo, devices, open};
pub use cpu::CpuBackend;
pub use error::BackendError;
pub use gpu::GpuBackend;
pub use pass::{Buffer, Pass, PassList};
pub use times::KernelTime;

/// Runs passes over buffers.
pub trait Backend {
    /// `cpu` or `gpu`.
    fn name(&self) -> &'static str;

    /// The processor or graphics adapter, in its own words.
    fn adapter(&self) -> String;

    /// The most bytes one buffer may have.
    fn largest_buffer(&self) -> u64;

    /// A buffer with `contents` (not empty; whole words).
    fn create(&mut self, label: &str, contents: &[u8]) -> Result<Buffer, BackendError>;

    /// A buffer of `bytes` bytes (not 0; whole words) that `fill` writes, which gets zeros: where a backend can, without a copy.
    fn create_with(
        &mut self,
        label: &str,
        bytes: u64,
        fill: &mut dyn FnMut(&mut [u8]),
    ) -> Result<Buffer, BackendError> {
        let mut contents = vec![0; bytes as usize];
        fill(&mut contents);
        self.create(label, &contents)
    }

    /// A buffer of `bytes` zero bytes (not 0; whole words).
    fn create_zeroed(&mut self, label: &str, bytes: u64) -> Result<Buffer, BackendError>;

    /// Runs all passes in order. `progress` is told how many are done from time to time; when it returns `false` the run ends
    /// early with [`BackendError::Cancelled`].
    fn run(&mut self, passes: &PassList, progress: &mut dyn FnMut(usize) -> bool) -> Result<(), BackendError>;

    /// The contents of a buffer.
    fn read(&mut self, buffer: Buffer) -> Result<Vec<u8>, BackendError>;

    /// Frees a buffer.
    fn free(&mut self, buffer: Buffer);

    /// What each kernel took in the runs since the last call, in order of their first passes; empty where that is not known. Passes
    /// that wait for nothing but each other may run at once: then their time is shared out by the work they did.
    fn take_kernel_times(&mut self) -> Vec<KernelTime> {
        Vec::new()
    }

    /// Bytes of graphics memory that buffers take; `None` for the CPU.
    fn device_bytes(&self) -> Option<u64>;
}

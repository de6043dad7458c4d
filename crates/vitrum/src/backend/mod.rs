//! Backends: where kernels run.
//!
//! A method is written once, against [`Backend`]: it makes buffers, lists passes, reads buffers. No method knows which backend
//! runs it.

mod buffer;
mod choice;
mod cpu;
mod error;
#[cfg(feature = "gpu")]
mod gpu;
mod options;
mod pass;
mod threads;
pub(crate) mod times;

pub use buffer::{Buffer, Contents};
pub use choice::{Choice, DeviceInfo, devices, open};
pub use cpu::CpuBackend;
pub use error::BackendError;
#[cfg(feature = "gpu")]
pub use gpu::GpuBackend;
pub use options::GpuOptions;
pub use pass::{Fill, Pass, PassList, START_ALIGNMENT, WhileBusy, Write};
pub use threads::Threads;
pub use times::KernelTime;
/// For callers that own a device.
#[cfg(feature = "gpu")]
pub use wgpu;

use bytemuck::{AnyBitPattern, NoUninit};
use std::ops::Range;

/// Runs passes over buffers.
pub trait Backend: Send {
    /// `cpu` or `gpu`.
    fn name(&self) -> &'static str;

    /// The processor or graphics adapter, in its own words.
    fn adapter(&self) -> String;

    /// The most bytes one buffer may have.
    fn largest_buffer(&self) -> u64;

    /// The most bytes that the voxels of all of a frame's volumes should take at once; larger volumes are streamed.
    fn volume_limit(&self) -> u64 {
        u64::MAX
    }

    /// Sets [`Self::volume_limit`]; `None` leaves [`Self::largest_buffer`] for each volume as the only limit.
    fn set_volume_limit(&mut self, _bytes: Option<u64>) {}

    /// The threads on which the work of the host runs, such as the preparation of a frame.
    fn threads(&self) -> Threads {
        Threads::default()
    }

    /// Makes a buffer.
    ///
    /// # Errors
    /// [`BackendError::TooLarge`] beyond [`Self::largest_buffer`], [`BackendError::OutOfMemory`], [`BackendError::DeviceLost`].
    fn create(&mut self, label: &str, contents: Contents<'_>) -> Result<Buffer, BackendError>;

    /// Has `fill` write the first `words` words of a buffer, all of them, once what runs is done: where a backend can, without a copy.
    ///
    /// # Errors
    /// [`BackendError::Misuse`] for words beyond the buffer's end, [`BackendError::DeviceLost`].
    fn write(
        &mut self,
        buffer: &Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError>;

    /// Makes all words of a buffer 0, once what runs is done.
    ///
    /// # Errors
    /// [`BackendError::DeviceLost`].
    fn clear(&mut self, buffer: &Buffer) -> Result<(), BackendError>;

    /// Runs all passes in order. `progress` is told how many are done from time to time; when it returns `false` the run ends
    /// early with [`BackendError::Cancelled`].
    ///
    /// # Errors
    /// [`BackendError::Cancelled`]; [`BackendError::Misuse`] where a pass does not fit its kernel's declaration; the device's failures.
    fn run(&mut self, passes: &PassList, progress: &mut (dyn FnMut(usize) -> bool + Send)) -> Result<(), BackendError>;

    /// Shows `see` the bytes `range` of a buffer, whole words that lie inside it: where a backend can, without a copy and without the rest.
    ///
    /// # Errors
    /// [`BackendError::Misuse`] for a range beyond the buffer's end, [`BackendError::OutOfMemory`], [`BackendError::DeviceLost`].
    fn read(
        &mut self,
        buffer: &Buffer,
        range: Range<u64>,
        see: &mut (dyn FnMut(&[u8]) + Send),
    ) -> Result<(), BackendError>;

    /// The size of a buffer, in bytes.
    ///
    /// # Errors
    /// [`BackendError::Misuse`] for a buffer of another backend.
    fn bytes(&self, buffer: &Buffer) -> Result<u64, BackendError>;

    /// The contents of a buffer, as words: where a backend can, without a copy.
    ///
    /// # Errors
    /// As [`Self::read`].
    fn take(&mut self, buffer: Buffer) -> Result<Vec<u32>, BackendError> {
        self.read_all(&buffer)
    }

    /// The time of each kernel in the runs since the last call, in order of the kernels' first passes; empty if the device has no
    /// clock. Passes that wait for nothing but each other may run at once: their time is then divided by the work that they did.
    fn take_kernel_times(&mut self) -> Vec<KernelTime> {
        Vec::new()
    }

    /// Bytes of graphics memory that buffers take; `None` for the CPU.
    fn device_bytes(&self) -> Option<u64>;
}

/// Reads buffers as numbers of one type.
pub trait ReadBack: Backend {
    /// The contents of a buffer, as numbers of one type.
    ///
    /// # Errors
    /// As [`Backend::read`].
    fn read_all<T: AnyBitPattern + NoUninit + Send>(&mut self, buffer: &Buffer) -> Result<Vec<T>, BackendError> {
        let all = self.bytes(buffer)?;
        self.read_part(buffer, 0..all)
    }

    /// The bytes `range` of a buffer, as numbers of one type.
    ///
    /// # Errors
    /// As [`Backend::read`].
    fn read_part<T: AnyBitPattern + NoUninit + Send>(
        &mut self,
        buffer: &Buffer,
        range: Range<u64>,
    ) -> Result<Vec<T>, BackendError> {
        let mut numbers = Vec::new();
        self.read(buffer, range, &mut |bytes| numbers = bytemuck::pod_collect_to_vec(bytes))?;
        Ok(numbers)
    }
}

impl<B: Backend + ?Sized> ReadBack for B {}

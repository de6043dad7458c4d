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
pub use gpu::{GpuBackend, GpuOptions};
pub use pass::{Buffer, Fill, Pass, PassList, START_ALIGNMENT, WhileBusy, Write};
pub use times::KernelTime;
/// For callers that own a device.
pub use wgpu;

use vitrum_io::Words;

/// Runs passes over buffers.
pub trait Backend {
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

    /// Sets [`Self::volume_limit`]; with `None` there is none but [`Self::largest_buffer`] for each volume.
    fn set_volume_limit(&mut self, _bytes: Option<u64>) {}

    /// A buffer with `contents` (not empty; whole words).
    ///
    /// # Errors
    /// [`BackendError::TooLarge`] beyond [`Self::largest_buffer`], [`BackendError::OutOfMemory`], [`BackendError::DeviceLost`].
    fn create(&mut self, label: &str, contents: &[u8]) -> Result<Buffer, BackendError>;

    /// A buffer of `bytes` bytes (not 0; whole words) that `fill` writes, which gets zeros: where a backend can, without a copy.
    ///
    /// # Errors
    /// [`BackendError::TooLarge`] beyond [`Self::largest_buffer`], [`BackendError::OutOfMemory`], [`BackendError::DeviceLost`].
    fn create_with(
        &mut self,
        label: &str,
        bytes: u64,
        fill: &mut dyn FnMut(&mut [u32]),
    ) -> Result<Buffer, BackendError> {
        let mut contents = vec![0; bytes as usize / 4];
        fill(&mut contents);
        self.create(label, bytemuck::cast_slice(&contents))
    }

    /// A buffer with the contents of `words`, which nothing may write: where a backend can, the same memory.
    ///
    /// # Errors
    /// [`BackendError::TooLarge`] beyond [`Self::largest_buffer`], [`BackendError::OutOfMemory`], [`BackendError::DeviceLost`].
    fn share(&mut self, label: &str, words: &Words) -> Result<Buffer, BackendError> {
        self.create(label, bytemuck::cast_slice(words))
    }

    /// A buffer of `bytes` zero bytes (not 0; whole words).
    ///
    /// # Errors
    /// [`BackendError::TooLarge`] beyond [`Self::largest_buffer`], [`BackendError::OutOfMemory`], [`BackendError::DeviceLost`].
    fn create_zeroed(&mut self, label: &str, bytes: u64) -> Result<Buffer, BackendError>;

    /// Has `fill` write the first `words` words of a buffer, all of them, once what runs is done: where a backend can, without a copy.
    ///
    /// # Errors
    /// [`BackendError::Misuse`] for words beyond the buffer's end, [`BackendError::DeviceLost`].
    fn overwrite(
        &mut self,
        buffer: Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError>;

    /// Makes all words of a buffer 0 again, once what runs is done.
    ///
    /// # Errors
    /// [`BackendError::Misuse`] for a buffer that is freed, [`BackendError::DeviceLost`].
    fn clear(&mut self, buffer: Buffer) -> Result<(), BackendError>;

    /// Runs all passes in order. `progress` is told how many are done from time to time; when it returns `false` the run ends
    /// early with [`BackendError::Cancelled`].
    ///
    /// # Errors
    /// [`BackendError::Cancelled`]; [`BackendError::Misuse`] where a pass does not fit its kernel's declaration; what the device fails with.
    fn run(&mut self, passes: &PassList, progress: &mut dyn FnMut(usize) -> bool) -> Result<(), BackendError>;

    /// Whether [`Self::run`] leaves passes out as [`PassList::while_busy`] allows.
    fn leaves_out_idle_passes(&self) -> bool {
        false
    }

    /// The contents of a buffer.
    ///
    /// # Errors
    /// [`BackendError::Misuse`] for a buffer that is freed, [`BackendError::OutOfMemory`], [`BackendError::DeviceLost`].
    fn read(&mut self, buffer: Buffer) -> Result<Vec<u8>, BackendError>;

    /// `bytes` bytes of a buffer from byte `start` on, whole words that lie inside it: where a backend can, without reading the rest.
    ///
    /// # Errors
    /// As [`Self::read`], and [`BackendError::Misuse`] for what lies outside the buffer.
    fn read_part(&mut self, buffer: Buffer, start: u64, bytes: u64) -> Result<Vec<u8>, BackendError> {
        let all = self.read(buffer)?;
        pass::check_part(start, bytes, Some(all.len() as u64))?;
        Ok(all[start as usize..][..bytes as usize].to_vec())
    }

    /// Lets `see` look at what [`Self::read_part`] gives: where a backend can, without a copy.
    ///
    /// # Errors
    /// As [`Self::read_part`].
    fn look(
        &mut self,
        buffer: Buffer,
        start: u64,
        bytes: u64,
        see: &mut (dyn FnMut(&[u8]) + Send),
    ) -> Result<(), BackendError> {
        see(&self.read_part(buffer, start, bytes)?);
        Ok(())
    }

    /// The contents of a buffer in words, which is freed: where a backend can, without a copy.
    ///
    /// # Errors
    /// As [`Self::read`].
    fn take(&mut self, buffer: Buffer) -> Result<Vec<u32>, BackendError> {
        let bytes = self.read(buffer)?;
        self.free(buffer);
        Ok(bytemuck::pod_collect_to_vec(&bytes))
    }

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

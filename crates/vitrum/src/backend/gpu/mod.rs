//! The GPU backend: the kernels' SPIR-V through wgpu, on Vulkan, Metal or DX12, without a window.

mod adapter;
mod dispatches;
#[cfg_attr(target_arch = "wasm32", path = "module_in_browser.rs")]
mod module;
mod pipeline;
mod read;
mod run;
mod stopwatch;
mod workgroups;

pub(crate) use adapter::{adapters, describe, is_hardware, takes_spirv};

use super::buffer::Buffers;
use super::{Backend, BackendError, Buffer, Contents, GpuOptions, KernelTime, PassList, Threads, pass};
use adapter::Opened;
use pipeline::Pipeline;
use read::Reading;
use std::collections::HashMap;
use std::ops::Range;

/// Largest number of bytes on their way to the device at once, of which the driver keeps a copy in host memory.
const BYTES_PER_COPY: usize = 1 << 26;

/// Runs kernels on a graphics adapter.
pub struct GpuBackend {
    opened: Opened,
    adapter: String,
    limits: wgpu::Limits,
    pipelines: HashMap<&'static str, Pipeline>,
    buffers: Buffers<wgpu::Buffer>,
    times: Vec<KernelTime>,
    volume_limit: Option<u64>,
    threads: Threads,
}

impl GpuBackend {
    /// Opens the best adapter whose name, interface or driver contains `wanted`; software adapters come last.
    ///
    /// # Errors
    /// [`BackendError::NoAdapter`] where no adapter has that name, [`BackendError::Unsupported`] where its device cannot be opened.
    pub fn new(wanted: Option<&str>) -> Result<Self, BackendError> {
        Self::open(&GpuOptions::new(wanted))
    }

    /// Opens the adapter of `options`, with the settings in them.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn open(options: &GpuOptions) -> Result<Self, BackendError> {
        Self::among(adapters(), options)
    }

    /// As [`Self::open`], among adapters that were found already.
    pub(crate) fn among(found: Vec<wgpu::Adapter>, options: &GpuOptions) -> Result<Self, BackendError> {
        let adapter = adapter::choose(found, options.adapter.as_deref())?;
        Ok(Self::of(adapter::open(&adapter, options)?))
    }

    /// A backend on a device that the caller has opened, such as a window's, which the two share: kernels run in the order in which
    /// the caller and the backend submit. The caller hears of the device's failures by its own callbacks.
    ///
    /// [`Self::required`] says which features and limits the device should have; where it lacks them, shaders are translated, kernels
    /// are not timed, and buffers may be too large.
    #[must_use]
    pub fn with_device(device: wgpu::Device, queue: wgpu::Queue, info: &wgpu::AdapterInfo) -> Self {
        Self::of(adapter::adopt(device, queue, info))
    }

    /// The features and limits of a device for [`Self::with_device`]; a caller adds its own.
    #[must_use]
    pub fn required(adapter: &wgpu::Adapter) -> wgpu::DeviceDescriptor<'static> {
        adapter::required(adapter, &GpuOptions::default())
    }

    fn of(opened: Opened) -> Self {
        Self {
            adapter: opened.description.clone(),
            limits: opened.device.limits(),
            opened,
            pipelines: HashMap::new(),
            buffers: Buffers::default(),
            times: Vec::new(),
            volume_limit: None,
            threads: Threads::default(),
        }
    }

    /// As [`Backend::read`], without waiting: for browsers, where nothing may wait, and for callers that share a device and go on.
    /// Outside of a browser the caller polls the device, for example by [`wgpu::Device::poll`] in its loop.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub async fn read_async(&self, buffer: &Buffer, range: Range<u64>) -> Result<Vec<u8>, BackendError> {
        let read = self.start_reading(buffer, range)?.finish().await;
        self.check()?;
        read.map_err(|reason| self.lost(reason))
    }

    fn start_reading(&self, buffer: &Buffer, range: Range<u64>) -> Result<Reading, BackendError> {
        let source = self.buffers.get(buffer)?;
        let (start, bytes) = (range.start, range.end.saturating_sub(range.start));
        pass::check_part(start, bytes, Some(source.size()))?;
        Ok(Reading::submit(&self.opened, source, start, bytes))
    }

    fn lost(&self, reason: String) -> BackendError {
        BackendError::DeviceLost { adapter: self.adapter.clone(), reason }
    }

    /// The backend with `threads` threads of its own for the work of the host, instead of the process's.
    ///
    /// # Errors
    /// [`BackendError::Threads`] where the threads cannot be started.
    pub fn with_threads(self, threads: usize) -> Result<Self, BackendError> {
        Ok(Self { threads: Threads::start(Some(threads))?, ..self })
    }

    /// The device's failure, if it had one.
    fn check(&self) -> Result<(), BackendError> {
        let mut slot = self.opened.failure.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        match slot.take() {
            None => Ok(()),
            Some(reason) => Err(BackendError::DeviceLost { adapter: self.adapter.clone(), reason }),
        }
    }

    /// Waits for a submission.
    fn wait(&self, submission: wgpu::SubmissionIndex) -> Result<(), BackendError> {
        self.opened
            .device
            .poll(wgpu::PollType::Wait { submission_index: Some(submission), timeout: None })
            .map_err(|error| BackendError::DeviceLost { adapter: self.adapter.clone(), reason: error.to_string() })?;
        self.check()
    }

    fn allocate(&mut self, label: &str, bytes: u64, usage: wgpu::BufferUsages) -> Result<wgpu::Buffer, BackendError> {
        if bytes > self.largest_buffer() {
            return Err(BackendError::TooLarge {
                label: label.to_owned(),
                needed: bytes,
                limit: self.largest_buffer(),
                adapter: self.adapter.clone(),
            });
        }
        let scope = self.opened.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let buffer = self.opened.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: bytes,
            usage: usage | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        });
        match pollster::block_on(scope.pop()) {
            None => Ok(buffer),
            Some(_) => Err(BackendError::OutOfMemory {
                adapter: self.adapter.clone(),
                what: format!("{label}, {bytes} bytes"),
            }),
        }
    }

    /// Copies bytes to a new buffer.
    fn copy(&self, contents: &[u8], buffer: &wgpu::Buffer) -> Result<(), BackendError> {
        let mut offset = 0;
        for part in contents.chunks(BYTES_PER_COPY) {
            self.opened.queue.write_buffer(buffer, offset, part);
            offset += part.len() as u64;
            // Without this the copy waits in host memory until the first pass.
            let submission = self.opened.queue.submit([]);
            self.wait(submission)?;
        }
        Ok(())
    }
}

impl Backend for GpuBackend {
    fn name(&self) -> &'static str {
        "gpu"
    }

    fn adapter(&self) -> String {
        self.adapter.clone()
    }

    fn largest_buffer(&self) -> u64 {
        // Kernels index words by a signed 32-bit number.
        self.limits.max_storage_buffer_binding_size.min(self.limits.max_buffer_size).min((i32::MAX as u64) * 4)
    }

    fn threads(&self) -> Threads {
        self.threads.clone()
    }

    fn volume_limit(&self) -> u64 {
        self.volume_limit.unwrap_or(u64::MAX)
    }

    fn set_volume_limit(&mut self, bytes: Option<u64>) {
        self.volume_limit = bytes;
    }

    fn create(&mut self, label: &str, contents: Contents<'_>) -> Result<Buffer, BackendError> {
        // Before the memory is taken, not behind it: what was dropped makes room.
        self.buffers.collect();
        let bytes = contents.bytes();
        let buffer = self.allocate(label, bytes, wgpu::BufferUsages::STORAGE)?;
        match contents {
            Contents::Bytes(bytes) => self.copy(bytes, &buffer)?,
            Contents::Shared(words) => self.copy(bytemuck::cast_slice(words), &buffer)?,
            // wgpu clears new buffers.
            Contents::Zeros(_) => {}
            Contents::Written(_, fill) => {
                let mut words = vec![0; bytes as usize / 4];
                fill(&mut words);
                self.copy(bytemuck::cast_slice(&words), &buffer)?;
            }
        }
        Ok(self.buffers.add(buffer))
    }

    fn write(
        &mut self,
        buffer: &Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError> {
        let target = self.buffers.get(buffer)?;
        pass::check_part(0, words as u64 * 4, Some(target.size()))?;
        let mut contents = vec![0; words];
        fill(&mut contents);
        self.opened.queue.write_buffer(target, 0, bytemuck::cast_slice(&contents));
        Ok(())
    }

    fn clear(&mut self, buffer: &Buffer) -> Result<(), BackendError> {
        let mut encoder = self.opened.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.clear_buffer(self.buffers.get(buffer)?, 0, None);
        self.opened.queue.submit([encoder.finish()]);
        self.check()
    }

    fn run(&mut self, list: &PassList, progress: &mut (dyn FnMut(usize) -> bool + Send)) -> Result<(), BackendError> {
        run::run(self, list, progress)
    }

    fn read(
        &mut self,
        buffer: &Buffer,
        range: Range<u64>,
        see: &mut (dyn FnMut(&[u8]) + Send),
    ) -> Result<(), BackendError> {
        let reading = self.start_reading(buffer, range)?;
        self.wait(reading.submission.clone())?;
        see(&pollster::block_on(reading.finish()).map_err(|reason| self.lost(reason))?);
        Ok(())
    }

    fn bytes(&self, buffer: &Buffer) -> Result<u64, BackendError> {
        Ok(self.buffers.get(buffer)?.size())
    }

    fn take_kernel_times(&mut self) -> Vec<KernelTime> {
        std::mem::take(&mut self.times)
    }

    fn device_bytes(&self) -> Option<u64> {
        Some(self.buffers.living().map(wgpu::Buffer::size).sum())
    }
}

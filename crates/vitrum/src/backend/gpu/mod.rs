//! The GPU backend: the kernels' SPIR-V through wgpu, on Vulkan, Metal or DX12, without a window.

mod adapter;
#[cfg_attr(target_arch = "wasm32", path = "module_in_browser.rs")]
mod module;
mod pipeline;
mod read;
mod stopwatch;
mod together;

pub(crate) use adapter::{adapters, describe, is_hardware, takes_spirv};

use super::buffer::Buffers;
use super::{Backend, BackendError, Buffer, Contents, GpuOptions, KernelTime, Pass, PassList, Threads, Write, pass};
use adapter::Opened;
use pipeline::Pipeline;
use read::Reading;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::ops::Range;
use stopwatch::Stopwatch;
use together::{block_bytes, dispatches};
use vitrum_kernels::kernel::{Access, WORKGROUP, Window};

/// Passes in one submission: few enough for progress and cancelling, many enough that submitting costs nothing.
const PASSES_PER_SUBMISSION: usize = 96;

/// Bytes on their way to the device at once, for which the driver keeps a copy in host memory.
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

    /// Opens the adapter that `options` say, in the way they say.
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

    /// The features and limits for a device of an adapter that is handed to [`Self::with_device`]; a caller adds its own.
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

    /// Has the work of the host run on `threads` threads instead of the process's own.
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

    /// All dispatches' uniform blocks in one buffer; where those of each start.
    fn upload_uniforms<'a>(
        &mut self,
        dispatches: impl Iterator<Item = &'a [Pass]>,
    ) -> Result<(wgpu::Buffer, Vec<u32>), BackendError> {
        let alignment = self.limits.min_storage_buffer_offset_alignment.max(16) as usize;
        let mut bytes = Vec::new();
        let starts = dispatches
            .map(|dispatch| {
                bytes.resize(bytes.len().next_multiple_of(alignment), 0);
                let start = bytes.len() as u32;
                dispatch.iter().for_each(|pass| bytes.extend_from_slice(&pass.uniforms));
                start
            })
            .collect();
        bytes.resize(bytes.len().next_multiple_of(alignment).max(alignment), 0);
        let buffer = self.allocate("uniforms", bytes.len() as u64, wgpu::BufferUsages::STORAGE)?;
        self.opened.queue.write_buffer(&buffer, 0, &bytes);
        Ok((buffer, starts))
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

    /// Does the writes that come before a pass, behind all submissions.
    fn write_before(&self, writes: &[Write]) -> Result<(), BackendError> {
        let mut under_way = 0;
        for write in writes {
            write.check(|buffer| self.buffers.find(buffer).map(wgpu::Buffer::size))?;
            let mut words = vec![0; write.words];
            (write.fill)(&mut words);
            self.opened.queue.write_buffer(
                self.buffers.get(&write.buffer)?,
                write.start * 4,
                bytemuck::cast_slice(&words),
            );
            under_way += write.words * 4;
            if under_way >= BYTES_PER_COPY {
                under_way = 0;
                let submission = self.opened.queue.submit([]);
                self.wait(submission)?;
            }
        }
        Ok(())
    }

    fn prepare_pipelines(&mut self, passes: &[Pass]) -> Result<(), BackendError> {
        for pass in passes {
            pass.check(|buffer| self.buffers.find(buffer).map(wgpu::Buffer::size))?;
            let declaration = &pass.kernel.declaration;
            if let Entry::Vacant(slot) = self.pipelines.entry(declaration.name) {
                slot.insert(Pipeline::new(&self.opened, &self.adapter, declaration)?);
            }
        }
        Ok(())
    }

    fn bind_group(&self, dispatch: &[Pass], uniforms: &wgpu::Buffer) -> Result<wgpu::BindGroup, BackendError> {
        let pass = &dispatch[0];
        let declaration = &pass.kernel.declaration;
        let blocks = wgpu::BufferBinding { buffer: uniforms, offset: 0, size: block_bytes(dispatch) };
        let mut entries = vec![wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::Buffer(blocks) }];
        for (buffer, binding) in pass.buffers.iter().zip(&declaration.bindings[1..]) {
            let mut resource = self.buffers.get(buffer)?.as_entire_buffer_binding();
            if binding.access != Access::Read {
                resource.offset = pass.start * 4;
            }
            entries.push(wgpu::BindGroupEntry {
                binding: binding.binding,
                resource: wgpu::BindingResource::Buffer(resource),
            });
        }
        Ok(self.opened.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(declaration.name),
            layout: &self.pipelines[declaration.name].layout,
            entries: &entries,
        }))
    }
}

/// What a bind group is made of: the kernel, the numbers of its buffers, where its records start, and how many passes' uniform blocks there
/// are.
type Bound<'a> = (&'a str, Vec<usize>, u64, usize);

fn bound(dispatch: &[Pass]) -> Bound<'_> {
    let pass = &dispatch[0];
    (pass.kernel.declaration.name, pass.buffers.iter().map(Buffer::number).collect(), pass.start, dispatch.len())
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

    fn run(&mut self, list: &PassList, progress: &mut dyn FnMut(usize) -> bool) -> Result<(), BackendError> {
        self.buffers.collect();
        let passes = &list.passes;
        self.prepare_pipelines(passes)?;
        let batches = || {
            list.runs().flat_map(|(writes, run)| {
                let chunks = run.chunks(PASSES_PER_SUBMISSION).enumerate();
                chunks.map(move |(index, chunk)| (if index == 0 { writes } else { &[] }, chunk))
            })
        };
        let (uniforms, starts) = self.upload_uniforms(batches().flat_map(|(_, chunk)| dispatches(chunk)))?;
        let mut starts = starts.into_iter();
        let mut groups: HashMap<Bound, wgpu::BindGroup> = HashMap::new();
        let mut under_way = None;
        let mut watches = Vec::new();
        let mut done = 0;
        for (writes, chunk) in batches() {
            if !progress(done) {
                return Err(BackendError::Cancelled);
            }
            self.write_before(writes)?;
            for dispatch in dispatches(chunk) {
                if let Entry::Vacant(slot) = groups.entry(bound(dispatch)) {
                    slot.insert(self.bind_group(dispatch, &uniforms)?);
                }
            }
            let mut encoder = self.opened.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            let kernels =
                dispatches(chunk).map(|dispatch| (dispatch[0].kernel.declaration.name, dispatch.len() as u32));
            let watch = Stopwatch::new(&self.opened, kernels.collect());
            {
                let mut compute = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
                if let Some(watch) = &watch {
                    watch.note(&mut compute, 0);
                }
                for ((index, dispatch), start) in dispatches(chunk).enumerate().zip(starts.by_ref()) {
                    let Pass { kernel, window: Window { first: low, end: high }, .. } = &dispatch[0];
                    compute.set_pipeline(&self.pipelines[kernel.declaration.name].pipeline);
                    compute.set_bind_group(0, &groups[&bound(dispatch)], &[start]);
                    let [across, down] = [0, 1].map(|axis| (high[axis] - low[axis]).div_ceil(WORKGROUP));
                    compute.dispatch_workgroups(across, down, 1);
                    if let Some(watch) = &watch {
                        watch.note(&mut compute, index + 1);
                    }
                }
            }
            if let Some(watch) = watch {
                watch.stop(&mut encoder);
                watches.push(watch);
            }
            let submission = self.opened.queue.submit([encoder.finish()]);
            done += chunk.len();
            // One submission runs while the next is recorded.
            if let Some(previous) = under_way.replace(submission) {
                self.wait(previous)?;
            }
        }
        if let Some(last) = under_way {
            self.wait(last)?;
        }
        for watch in watches {
            watch.read(&self.opened, &mut self.times);
        }
        progress(passes.len());
        Ok(())
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

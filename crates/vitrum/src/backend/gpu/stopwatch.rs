//! Times of passes, by the device's own clock.

use super::super::times::{self, KernelTime};
use super::adapter::Opened;

/// A time before the first dispatch of a submission and one behind each of its dispatches.
pub(super) struct Stopwatch {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    readable: wgpu::Buffer,
    /// Each dispatch's kernel, and its passes.
    kernels: Vec<(&'static str, u32)>,
}

impl Stopwatch {
    /// For dispatches of `kernels`, in order, and of so many passes each; none if the device has no clock that passes can read.
    pub(super) fn new(opened: &Opened, kernels: Vec<(&'static str, u32)>) -> Option<Self> {
        let feature = wgpu::Features::TIMESTAMP_QUERY_INSIDE_PASSES;
        let count = kernels.len() as u32 + 1;
        if !opened.device.features().contains(feature) || count > wgpu::QUERY_SET_MAX_QUERIES {
            return None;
        }
        let buffer = |usage| {
            let size = u64::from(count) * u64::from(wgpu::QUERY_SIZE);
            opened.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("times"),
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        Some(Self {
            queries: opened.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("times"),
                ty: wgpu::QueryType::Timestamp,
                count,
            }),
            resolved: buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC),
            readable: buffer(wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST),
            kernels,
        })
    }

    /// Notes the time when `dispatches` of them are done.
    pub(super) fn note(&self, compute: &mut wgpu::ComputePass<'_>, dispatches: usize) {
        compute.write_timestamp(&self.queries, dispatches as u32);
    }

    /// Copies the times to where they can be read.
    pub(super) fn stop(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.resolve_query_set(&self.queries, 0..self.kernels.len() as u32 + 1, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.readable, 0, self.readable.size());
    }

    /// Adds the times up, once the submission is done; what cannot be read is left out.
    pub(super) fn read(&self, opened: &Opened, sum: &mut Vec<KernelTime>) {
        let slice = self.readable.slice(..);
        slice.map_async(wgpu::MapMode::Read, |_| {});
        let polled = opened.device.poll(wgpu::PollType::Wait { submission_index: None, timeout: None });
        let (Ok(_), Ok(view)) = (polled, slice.get_mapped_range()) else { return };
        let ticks: Vec<u64> = bytemuck::pod_collect_to_vec(&view);
        let period = f64::from(opened.queue.get_timestamp_period());
        for (&(kernel, passes), pair) in self.kernels.iter().zip(ticks.windows(2)) {
            times::add(sum, kernel, passes, pair[1].saturating_sub(pair[0]) as f64 * period * 1e-6);
        }
    }
}

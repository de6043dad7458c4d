//! Times of passes, by the device's own clock.

use super::super::times::{self, KernelTime};
use super::adapter::Opened;
use super::workgroups::{Place, Places};

/// A dispatch whose time is taken.
pub(super) struct Timed {
    /// Its kernel.
    pub(super) kernel: &'static str,
    /// Its passes.
    pub(super) passes: u32,
    /// The place of its numbers of workgroups, if it may be left out.
    pub(super) workgroups: Option<Place>,
}

/// A time before the first dispatch of a submission and one behind each of its dispatches.
pub(super) struct Stopwatch {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    readable: wgpu::Buffer,
    dispatches: Vec<Timed>,
}

impl Stopwatch {
    /// For `dispatches`, in order; none if the device has no clock that passes can read.
    pub(super) fn new(opened: &Opened, dispatches: Vec<Timed>) -> Option<Self> {
        let feature = wgpu::Features::TIMESTAMP_QUERY_INSIDE_PASSES;
        let count = dispatches.len() as u32 + 1;
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
            dispatches,
        })
    }

    /// Notes the time when `dispatches` of them are done.
    pub(super) fn note(&self, compute: &mut wgpu::ComputePass<'_>, dispatches: usize) {
        compute.write_timestamp(&self.queries, dispatches as u32);
    }

    /// Copies the times to where they can be read.
    pub(super) fn stop(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.resolve_query_set(&self.queries, 0..self.dispatches.len() as u32 + 1, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.readable, 0, self.readable.size());
    }

    /// Whether one of them may be left out.
    pub(super) fn depends(&self) -> bool {
        self.dispatches.iter().any(|dispatch| dispatch.workgroups.is_some())
    }

    /// Adds the times up, once the submission is done and the numbers of workgroups have been read; times that cannot be read are left out.
    pub(super) fn read(&self, opened: &Opened, places: &Places, sum: &mut Vec<KernelTime>) {
        let slice = self.readable.slice(..);
        slice.map_async(wgpu::MapMode::Read, |_| {});
        let polled = opened.device.poll(wgpu::PollType::Wait { submission_index: None, timeout: None });
        let (Ok(_), Ok(view)) = (polled, slice.get_mapped_range()) else { return };
        let ticks: Vec<u64> = bytemuck::pod_collect_to_vec(&view);
        let period = f64::from(opened.queue.get_timestamp_period());
        for (dispatch, pair) in self.dispatches.iter().zip(ticks.windows(2)) {
            let has_run = dispatch.workgroups.is_none_or(|place| places.is_raised(place));
            let passes = if has_run { dispatch.passes } else { 0 };
            times::add(sum, dispatch.kernel, passes, pair[1].saturating_sub(pair[0]) as f64 * period * 1e-6);
        }
    }
}

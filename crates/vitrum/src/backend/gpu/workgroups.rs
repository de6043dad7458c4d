//! Dispatches that depend on whether an earlier one had work ([`WhileBusy`]): they take their numbers of workgroups from a buffer, which are 0
//! until an invocation of the earlier dispatch raises them. The host is not asked, so that nothing waits for it.

use super::GpuBackend;
use super::read::Reading;
use crate::backend::{BackendError, Pass, PassList, WhileBusy};
use std::collections::HashMap;
use vitrum_kernels::kernel::{WORKGROUP, Window};

/// Bytes of the numbers of workgroups along x, y and z.
pub(super) const BYTES: u64 = 12;

/// A place for the numbers of workgroups, in one of two buffers: a dispatch may not take its own numbers from the buffer that it writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    /// Index of the buffer.
    pub(super) buffer: usize,
    /// Index of the place in the buffer.
    pub(super) number: u32,
}

/// The numbers of workgroups of one dispatch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Workgroups {
    /// The place from which the numbers are taken; `None` if they are always the ones of the pass's window.
    pub(super) taken: Option<Place>,
    /// The place that the dispatch raises if it has work and reports it.
    pub(super) raised: Place,
}

/// Numbers of workgroups along x and y for a pass's window.
pub(super) fn of_window(pass: &Pass) -> [u32; 2] {
    let Window { first, end } = pass.window;
    [0, 1].map(|axis| (end[axis] - first[axis]).div_ceil(WORKGROUP))
}

/// Those parts of a list that a GPU leaves out: of kernels that report work, all dispatches with the same numbers of workgroups, and no kernel
/// in two parts, so that a dispatch depends on one other.
fn parts(list: &PassList) -> Vec<&WhileBusy> {
    let mut parts: Vec<&WhileBusy> = Vec::new();
    for part in &list.while_busy {
        let names = |part: &WhileBusy| [&[part.kernel], &part.passes[..]].concat();
        let own = names(part);
        let taken = parts.iter().any(|other| names(other).iter().any(|name| own.contains(name)));
        let mut passes = list.passes.iter().filter(|pass| own.contains(&pass.kernel.declaration.name));
        let size = list.passes.iter().find(|pass| pass.kernel.declaration.name == part.kernel).map(of_window);
        let alike = passes.all(|pass| Some(of_window(pass)) == size);
        let mut counted = list.passes.iter().filter(|pass| pass.kernel.declaration.name == part.kernel);
        if !taken && alike && counted.all(|pass| pass.kernel.declaration.reports_work()) {
            parts.push(part);
        }
    }
    parts
}

/// The numbers of workgroups of a list's dispatches, in their order, and how many places each of the two buffers has.
pub(super) fn plan<'a>(list: &PassList, dispatches: impl Iterator<Item = &'a [Pass]>) -> (Vec<Workgroups>, u32) {
    let parts = parts(list);
    // By the kernel of a part: the place that its last dispatch raises.
    let mut last: HashMap<&str, Place> = HashMap::new();
    // The first place of each buffer is for dispatches that no other depends on.
    let mut count = 1;
    let plan = dispatches.map(|dispatch| {
        let name = dispatch[0].kernel.declaration.name;
        parts.iter().filter(|part| part.until == Some(name)).for_each(|part| {
            last.remove(part.kernel);
        });
        let part = parts.iter().find(|part| part.passes.contains(&name));
        let taken = part.and_then(|part| last.get(part.kernel).copied());
        let mut raised = Place { buffer: taken.map_or(0, |taken| 1 - taken.buffer), number: 0 };
        if parts.iter().any(|part| part.kernel == name) {
            raised.number = count;
            count += 1;
            last.insert(name, raised);
        }
        Workgroups { taken, raised }
    });
    (plan.collect(), count)
}

/// The two buffers, while a list runs.
pub(super) struct Places {
    buffers: [wgpu::Buffer; 2],
    /// Distance of two places in bytes.
    pitch: u32,
    is_clear: bool,
    /// The words of both buffers after the run; empty before.
    words: [Vec<u32>; 2],
}

impl Places {
    /// Buffers of `count` places each.
    pub(super) fn new(backend: &mut GpuBackend, count: u32) -> Result<Self, BackendError> {
        let pitch = backend.limits.min_storage_buffer_offset_alignment.max(16);
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::INDIRECT;
        let mut buffer = || backend.allocate("numbers of workgroups", u64::from(pitch) * u64::from(count), usage);
        let buffers = [buffer()?, buffer()?];
        Ok(Self { buffers, pitch, is_clear: false, words: [const { Vec::new() }; 2] })
    }

    /// The buffer of a place.
    pub(super) fn buffer(&self, place: Place) -> &wgpu::Buffer {
        &self.buffers[place.buffer]
    }

    /// Offset of a place in its buffer, in bytes.
    pub(super) fn offset(&self, place: Place) -> u32 {
        place.number * self.pitch
    }

    /// Makes all numbers 0, the first time.
    pub(super) fn clear(&mut self, encoder: &mut wgpu::CommandEncoder) {
        if !self.is_clear {
            self.buffers.iter().for_each(|buffer| encoder.clear_buffer(buffer, 0, None));
            self.is_clear = true;
        }
    }

    /// Reads all numbers, once the list has run.
    pub(super) fn read(&mut self, backend: &GpuBackend) -> Result<(), BackendError> {
        for (buffer, words) in self.buffers.iter().zip(&mut self.words) {
            let reading = Reading::submit(&backend.opened, buffer, 0, buffer.size());
            backend.wait(reading.submission.clone())?;
            let bytes = pollster::block_on(reading.finish()).map_err(|reason| backend.lost(reason))?;
            *words = bytemuck::pod_collect_to_vec(&bytes);
        }
        Ok(())
    }

    /// Whether a dispatch that takes its numbers from a place has run.
    pub(super) fn is_raised(&self, place: Place) -> bool {
        self.words[place.buffer].get((self.offset(place) / 4) as usize) != Some(&0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_kernels::kernel::{Kernel, kernels};

    fn pass(kernel: &'static Kernel, width: u32) -> Pass {
        let window = Window::whole(width, 1);
        Pass { kernel, uniforms: Vec::new(), buffers: Vec::new(), start: 0, width, height: 1, window }
    }

    /// The place of the numbers of workgroups of each pass of a list, as buffer and place.
    fn taken(
        kernels: &[(&'static Kernel, u32)],
        while_busy: &[(&'static str, &[&'static str])],
    ) -> Vec<Option<(usize, u32)>> {
        taken_until(kernels, while_busy, None)
    }

    /// As [`taken`], where passes matter again behind one of the kernel `until`.
    fn taken_until(
        kernels: &[(&'static Kernel, u32)],
        while_busy: &[(&'static str, &[&'static str])],
        until: Option<&'static str>,
    ) -> Vec<Option<(usize, u32)>> {
        let passes = kernels.iter().map(|&(kernel, width)| pass(kernel, width)).collect();
        let part = |&(kernel, passes): &(&'static str, &[&'static str])| {
            let passes = passes.to_vec();
            WhileBusy { kernel, passes, until }
        };
        let list = PassList { passes, while_busy: while_busy.iter().map(part).collect(), ..PassList::default() };
        let (plan, _) = plan(&list, list.passes.chunks(1));
        for Workgroups { taken, raised } in &plan {
            assert_ne!(taken.map(|taken| taken.buffer), Some(raised.buffer), "a buffer is read and written");
        }
        plan.iter().map(|workgroups| workgroups.taken.map(|place| (place.buffer, place.number))).collect()
    }

    #[test]
    fn passes_depend_on_the_last_one_that_reports_work() {
        let (march, seek, resolve) = (&kernels::voxels_march, &kernels::voxels_seek, &kernels::voxels_resolve);
        let list = [(seek, 9), (march, 9), (seek, 9), (march, 9), (march, 9), (resolve, 9)];
        let first = Some((0, 1));
        let depends = taken(&list, &[("voxels_march", &["voxels_march", "voxels_seek"])]);
        assert_eq!(depends, [None, None, first, first, Some((1, 2)), None]);
        assert_eq!(taken(&list, &[]), [None; 6]);
    }

    #[test]
    fn passes_behind_new_work_depend_on_none_before() {
        let (march, follow) = (&kernels::voxels_march, &kernels::voxels_follow);
        let list = [(march, 9), (march, 9), (follow, 9), (march, 9), (march, 9)];
        let part: (&str, &[&str]) = ("voxels_march", &["voxels_march"]);
        let found = taken_until(&list, &[part], Some("voxels_follow"));
        assert_eq!(found, [None, Some((0, 1)), None, None, Some((0, 3))]);
    }

    #[test]
    fn passes_that_a_gpu_cannot_leave_out_run() {
        let (march, seek, light) = (&kernels::voxels_march, &kernels::voxels_seek, &kernels::sweep_filter_light);
        let part: (&str, &[&str]) = ("voxels_march", &["voxels_march", "voxels_seek"]);
        assert_eq!(taken(&[(march, 9), (seek, 17)], &[part]), [None; 2], "they have more workgroups");
        let of_light: (&str, &[&str]) = ("sweep_filter_light", &["sweep_filter_light"]);
        assert_eq!(taken(&[(light, 9), (light, 9)], &[of_light]), [None; 2], "the kernel does not report work");
        let other: (&str, &[&str]) = ("voxels_reflect", &["voxels_seek"]);
        let both = [(march, 9), (&kernels::voxels_reflect, 9), (seek, 9)];
        assert_eq!(taken(&both, &[part, other]), [None, None, Some((0, 1))], "it depends on one pass only");
    }
}

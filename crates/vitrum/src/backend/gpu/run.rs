//! Execution of a pass list: uniform blocks, bind groups, submissions.

use super::GpuBackend;
use super::dispatches::{block_bytes, dispatches};
use super::pipeline::Pipeline;
use super::stopwatch::{Stopwatch, Timed};
use super::workgroups::{self, Places, Workgroups};
use crate::backend::{BackendError, Buffer, Pass, PassList, Write};
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use vitrum_kernels::kernel::Access;

/// Passes in one submission: few enough for progress and cancelling, many enough that submitting costs nothing.
const PASSES_PER_SUBMISSION: usize = 96;

/// Passes in one submission where they report work, since each of them may take long.
const REPORTING_PASSES_PER_SUBMISSION: usize = 16;

/// The key of a bind group: the kernel, the numbers of its buffers, the offset of its records, the number of passes' uniform blocks,
/// and the buffer in which it reports work.
type Bound<'a> = (&'a str, Vec<usize>, u64, usize, Option<usize>);

fn bound<'a>(dispatch: &'a [Pass], workgroups: &Workgroups) -> Bound<'a> {
    let pass = &dispatch[0];
    let declaration = &pass.kernel.declaration;
    let reports = declaration.reports_work().then_some(workgroups.raised.buffer);
    (declaration.name, pass.buffers.iter().map(Buffer::number).collect(), pass.start, dispatch.len(), reports)
}

/// A list's passes in parts of one submission each, with the writes that come before them.
fn batches(list: &PassList) -> impl Iterator<Item = (&[Write], &[Pass])> {
    list.runs().flat_map(|(writes, run)| {
        let reports = run.iter().any(|pass| pass.kernel.declaration.reports_work());
        let most = if reports { REPORTING_PASSES_PER_SUBMISSION } else { PASSES_PER_SUBMISSION };
        run.chunks(most).enumerate().map(move |(index, chunk)| (if index == 0 { writes } else { &[] }, chunk))
    })
}

/// Runs all passes of a list; see [`crate::backend::Backend::run`].
pub(super) fn run(
    backend: &mut GpuBackend,
    list: &PassList,
    progress: &mut (dyn FnMut(usize) -> bool + Send),
) -> Result<(), BackendError> {
    backend.buffers.collect();
    prepare_pipelines(backend, &list.passes)?;
    let all = || batches(list).flat_map(|(_, chunk)| dispatches(chunk));
    let (uniforms, starts) = upload_uniforms(backend, all())?;
    let (plan, count) = workgroups::plan(list, all());
    let mut places = Places::new(backend, count)?;
    let mut order = starts.into_iter().zip(plan);
    let mut groups: HashMap<Bound, wgpu::BindGroup> = HashMap::new();
    let mut under_way = None;
    let mut watches = Vec::new();
    let mut done = 0;
    for (writes, chunk) in batches(list) {
        if !progress(done) {
            return Err(BackendError::Cancelled);
        }
        write_before(backend, writes)?;
        let together: Vec<(&[Pass], u32, Workgroups)> = dispatches(chunk)
            .zip(order.by_ref())
            .map(|(passes, (start, workgroups))| (passes, start, workgroups))
            .collect();
        for (dispatch, _, workgroups) in &together {
            if let Entry::Vacant(slot) = groups.entry(bound(dispatch, workgroups)) {
                slot.insert(bind_group(backend, dispatch, &uniforms, places.buffer(workgroups.raised))?);
            }
        }
        let mut encoder = backend.opened.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        places.clear(&mut encoder);
        let timed = together.iter().map(|(dispatch, _, workgroups)| Timed {
            kernel: dispatch[0].kernel.declaration.name,
            passes: dispatch.len() as u32,
            workgroups: workgroups.taken,
        });
        let watch = Stopwatch::new(&backend.opened, timed.collect());
        {
            let mut compute = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            if let Some(watch) = &watch {
                watch.note(&mut compute, 0);
            }
            for (index, (dispatch, start, workgroups)) in together.iter().enumerate() {
                let declaration = &dispatch[0].kernel.declaration;
                compute.set_pipeline(&backend.pipelines[declaration.name].pipeline);
                let offsets = [*start, places.offset(workgroups.raised)];
                let offsets = if declaration.reports_work() { &offsets[..] } else { &offsets[..1] };
                compute.set_bind_group(0, &groups[&bound(dispatch, workgroups)], offsets);
                match workgroups.taken {
                    Some(place) => {
                        compute.dispatch_workgroups_indirect(places.buffer(place), places.offset(place).into());
                    }
                    None => {
                        let [across, down] = workgroups::of_window(&dispatch[0]);
                        compute.dispatch_workgroups(across, down, 1);
                    }
                }
                if let Some(watch) = &watch {
                    watch.note(&mut compute, index + 1);
                }
            }
        }
        if let Some(watch) = watch {
            watch.stop(&mut encoder);
            watches.push(watch);
        }
        let submission = backend.opened.queue.submit([encoder.finish()]);
        done += chunk.len();
        // One submission runs while the next is recorded.
        if let Some(previous) = under_way.replace(submission) {
            backend.wait(previous)?;
        }
    }
    if let Some(last) = under_way {
        backend.wait(last)?;
    }
    if watches.iter().any(Stopwatch::depends) {
        places.read(backend)?;
    }
    for watch in watches {
        watch.read(&backend.opened, &places, &mut backend.times);
    }
    progress(list.passes.len());
    Ok(())
}

/// Uploads the uniform blocks of all dispatches into one buffer. The result has the offset of each dispatch's blocks.
fn upload_uniforms<'a>(
    backend: &mut GpuBackend,
    dispatches: impl Iterator<Item = &'a [Pass]>,
) -> Result<(wgpu::Buffer, Vec<u32>), BackendError> {
    let alignment = backend.limits.min_storage_buffer_offset_alignment.max(16) as usize;
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
    let buffer = backend.allocate("uniforms", bytes.len() as u64, wgpu::BufferUsages::STORAGE)?;
    backend.opened.queue.write_buffer(&buffer, 0, &bytes);
    Ok((buffer, starts))
}

/// Performs the writes before a pass, behind all submissions.
fn write_before(backend: &GpuBackend, writes: &[Write]) -> Result<(), BackendError> {
    let mut under_way = 0;
    for write in writes {
        write.check(|buffer| backend.buffers.find(buffer).map(wgpu::Buffer::size))?;
        let mut words = vec![0; write.words];
        (write.fill)(&mut words);
        backend.opened.queue.write_buffer(
            backend.buffers.get(&write.buffer)?,
            write.start * 4,
            bytemuck::cast_slice(&words),
        );
        under_way += write.words * 4;
        if under_way >= super::BYTES_PER_COPY {
            under_way = 0;
            let submission = backend.opened.queue.submit([]);
            backend.wait(submission)?;
        }
    }
    Ok(())
}

fn prepare_pipelines(backend: &mut GpuBackend, passes: &[Pass]) -> Result<(), BackendError> {
    for pass in passes {
        pass.check(|buffer| backend.buffers.find(buffer).map(wgpu::Buffer::size))?;
        let declaration = &pass.kernel.declaration;
        if let Entry::Vacant(slot) = backend.pipelines.entry(declaration.name) {
            slot.insert(Pipeline::new(&backend.opened, &backend.adapter, declaration)?);
        }
    }
    Ok(())
}

/// The buffers of a dispatch, `raised` among them if its kernel reports work.
fn bind_group(
    backend: &GpuBackend,
    dispatch: &[Pass],
    uniforms: &wgpu::Buffer,
    raised: &wgpu::Buffer,
) -> Result<wgpu::BindGroup, BackendError> {
    let pass = &dispatch[0];
    let declaration = &pass.kernel.declaration;
    let blocks = wgpu::BufferBinding { buffer: uniforms, offset: 0, size: block_bytes(dispatch) };
    let mut entries = vec![wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::Buffer(blocks) }];
    for (buffer, binding) in pass.buffers.iter().zip(declaration.buffers()) {
        let mut resource = backend.buffers.get(buffer)?.as_entire_buffer_binding();
        if binding.access != Access::Read {
            resource.offset = pass.start * 4;
        }
        entries
            .push(wgpu::BindGroupEntry { binding: binding.binding, resource: wgpu::BindingResource::Buffer(resource) });
    }
    for binding in declaration.bindings.iter().filter(|binding| binding.access == Access::Workgroups) {
        let size = wgpu::BufferSize::new(workgroups::BYTES);
        let resource = wgpu::BindingResource::Buffer(wgpu::BufferBinding { buffer: raised, offset: 0, size });
        entries.push(wgpu::BindGroupEntry { binding: binding.binding, resource });
    }
    Ok(backend.opened.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some(declaration.name),
        layout: &backend.pipelines[declaration.name].layout,
        entries: &entries,
    }))
}

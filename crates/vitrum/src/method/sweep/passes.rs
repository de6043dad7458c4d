//! The pass list of a frame (Algorithm 1).

use super::Buffers;
use super::carrier::{Carrier, Maker, Volumes};
use super::occupancy::{Question, Ranges, Role};
use super::paging::{Needs, pools};
use super::sheets::Sheets;
use super::texels::Texels;
use super::uniforms::Fixed;
use super::unoccluded::Unoccluded;
use super::voxels::{bricks, chosen_format, fit, upload};
use crate::backend::{Backend, BackendError, Buffer, PassList, WhileBusy, Write};
use crate::inputs::Inputs;
use crate::render::{Error, Wanted};
use glam::DVec3;
use std::collections::BTreeSet;
use vitrum_io::Volume;
use vitrum_kernels::abi::format::Format;
use vitrum_kernels::abi::record::{film, ray};
use vitrum_kernels::kernel::kernels;

/// A frame's voxels on a backend: what stays the same while scene and camera change.
#[derive(Debug)]
pub struct Uploaded {
    /// The volume's voxels and the second one's, or the same again; none if they come and go in the course of a frame.
    voxels: Option<[Buffer; 2]>,
    pub(super) format: Format,
    /// Whether streamed voxels take as little memory as they can, not as much as they may.
    pub(super) tight: bool,
    ranges: Ranges,
    /// The second volume's.
    ior_ranges: Option<Ranges>,
}

impl Uploaded {
    /// Hands the volumes to the backend, unless that is more than it may have at once.
    ///
    /// # Errors
    /// If the backend fails.
    pub fn new(inputs: &Inputs, backend: &mut dyn Backend) -> Result<Self, Error> {
        let (shown, bending) = (&inputs.volume, inputs.ior_volume.as_ref());
        let format = chosen_format(shown, bending);
        if !fit(&volumes(inputs), format, backend) {
            return Ok(Self { tight: false, ..Self::streamed(inputs) });
        }
        let voxels = upload(shown, format, backend)?;
        let ior_voxels = match bending.map(|bending| upload(bending, format, backend)) {
            None => voxels,
            Some(Ok(ior_voxels)) => ior_voxels,
            Some(Err(error)) => {
                backend.free(voxels);
                return Err(error.into());
            }
        };
        let ior_ranges = bending.map(Ranges::new);
        let ranges = Ranges::new(shown);
        Ok(Self { voxels: Some([voxels, ior_voxels]), format, tight: false, ranges, ior_ranges })
    }

    /// Streams the volumes in as little memory as that takes, however small they are.
    #[must_use]
    pub fn streamed(inputs: &Inputs) -> Self {
        let (shown, bending) = (&inputs.volume, inputs.ior_volume.as_ref());
        let format = chosen_format(shown, bending).paged();
        Self { voxels: None, format, tight: true, ranges: Ranges::new(shown), ior_ranges: bending.map(Ranges::new) }
    }

    /// Frees the buffers.
    pub fn free(&self, backend: &mut dyn Backend) {
        let Some([voxels, ior_voxels]) = self.voxels else { return };
        backend.free(voxels);
        if ior_voxels != voxels {
            backend.free(ior_voxels);
        }
    }
}

/// The volume that is shown, and the second one if there is one.
fn volumes(inputs: &Inputs) -> Vec<&Volume> {
    std::iter::once(&inputs.volume).chain(&inputs.ior_volume).collect()
}

/// Uploads what else a frame needs and lists its passes. Buffers are added to `created` as they are made.
pub(super) fn build(
    inputs: &Inputs,
    fixed: &Fixed,
    uploaded: &Uploaded,
    wanted: Wanted,
    backend: &mut dyn Backend,
    created: &mut Vec<Buffer>,
) -> Result<(PassList, Buffers), Error> {
    let shown = &inputs.volume;
    let Uploaded { ranges, ior_ranges, .. } = uploaded;
    let tables = &fixed.tables;
    let second = inputs.ior_volume.as_ref().zip(ior_ranges.as_ref());
    let role = if second.is_none() { Role::Both } else { Role::Shown };
    let mut questions = vec![Question { volume: shown, ranges, tables, reach: fixed.reach[0], role }];
    questions.extend(second.map(|(volume, ranges)| Question {
        volume,
        ranges,
        tables,
        reach: fixed.reach[1],
        role: Role::Bending,
    }));
    let (occupancy, occupied) = occupancy(&questions, backend)?;
    created.push(occupancy);
    let mut upload = |label: &str, contents: &[u8]| -> Result<Buffer, BackendError> {
        let buffer = backend.create(label, contents)?;
        created.push(buffer);
        Ok(buffer)
    };
    let tables = upload("tables", bytemuck::cast_slice(&fixed.tables.words))?;
    let map = upload("environment", bytemuck::cast_slice(&fixed.environment.map))?;

    let first = fixed.planes.first_visible;
    let (voxels, pools) = match uploaded.voxels {
        Some(voxels) => (voxels, Vec::new()),
        None => {
            let earliest = if fixed.shadows { 1 } else { first + 1 };
            let asked = questions.iter().zip(&fixed.sampling);
            let needs = asked.map(|(question, sampling)| Needs::new(question, sampling, &fixed.planes, earliest));
            let pools = pools(&volumes(inputs), needs.collect(), uploaded, backend, created)?;
            ([pools[0].buffer, pools[pools.len() - 1].buffer], pools)
        }
    };
    let [voxels, ior_voxels] = voxels;
    let volumes = Volumes { voxels, ior_voxels, occupancy, tables };
    let mut maker = Maker { fixed, backend, created };
    let light: Box<dyn Carrier> = match &fixed.sheets {
        _ if !fixed.shadows => Box::new(Unoccluded::new(&mut maker)?),
        None => {
            let inside = || fixed.seen(occupied.into_iter().map(|point| fixed.view.point(point)));
            let everywhere = wanted.light || fixed.lights_surroundings || !fixed.light_grid.follows_light();
            Box::new(Texels::new(&mut maker, volumes, (!everywhere).then(inside))?)
        }
        Some(sources) => Box::new(Sheets::new(&mut maker, volumes, sources)?),
    };
    let pixels = fixed.rays;
    let rays = maker.planar("rays", pixels, ray::SIZE)?;
    let finished = maker.planar("film", pixels, film::SIZE)?;

    let ray_kernel = kernels::sweep_propagate_rays.get(fixed.format);
    let mut passes = light.start(fixed);
    passes.push(fixed.pass(&kernels::sweep_initialize_rays, pixels, 0, first, &[rays]));
    // The first pass of each plane.
    let mut starts = vec![0];
    let bound = [voxels, ior_voxels, occupancy, tables, light.irradiance(), rays];
    // Rays on their way over planes whose irradiance is kept.
    let mut waiting = Vec::new();
    for plane in 1..fixed.planes.count {
        starts.push(passes.len());
        if plane > first {
            waiting.push(fixed.pass(ray_kernel, pixels, fixed.mode, plane, &bound));
        }
        if waiting.len() == fixed.kept().planes as usize {
            passes.append(&mut waiting);
        }
        light.advance(fixed, plane, &mut passes);
    }
    passes.append(&mut waiting);
    let last = fixed.planes.count - 1;
    passes.push(fixed.pass(&kernels::sweep_resolve, pixels, 0, last, &[rays, map, finished]));
    let (name, resolve) = (ray_kernel.declaration.name, kernels::sweep_resolve.declaration.name);
    let mut writes: Vec<Write> = pools.into_iter().flat_map(|pool| pool.writes(&starts)).collect();
    writes.sort_by_key(|write| write.before);
    // Light goes on to the last plane only where what is there is an output, too.
    let names = passes.iter().map(|pass| pass.kernel.declaration.name);
    let ends: BTreeSet<&str> = names.filter(|other| *other == name || !wanted.light && *other != resolve).collect();
    let while_busy = vec![WhileBusy { kernel: name, passes: ends.into_iter().collect() }];
    let list = PassList { passes, writes, while_busy };
    let buffers = Buffers { all: maker.created.clone(), irradiance: light.irradiance(), film: finished };
    Ok((list, buffers))
}

/// The bricks of all volumes, one volume after the other, and points in the world whose convex hull is that of those that are not empty.
fn occupancy(questions: &[Question], backend: &mut dyn Backend) -> Result<(Buffer, Vec<DVec3>), BackendError> {
    let counts: Vec<usize> =
        questions.iter().map(|question| bricks(question.volume).iter().map(|&n| n as usize).product()).collect();
    let bytes = counts.iter().sum::<usize>() as u64 * 4;
    let mut occupied = Vec::new();
    let buffer = backend.create_with("occupancy", bytes, &mut |mut words| {
        for (question, &count) in questions.iter().zip(&counts) {
            let (these, rest) = words.split_at_mut(count);
            question.answer(these);
            occupied.extend(question.occupied(these));
            words = rest;
        }
    })?;
    Ok((buffer, occupied))
}

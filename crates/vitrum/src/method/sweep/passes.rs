//! The pass list of a frame (Algorithm 1).

use super::Buffers;
use super::occupancy::{Role, classify};
use super::uniforms::Fixed;
use super::voxels::{chosen_format, pack, padded_bytes};
use crate::backend::{Backend, BackendError, Buffer, Pass, PassList};
use crate::inputs::Inputs;
use crate::render::Error;
use vitrum_kernels::abi::grid::format;
use vitrum_kernels::abi::record::{film, irradiance, light, ray, trace};
use vitrum_kernels::kernel::{Kernel, kernels};

/// The kernels that read a volume, for one voxel format.
struct Readers {
    light: &'static Kernel,
    rays: &'static Kernel,
}

fn readers(stored: u32) -> Readers {
    match stored {
        format::U8 => Readers { light: &kernels::sweep_refract_light_u8, rays: &kernels::sweep_propagate_rays_u8 },
        format::U16 => Readers { light: &kernels::sweep_refract_light_u16, rays: &kernels::sweep_propagate_rays_u16 },
        format::F32 => Readers { light: &kernels::sweep_refract_light_f32, rays: &kernels::sweep_propagate_rays_f32 },
        _ => Readers {
            light: &kernels::sweep_refract_light_f32_with_ior,
            rays: &kernels::sweep_propagate_rays_f32_with_ior,
        },
    }
}

/// A frame's voxels on a backend: what stays the same while scene and camera change.
#[derive(Debug, Clone, Copy)]
pub struct Uploaded {
    voxels: Buffer,
    /// The second volume's, or the same again.
    ior_voxels: Buffer,
}

impl Uploaded {
    /// Packs the volumes and hands them to the backend.
    ///
    /// # Errors
    /// If a volume is too large for the sweep or for the backend.
    pub fn new(inputs: &Inputs, backend: &mut dyn Backend) -> Result<Self, Error> {
        let stored = chosen_format(&inputs.volume, inputs.ior_volume.as_ref());
        check_size(&upload_limit(&inputs.volume, stored), "the volume")?;
        let voxels = backend.create("voxels", &pack(&inputs.volume, stored))?;
        let Some(bending) = &inputs.ior_volume else { return Ok(Self { voxels, ior_voxels: voxels }) };
        let uploaded = check_size(&upload_limit(bending, stored), "the second volume")
            .and_then(|()| Ok(backend.create("ior voxels", &pack(bending, stored))?));
        match uploaded {
            Ok(ior_voxels) => Ok(Self { voxels, ior_voxels }),
            Err(error) => {
                backend.free(voxels);
                Err(error)
            }
        }
    }

    /// Frees the buffers.
    pub fn free(self, backend: &mut dyn Backend) {
        backend.free(self.voxels);
        if self.ior_voxels != self.voxels {
            backend.free(self.ior_voxels);
        }
    }
}

/// Uploads what else a frame needs and lists its passes. Buffers are added to `created` as they are made.
pub(super) fn build(
    inputs: &Inputs,
    fixed: &Fixed,
    uploaded: Uploaded,
    backend: &mut dyn Backend,
    created: &mut Vec<Buffer>,
) -> Result<(PassList, Buffers), Error> {
    let mut upload = |label: &str, contents: &[u8]| -> Result<Buffer, BackendError> {
        let buffer = backend.create(label, contents)?;
        created.push(buffer);
        Ok(buffer)
    };
    let shown = &inputs.volume;
    let Uploaded { voxels, ior_voxels } = uploaded;
    let occupancy = match &inputs.ior_volume {
        None => classify(shown, &fixed.tables, fixed.reach[0], Role::Both),
        Some(bending) => {
            let mut occupancy = classify(shown, &fixed.tables, fixed.reach[0], Role::Shown);
            occupancy.extend(classify(bending, &fixed.tables, fixed.reach[1], Role::Bending));
            occupancy
        }
    };
    let occupancy = upload("occupancy", bytemuck::cast_slice(&occupancy))?;
    let tables = upload("tables", bytemuck::cast_slice(&fixed.tables.words))?;
    let map = upload("environment", bytemuck::cast_slice(&fixed.environment.map))?;

    let [across, up] = fixed.light_grid.size;
    let [width, height] = fixed.rays;
    let mut planar = |label: &str, records: [u32; 2], components: usize| -> Result<Buffer, BackendError> {
        let bytes = u64::from(records[0]) * u64::from(records[1]) * components as u64 * 4;
        let buffer = backend.create_zeroed(label, bytes)?;
        created.push(buffer);
        Ok(buffer)
    };
    let light = [planar("light", [across, up], light::SIZE)?, planar("light", [across, up], light::SIZE)?];
    let soft = planar("filtered light", if fixed.is_soft() { [across, up] } else { [1, 1] }, light::SIZE)?;
    let bright = planar("irradiance", [across, up], irradiance::SIZE)?;
    let traced = planar("back-traced points", [across, up], trace::SIZE)?;
    let rays = planar("rays", [width, height], ray::SIZE)?;
    let finished = planar("film", [width, height], film::SIZE)?;

    let pass = |kernel: &'static Kernel, size: [u32; 2], mode: u32, plane: u32, buffers: &[Buffer]| Pass {
        kernel,
        uniforms: bytemuck::bytes_of(&fixed.block(size[0], size[1], mode, plane)).to_vec(),
        buffers: buffers.to_vec(),
        width: size[0],
        height: size[1],
    };
    let readers = readers(fixed.format);
    let (texels, pixels) = ([across, up], [width, height]);
    let first = fixed.planes.first_visible;
    let mut passes = vec![
        pass(&kernels::sweep_initialize_light, texels, 0, 0, &[light[0]]),
        pass(&kernels::sweep_concentrate_light, texels, 0, 0, &[light[0], bright]),
        pass(&kernels::sweep_initialize_rays, pixels, 0, first, &[rays]),
    ];
    for plane in 1..fixed.planes.count {
        let (behind, ahead) = (light[(plane as usize + 1) % 2], light[plane as usize % 2]);
        // What light is followed into: the plane behind, filtered where the light is soft.
        let source = if fixed.is_soft() { soft } else { behind };
        if fixed.is_soft() {
            passes.push(pass(&kernels::sweep_filter_light, texels, 0, plane, &[behind, soft]));
        }
        passes.push(pass(&kernels::sweep_trace_light, texels, 0, plane, &[source, traced]));
        if plane > first {
            let bound = [voxels, ior_voxels, occupancy, tables, behind, bright, rays];
            passes.push(pass(readers.rays, pixels, fixed.mode, plane, &bound));
        }
        passes.push(pass(&kernels::sweep_gather_light, texels, 0, plane, &[source, traced, ahead]));
        if !fixed.planes.is_behind(plane) {
            let bound = [voxels, ior_voxels, occupancy, tables, traced, ahead];
            passes.push(pass(readers.light, texels, fixed.mode, plane, &bound));
        }
        passes.push(pass(&kernels::sweep_concentrate_light, texels, 0, plane, &[ahead, bright]));
    }
    passes.push(pass(&kernels::sweep_resolve, pixels, 0, fixed.planes.count - 1, &[rays, map, finished]));
    let name = |kernel: &Kernel| kernel.declaration.name;
    let list = PassList {
        passes,
        // Light goes on to the last plane: what is there is an output, too.
        while_busy: vec![name(readers.rays)],
        ends_with: Some(name(readers.rays)),
    };
    let buffers = Buffers { all: created.clone(), irradiance: bright, rays, film: finished };
    Ok((list, buffers))
}

/// Stored voxels are counted by a signed 32-bit number (words, or bytes of 8- and 16-bit voxels).
fn upload_limit(volume: &vitrum_io::Volume, stored: u32) -> (u64, u64) {
    let bytes = padded_bytes(volume, stored);
    let limit = match stored {
        format::U8 | format::U16 => i32::MAX as u64,
        _ => i32::MAX as u64 * 4,
    };
    (bytes, limit)
}

fn check_size(&(bytes, limit): &(u64, u64), what: &str) -> Result<(), Error> {
    if bytes > limit {
        return Err(Error::Scene(format!("{what} takes {bytes} bytes, the sweep can address {limit}")));
    }
    Ok(())
}

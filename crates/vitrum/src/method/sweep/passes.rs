//! The pass list of a frame (Algorithm 1).

use super::Buffers;
use super::carrier::{Carrier, Maker, Volumes};
use super::occupancy::{Ranges, Role, classify};
use super::sheets::Sheets;
use super::texels::Texels;
use super::uniforms::Fixed;
use super::unoccluded::Unoccluded;
use super::voxels::{chosen_format, pack, padded_bytes};
use crate::backend::{Backend, BackendError, Buffer, PassList};
use crate::inputs::Inputs;
use crate::render::Error;
use vitrum_kernels::abi::grid::format;
use vitrum_kernels::abi::record::{film, ray};
use vitrum_kernels::kernel::{Kernel, kernels};

/// The kernel that carries viewing rays through voxels of one format.
fn ray_kernel(stored: u32) -> &'static Kernel {
    match stored {
        format::U8 => &kernels::sweep_propagate_rays_u8,
        format::U16 => &kernels::sweep_propagate_rays_u16,
        format::F32 => &kernels::sweep_propagate_rays_f32,
        _ => &kernels::sweep_propagate_rays_f32_with_ior,
    }
}

/// A frame's voxels on a backend: what stays the same while scene and camera change.
#[derive(Debug)]
pub struct Uploaded {
    voxels: Buffer,
    /// The second volume's, or the same again.
    ior_voxels: Buffer,
    ranges: Ranges,
    /// The second volume's.
    ior_ranges: Option<Ranges>,
}

impl Uploaded {
    /// Packs the volumes and hands them to the backend.
    ///
    /// # Errors
    /// If a volume is too large for the sweep or for the backend.
    pub fn new(inputs: &Inputs, backend: &mut dyn Backend) -> Result<Self, Error> {
        let stored = chosen_format(&inputs.volume, inputs.ior_volume.as_ref());
        let voxels = upload(&inputs.volume, stored, "the volume", backend)?;
        let ranges = Ranges::new(&inputs.volume);
        let Some(bending) = &inputs.ior_volume else {
            return Ok(Self { voxels, ior_voxels: voxels, ranges, ior_ranges: None });
        };
        let uploaded = upload(bending, stored, "the second volume", backend);
        match uploaded {
            Ok(ior_voxels) => Ok(Self { voxels, ior_voxels, ranges, ior_ranges: Some(Ranges::new(bending)) }),
            Err(error) => {
                backend.free(voxels);
                Err(error)
            }
        }
    }

    /// Frees the buffers.
    pub fn free(&self, backend: &mut dyn Backend) {
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
    uploaded: &Uploaded,
    backend: &mut dyn Backend,
    created: &mut Vec<Buffer>,
) -> Result<(PassList, Buffers), Error> {
    let mut upload = |label: &str, contents: &[u8]| -> Result<Buffer, BackendError> {
        let buffer = backend.create(label, contents)?;
        created.push(buffer);
        Ok(buffer)
    };
    let shown = &inputs.volume;
    let Uploaded { voxels, ior_voxels, ref ranges, ref ior_ranges } = *uploaded;
    let occupancy = match inputs.ior_volume.as_ref().zip(ior_ranges.as_ref()) {
        None => classify(shown, ranges, &fixed.tables, fixed.reach[0], Role::Both),
        Some((bending, ior_ranges)) => {
            let mut occupancy = classify(shown, ranges, &fixed.tables, fixed.reach[0], Role::Shown);
            occupancy.extend(classify(bending, ior_ranges, &fixed.tables, fixed.reach[1], Role::Bending));
            occupancy
        }
    };
    let occupancy = upload("occupancy", bytemuck::cast_slice(&occupancy))?;
    let tables = upload("tables", bytemuck::cast_slice(&fixed.tables.words))?;
    let map = upload("environment", bytemuck::cast_slice(&fixed.environment.map))?;

    let volumes = Volumes { voxels, ior_voxels, occupancy, tables };
    let mut maker = Maker { fixed, backend, created };
    let light: Box<dyn Carrier> = match &fixed.sheets {
        _ if !fixed.shadows => Box::new(Unoccluded::new(&mut maker)?),
        None => Box::new(Texels::new(&mut maker, volumes)?),
        Some(sources) => Box::new(Sheets::new(&mut maker, volumes, sources)?),
    };
    let pixels = fixed.rays;
    let rays = maker.planar("rays", pixels, ray::SIZE)?;
    let finished = maker.planar("film", pixels, film::SIZE)?;

    let ray_kernel = ray_kernel(fixed.format);
    let first = fixed.planes.first_visible;
    let mut passes = light.start(fixed);
    passes.push(fixed.pass(&kernels::sweep_initialize_rays, pixels, 0, first, &[rays]));
    for plane in 1..fixed.planes.count {
        if plane > first {
            let [behind, bright] = light.on_plane(plane - 1);
            let bound = [voxels, ior_voxels, occupancy, tables, behind, bright, rays];
            passes.push(fixed.pass(ray_kernel, pixels, fixed.mode, plane, &bound));
        }
        light.advance(fixed, plane, &mut passes);
    }
    let last = fixed.planes.count - 1;
    passes.push(fixed.pass(&kernels::sweep_resolve, pixels, 0, last, &[rays, map, finished]));
    let name = ray_kernel.declaration.name;
    // Light goes on to the last plane: what is there is an output, too.
    let list = PassList { passes, while_busy: vec![name], ends_with: Some(name) };
    let [_, irradiance] = light.on_plane(last);
    let buffers = Buffers { all: maker.created.clone(), irradiance, rays, film: finished };
    Ok((list, buffers))
}

/// Packs a volume into a buffer.
fn upload(volume: &vitrum_io::Volume, stored: u32, what: &str, backend: &mut dyn Backend) -> Result<Buffer, Error> {
    let (bytes, limit) = upload_limit(volume, stored);
    check_size(&(bytes, limit), what)?;
    Ok(backend.create_with("voxels", bytes, &mut |packed| pack(volume, stored, packed))?)
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

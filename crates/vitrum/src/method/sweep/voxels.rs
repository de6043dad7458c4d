//! Volumes as kernels read them: the voxels as they were read from the file, x fastest, in words.

use super::crop::Extent;
use super::transfer::window::Window;
use crate::backend::{Backend, BackendError, Buffer, Contents};
use crate::method::view::{View, vector, voxel_steps};
use crate::subject::Volumes;
use bytemuck::cast_slice_mut;
use glam::DVec3;
use rayon::prelude::*;
use vitrum_io::{Volume, Voxels};
use vitrum_kernels::abi::format::{Format, page};
use vitrum_kernels::abi::grid::Grid;
use vitrum_kernels::abi::vector::{Affine, Counts, Vec3};

/// The format in which a volume is stored on the device, and with which kernels read it. Floats with colours or bodies have been made 16 bits wide
/// before ([`crate::shown`]); colours of others do not count.
pub(super) fn chosen_format(volumes: Volumes<'_>) -> Format {
    let shown = volumes.shown;
    match (&shown.voxels, volumes.ior) {
        (_, Some(_)) => Format::F32WithIor,
        (_, None) if volumes.bodies.is_some() => Format::U16WithBodies,
        (Voxels::U8(_) | Voxels::U16(_), None) if shown.colors.is_some() => Format::U16WithColor,
        (Voxels::U8(_), None) => Format::U8,
        (Voxels::U16(_), None) => Format::U16,
        (Voxels::F32(_), None) => Format::F32,
    }
}

/// Bytes of a volume in the format `stored`.
pub(super) fn bytes(volume: &Volume, stored: Format) -> u64 {
    volume.grid_count() * stored.bytes()
}

/// Whether each of `volumes` fits the backend in one piece.
pub(super) fn fit(volumes: Volumes<'_>, stored: Format, backend: &dyn Backend) -> bool {
    if is_paged(volumes) {
        return false;
    }
    // Stored voxels are counted by a signed 32-bit number, and a few are read at once.
    let most = backend.largest_buffer().min((i32::MAX as u64 - 8) * stored.bytes());
    let words = [volumes.shown.colors.as_ref(), volumes.bodies.and_then(|bodies| bodies.colors.as_ref())];
    let words = words.into_iter().flatten().map(|words| words.len() as u64 * 4);
    let read = std::iter::once(volumes.shown).chain(volumes.ior);
    let sizes = read.map(|volume| bytes(volume, stored)).chain(words);
    sizes.clone().all(|size| size <= most) && sizes.sum::<u64>() <= backend.volume_limit()
}

/// Whether the voxels of one of the volumes stay in their file.
pub(super) fn is_paged(volumes: Volumes<'_>) -> bool {
    volumes.iter().any(|volume| volume.paged.is_some())
}

/// Uploads a volume in one piece. The CPU backend reads the volume's own memory, unless its voxels have to be converted to floats.
pub(super) fn upload(volume: &Volume, stored: Format, backend: &mut dyn Backend) -> Result<Buffer, BackendError> {
    Ok(match (&volume.voxels, stored) {
        (Voxels::U8(voxels), Format::F32WithIor) => floats(voxels, backend)?,
        (Voxels::U16(voxels), Format::F32WithIor) => floats(voxels, backend)?,
        (Voxels::U8(voxels), Format::U16WithColor | Format::U16WithBodies) => wider(voxels, backend)?,
        (voxels, _) => backend.create("voxels", Contents::Shared(&voxels.words()))?,
    })
}

fn floats<T: Copy + Sync>(voxels: &[T], backend: &mut dyn Backend) -> Result<Buffer, BackendError>
where
    f32: From<T>,
{
    let mut convert = |words: &mut [u32]| {
        let floats: &mut [f32] = cast_slice_mut(words);
        floats.par_iter_mut().zip(voxels).for_each(|(float, &voxel)| *float = f32::from(voxel));
    };
    backend.create("voxels", Contents::Written(voxels.len() as u64 * 4, &mut convert))
}

/// Bytes as integers of 16 bits.
fn wider(voxels: &[u8], backend: &mut dyn Backend) -> Result<Buffer, BackendError> {
    let mut convert = |words: &mut [u32]| {
        let halves: &mut [u16] = cast_slice_mut(words);
        halves.par_iter_mut().zip(voxels).for_each(|(half, &voxel)| *half = voxel.into());
    };
    // Four bytes are read from each voxel on.
    backend.create("voxels", Contents::Written((voxels.len() as u64 * 2).next_multiple_of(4) + 4, &mut convert))
}

/// log₂ of the edge of a volume's bricks.
pub(super) fn brick_shift(volume: &Volume) -> u32 {
    vitrum_io::brick_shift(volume.dimensions)
}

/// Bricks along each axis.
pub(super) fn bricks(volume: &Volume) -> [u32; 3] {
    let shift = brick_shift(volume);
    volume.dimensions.map(|n| n.div_ceil(1 << shift))
}

/// Pages of a streamed volume along each axis.
pub(super) fn pages(dimensions: [u32; 3]) -> [u32; 3] {
    dimensions.map(|n| (n >> page::SHIFT) + 1)
}

/// The voxel coordinates of a point of the view frame, as affine functions of it.
pub(super) fn rows(volume: &Volume, view: &View) -> [Affine; 3] {
    let inverse = voxel_steps(volume).inverse();
    let along = inverse * view.axes;
    let start = inverse * (view.eye - vector(volume.origin));
    [0, 1, 2].map(|axis| {
        let row: DVec3 = along.row(axis);
        Affine::from(row.as_vec3().extend(start[axis] as f32))
    })
}

/// The grid of a volume in the view frame, as kernels read it. `window` is that of its normalised scalars, `reach` the step in voxels that a brick's range covers, `first_brick`
/// the index of the first brick in the occupancy buffer; `extent` is the part of the volume that is there.
pub(super) fn grid(
    volume: &Volume,
    window: Window,
    stored: Format,
    view: &View,
    extent: Extent,
    (reach, first_brick): (u32, u32),
) -> Grid {
    let [row_x, row_y, row_z] = rows(volume, view);
    let [width, height, depth] = volume.dimensions;
    let [value_origin, value_scale] = window.of_stored(volume);
    let [bx, by, bz] = bricks(volume);
    let [px, py, pz] = pages(volume.dimensions);
    let [row_pitch, slice_pitch] = if stored.is_paged() {
        [page::ROW, page::SLICE]
    } else {
        // A slice of a volume that can be addressed is no longer than that.
        [width as i32, width.wrapping_mul(height) as i32]
    };
    Grid {
        row_x,
        row_y,
        row_z,
        size: Vec3::new(width as f32, height as f32, depth as f32),
        low: extent.low.as_vec3().into(),
        high: extent.high.as_vec3().into(),
        reach: reach as f32,
        value_scale,
        value_origin,
        row_pitch,
        slice_pitch,
        bricks: Counts::new(bx, by, bz),
        first_brick,
        pages: Counts::new(px, py, pz),
        brick_shift: brick_shift(volume),
        nearest: 0,
    }
}

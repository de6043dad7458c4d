//! Volumes as kernels read them: padded, packed into words.

use super::view::{View, vector, voxel_steps};
use glam::{DVec3, IVec4};
use rayon::prelude::*;
use vitrum_io::{Volume, Voxels};
use vitrum_kernels::abi::grid::{BRICK_SHIFT, Grid, PADDING, format};
use vitrum_kernels::abi::vector::Vec4;

/// How a volume is stored, and whether a second one gives η.
pub(super) fn chosen_format(shown: &Volume, ior: Option<&Volume>) -> u32 {
    match (&shown.voxels, ior) {
        (_, Some(_)) => format::F32_WITH_IOR,
        (Voxels::U8(_), None) => format::U8,
        (Voxels::U16(_), None) => format::U16,
        (Voxels::F32(_), None) => format::F32,
    }
}

/// Voxels with padding along each axis.
pub(super) fn padded(volume: &Volume) -> [usize; 3] {
    volume.dimensions.map(|n| n as usize + 2 * PADDING as usize)
}

/// Bytes of the padded volume in `stored` format, whole words.
pub(super) fn padded_bytes(volume: &Volume, stored: u32) -> u64 {
    let voxels: u64 = padded(volume).iter().map(|&n| n as u64).product();
    let size = match stored {
        format::U8 => 1,
        format::U16 => 2,
        _ => 4,
    };
    (voxels * size).next_multiple_of(4)
}

/// Writes the voxels with [`PADDING`] copies of the nearest voxel on every side to `packed`, which has [`padded_bytes`], as
/// little-endian bytes.
pub(super) fn pack(volume: &Volume, stored: u32, packed: &mut [u8]) {
    match (&volume.voxels, stored) {
        (Voxels::U8(voxels), format::U8) => pad(volume, voxels, packed, u8::to_le_bytes),
        (Voxels::U16(voxels), format::U16) => pad(volume, voxels, packed, u16::to_le_bytes),
        (Voxels::U8(voxels), _) => pad(volume, voxels, packed, |voxel| f32::from(voxel).to_le_bytes()),
        (Voxels::U16(voxels), _) => pad(volume, voxels, packed, |voxel| f32::from(voxel).to_le_bytes()),
        (Voxels::F32(voxels), _) => pad(volume, voxels, packed, f32::to_le_bytes),
    }
}

fn pad<T: Copy + Sync, const BYTES: usize>(
    volume: &Volume,
    voxels: &[T],
    packed: &mut [u8],
    bytes: impl Fn(T) -> [u8; BYTES] + Sync,
) {
    let [nx, ny, nz] = volume.dimensions.map(|n| n as usize);
    let [px, py, pz] = padded(volume);
    let padding = PADDING as usize;
    let limit = |i: usize, n: usize| i.saturating_sub(padding).min(n - 1);
    packed[..px * py * pz * BYTES].par_chunks_exact_mut(px * BYTES).enumerate().for_each(|(row, to)| {
        let from = &voxels[(limit(row / py, nz) * ny + limit(row % py, ny)) * nx..][..nx];
        let (before, rest) = to.split_at_mut(padding * BYTES);
        let (within, after) = rest.split_at_mut(nx * BYTES);
        for (to, &voxel) in within.chunks_exact_mut(BYTES).zip(from) {
            to.copy_from_slice(&bytes(voxel));
        }
        let ends = [(before, from[0]), (after, from[nx - 1])];
        for (margin, voxel) in ends {
            for to in margin.chunks_exact_mut(BYTES) {
                to.copy_from_slice(&bytes(voxel));
            }
        }
    });
}

/// Bricks along each axis.
pub(super) fn bricks(volume: &Volume) -> [u32; 3] {
    volume.dimensions.map(|n| n.div_ceil(1 << BRICK_SHIFT))
}

/// Where a volume lies in the sweep frame. `reach` is the step in voxels that a brick's range covers, `first_brick` where its
/// bricks start in the occupancy buffer.
pub(super) fn grid(volume: &Volume, view: &View, reach: u32, first_brick: u32) -> Grid {
    let inverse = voxel_steps(volume).inverse();
    let along = inverse * view.axes;
    let start = inverse * (view.eye - vector(volume.origin));
    let row = |axis: usize| {
        let row: DVec3 = along.row(axis);
        Vec4::from(row.as_vec3().extend(start[axis] as f32))
    };
    let [px, py, _] = padded(volume).map(|n| n as i32);
    let slice = px * py;
    let scale = f64::from(volume.range[1]) - f64::from(volume.range[0]);
    let inverse_scale = if scale > 0.0 { 1.0 / scale } else { 0.0 };
    let [bx, by, bz] = bricks(volume).map(|n| n as i32);
    Grid {
        row_x: row(0),
        row_y: row(1),
        row_z: row(2),
        size: Vec4::new(
            volume.dimensions[0] as f32,
            volume.dimensions[1] as f32,
            volume.dimensions[2] as f32,
            reach as f32,
        ),
        value: Vec4::new(
            (f64::from(volume.value_scale) * inverse_scale) as f32,
            ((f64::from(volume.value_offset) - f64::from(volume.range[0])) * inverse_scale) as f32,
            0.0,
            0.0,
        ),
        pitch: IVec4::new(px, slice, PADDING * (1 + px + slice), 0),
        bricks: IVec4::new(bx, by, bz, first_brick as i32),
    }
}

//! Which bricks are empty: neither opacity, nor medium, nor a change of η.

use super::tables::Tables;
use super::voxels::bricks;
use rayon::prelude::*;
use vitrum_io::Volume;
use vitrum_kernels::abi::grid::BRICK_SHIFT;

/// What a volume is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// It is shown, and bends.
    Both,
    /// It is shown; another one bends.
    Shown,
    /// It bends.
    Bending,
}

/// 1 for each brick in which something may happen, else 0, x fastest. A brick's range is that of its voxels and those up to
/// `reach` + 2 beyond: a step of `reach`, and the stencil.
pub(super) fn classify(volume: &Volume, tables: &Tables, reach: u32, role: Role) -> Vec<u32> {
    let [bx, by, bz] = bricks(volume).map(|n| n as usize);
    let scale = volume.range[1] - volume.range[0];
    let normalise = |value: f32| {
        if scale > 0.0 { ((value - volume.range[0]) / scale).clamp(0.0, 1.0) } else { 0.0 }
    };
    (0..bx * by * bz)
        .into_par_iter()
        .map(|index| {
            let brick = [index % bx, index / bx % by, index / (bx * by)];
            let (low, high) = range(volume, brick, reach as usize + 2);
            // A little wider: kernels normalise in single precision.
            let (low, high) = (normalise(low) - 1e-5, normalise(high) + 1e-5);
            let clear = role == Role::Bending || tables.is_clear(low, high);
            let uniform = role == Role::Shown || tables.is_uniform(low, high);
            u32::from(!(clear && uniform))
        })
        .collect()
}

/// The physical range of a brick's voxels and those up to `beyond` around it.
fn range(volume: &Volume, brick: [usize; 3], beyond: usize) -> (f32, f32) {
    let ends: [(usize, usize); 3] = std::array::from_fn(|axis| {
        let first = brick[axis] << BRICK_SHIFT;
        let last = first + (1 << BRICK_SHIFT) - 1 + beyond;
        (first.saturating_sub(beyond), last.min(volume.dimensions[axis] as usize - 1))
    });
    let mut low = f32::INFINITY;
    let mut high = f32::NEG_INFINITY;
    for z in ends[2].0..=ends[2].1 {
        for y in ends[1].0..=ends[1].1 {
            for x in ends[0].0..=ends[0].1 {
                let value = volume.value(x as u32, y as u32, z as u32);
                low = low.min(value);
                high = high.max(value);
            }
        }
    }
    (low, high)
}

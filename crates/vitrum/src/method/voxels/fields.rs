//! Smoothing of a distance field, so that its gradient follows the surface and not the single triangles.

use rayon::prelude::*;

/// Weights of a voxel and its neighbours, in 1 / 4096: a bell whose variance is one voxel's edge squared. It leaves planes as they are.
const WEIGHTS: [u64; 5] = [256, 1024, 1536, 1024, 256];

/// The weighted sum along one axis, at index `at` of `count`; a voxel beyond the ends has the value of the one at the end.
fn sum(row: impl Fn(usize) -> u64, at: usize, count: usize) -> u64 {
    let sample = |k: usize| row((at + k).saturating_sub(2).min(count - 1));
    WEIGHTS.iter().enumerate().map(|(k, weight)| weight * sample(k)).sum()
}

/// The field, filtered along each axis, in integers: the result is the same on every machine.
pub(super) fn smooth(field: &[u16], [nx, ny, nz]: [usize; 3]) -> Vec<u16> {
    let layer = nx * ny;
    let rounded = |sum: u64| ((sum + 2048) >> 12) as u16;
    let mut along_x = vec![0u16; field.len()];
    along_x.par_chunks_mut(nx).zip(field.par_chunks(nx)).for_each(|(to, from)| {
        for (x, to) in to.iter_mut().enumerate() {
            *to = rounded(sum(|x| u64::from(from[x]), x, nx));
        }
    });
    let mut along_y = vec![0u16; field.len()];
    along_y.par_chunks_mut(layer).zip(along_x.par_chunks(layer)).for_each(|(to, from)| {
        for (at, to) in to.iter_mut().enumerate() {
            let (x, y) = (at % nx, at / nx);
            *to = rounded(sum(|y| u64::from(from[y * nx + x]), y, ny));
        }
    });
    let mut smooth = along_x;
    smooth.par_chunks_mut(layer).enumerate().for_each(|(z, to)| {
        for (at, to) in to.iter_mut().enumerate() {
            *to = rounded(sum(|z| u64::from(along_y[z * layer + at]), z, nz));
        }
    });
    smooth
}

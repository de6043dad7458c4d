//! Bricks of voxels, with the distances to the nearest brick that a surface may cross.

use crate::method::brick_distances::spread;
use rayon::prelude::*;
use vitrum_kernels::abi::voxels::BRICK_SHIFT;

/// The value of a field at the surface.
const LEVEL: u16 = 32767;

/// Bricks along each axis.
pub(super) fn count(dimensions: [u32; 3]) -> [u32; 3] {
    dimensions.map(|voxels| voxels.div_ceil(1 << BRICK_SHIFT))
}

/// The Chebyshev distance of each brick to the nearest brick that a surface may cross, in bricks; 0 for such a brick itself. A brick
/// reaches to the first samples of the next ones.
pub(super) fn distances(fields: &[u16], dimensions: [u32; 3]) -> Vec<u32> {
    let [bx, by, bz] = count(dimensions).map(|bricks| bricks as usize);
    let [nx, ny, nz] = dimensions.map(|voxels| voxels as usize);
    let edge = 1 << BRICK_SHIFT;
    let far = (bx + by + bz) as u32;
    let mut distances: Vec<u32> = (0..bx * by * bz)
        .into_par_iter()
        .map(|brick| {
            let low = [brick % bx * edge, brick / bx % by * edge, brick / (bx * by) * edge];
            let range = |axis: usize, count: usize| low[axis]..(low[axis] + edge + 1).min(count);
            let is_crossed = |field: &[u16]| {
                let first = field[(low[2] * ny + low[1]) * nx + low[0]] > LEVEL;
                range(2, nz).any(|z| {
                    range(1, ny).any(|y| range(0, nx).any(|x| (field[(z * ny + y) * nx + x] > LEVEL) != first))
                })
            };
            if fields.chunks(nx * ny * nz).any(is_crossed) { 0 } else { far }
        })
        .collect();
    spread(&mut distances, [bx, by, bz]);
    distances
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_a_search_of_all() {
        let dimensions = [40u32, 29, 33];
        let [nx, ny, nz] = dimensions.map(|n| n as usize);
        let mut field = vec![0; nx * ny * nz];
        for at in [0, 12_345, 30_000, nx * ny * nz - 1] {
            field[at] = 65535;
        }
        let found = distances(&field, dimensions);
        let [bx, by, bz] = count(dimensions).map(i64::from);
        let place = |at: i64| [at % bx, at / bx % by, at / (bx * by)];
        let crossed: Vec<[i64; 3]> = (0..bx * by * bz).filter(|&at| found[at as usize] == 0).map(place).collect();
        assert!(crossed.len() >= 4 && crossed.len() < 40);
        for at in 0..bx * by * bz {
            let here = place(at);
            let away = |other: &[i64; 3]| (0..3).map(|axis| (here[axis] - other[axis]).abs()).max().unwrap_or(0);
            let expected = crossed.iter().map(away).min().unwrap_or(0);
            assert_eq!(i64::from(found[at as usize]), expected, "{here:?}");
        }
    }
}

//! Columns of the grid along x, and the triangles that they may go through.

use super::items::Slices;
use rayon::prelude::*;

/// log₂ of the units of a voxel: of each a winding may have so many that `triangles` of them, the most a winding can be, stay below
/// 2³⁰. Sums of windings may wrap on their way there, which does no harm.
pub(in crate::method) fn scale(triangles: usize) -> u32 {
    30 - (usize::BITS - triangles.leading_zeros()).clamp(14, 30)
}

/// For each triangle, the rows of columns of a slab that may cross it: `first` is the slab's first layer, `layers` its number of
/// layers; 2^`columns` columns cross a voxel.
pub(in crate::method) fn slices(corners: &[[[f32; 3]; 3]], columns: u32, [first, layers]: [u32; 2]) -> Vec<Slices> {
    let a_voxel = f32::from(1u16 << columns);
    let [begin, end] = [first << columns, (first + layers) << columns];
    let rows = |[a, b, c]: &[[f32; 3]; 3]| {
        let bounds =
            |axis: usize| [a[axis].min(b[axis]).min(c[axis]) * a_voxel, a[axis].max(b[axis]).max(c[axis]) * a_voxel];
        // Rows z with low ≤ z + ½ < high: one more on either side does no harm.
        let row = |z: f32| (z.floor().max(0.0) as u32).clamp(begin, end);
        let [low, high] = bounds(2);
        let [left, right] = bounds(1);
        let (low, high) = (row(low - 0.5), row(high + 0.5));
        Slices { first: low, count: high - low, rows: (right - left) as u32 + 1 }
    };
    corners.par_iter().map(rows).collect()
}

#[cfg(test)]
mod tests {
    use super::scale;

    #[test]
    fn no_winding_has_more_than_30_bits() {
        for triangles in [1, 12, 16383, 16384, 202_520, 1 << 20, (1 << 27) + 1] {
            let scale = scale(triangles);
            assert!(scale <= 16 && (triangles as u64) << scale <= 1 << 30, "{triangles}: {scale}");
        }
        assert_eq!(scale(1 << 31), 0);
    }
}

//! Fields of materials, cropped to the box in which they are not 0, so that several fit into one buffer.

use rayon::prelude::*;
use std::ops::Range;
use vitrum_kernels::abi::voxels::field;

/// Cropped fields, one after the other on a grid, in the layout that [`field`] describes. Linear interpolation gives the same values as
/// in the whole field: where they are not 0, both samples of each pair are in the box.
pub(super) fn cropped(fields: &[u16], dimensions: [u32; 3]) -> Vec<u32> {
    let [nx, ny, nz] = dimensions.map(|voxels| voxels as usize);
    let count = fields.len() / (nx * ny * nz);
    let boxes: Vec<[Range<usize>; 3]> =
        fields.chunks_exact(nx * ny * nz).map(|field| around(field, [nx, ny, nz])).collect();
    let mut words = Vec::with_capacity(count * field::SIZE);
    // Two samples a word.
    let mut first = 2 * count * field::SIZE;
    for bounds in &boxes {
        words.push(first as u32);
        words.extend(bounds.iter().map(|range| range.start as u32 | (range.len() as u32) << 16));
        first += bounds.iter().map(Range::len).product::<usize>();
    }
    // Whole words, and one more for the pair of the last sample.
    words.resize(first.div_ceil(2) + 1, 0);
    let samples: &mut [u16] = bytemuck::cast_slice_mut(&mut words[count * field::SIZE..]);
    let mut rest = samples;
    for (field, [along_x, along_y, along_z]) in fields.chunks_exact(nx * ny * nz).zip(boxes) {
        let layer = along_x.len() * along_y.len();
        let (samples, behind) = rest.split_at_mut(layer * along_z.len());
        rest = behind;
        if layer > 0 {
            samples.par_chunks_exact_mut(layer).zip(along_z).for_each(|(to, z)| {
                for (to, y) in to.chunks_exact_mut(along_x.len()).zip(along_y.clone()) {
                    to.copy_from_slice(&field[(z * ny + y) * nx..][along_x.clone()]);
                }
            });
        }
    }
    words
}

/// The box of all samples that are not 0 and of their neighbours; empty if all are 0.
fn around(field: &[u16], [nx, ny, nz]: [usize; 3]) -> [Range<usize>; 3] {
    // Least and greatest index along each axis.
    let nothing = [(usize::MAX, 0); 3];
    let both = |one: [(usize, usize); 3], other: [(usize, usize); 3]| {
        [0, 1, 2].map(|axis| (one[axis].0.min(other[axis].0), one[axis].1.max(other[axis].1)))
    };
    let of_row = |(row, samples): (usize, &[u16])| {
        let first = samples.iter().position(|&sample| sample != 0)?;
        let last = samples.iter().rposition(|&sample| sample != 0)?;
        Some([(first, last), (row % ny, row % ny), (row / ny, row / ny)])
    };
    let found = field.par_chunks_exact(nx).enumerate().filter_map(of_row).reduce(|| nothing, both);
    let range = |(least, greatest): (usize, usize), count: usize| {
        if least > greatest { 0..0 } else { least.saturating_sub(1)..(greatest + 2).min(count) }
    };
    [range(found[0], nx), range(found[1], ny), range(found[2], nz)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reads a sample as the kernel does; 0 outside of the box.
    fn sample(words: &[u32], number: usize, at: [usize; 3]) -> u16 {
        let entry = &words[number * field::SIZE..];
        let bounds = [0, 1, 2].map(|axis| entry[field::BOX + axis]);
        let inside = [0, 1, 2].map(|axis| at[axis].checked_sub((bounds[axis] & 0xffff) as usize));
        let size = bounds.map(|word| (word >> 16) as usize);
        match inside {
            [Some(x), Some(y), Some(z)] if x < size[0] && y < size[1] && z < size[2] => {
                let at = entry[field::FIRST] as usize + (z * size[1] + y) * size[0] + x;
                (words[at / 2] >> (at % 2 * 16)) as u16
            }
            _ => 0,
        }
    }

    #[test]
    fn every_sample_is_where_it_was() {
        let dimensions = [13u32, 7, 9];
        let [nx, ny, nz] = dimensions.map(|voxels| voxels as usize);
        let mut fields = vec![0u16; 3 * nx * ny * nz];
        // The first field has a box, the second nothing, the third reaches the grid's corners.
        for (at, value) in [(3 * ny * nx + 2 * nx + 4, 7), (5 * ny * nx + 4 * nx + 6, 65535)] {
            fields[at] = value;
        }
        let last = fields.len() - 1;
        (fields[2 * nx * ny * nz], fields[last]) = (1, 2);
        let words = cropped(&fields, dimensions);
        for (number, field) in fields.chunks(nx * ny * nz).enumerate() {
            for (at, &value) in field.iter().enumerate() {
                let place = [at % nx, at / nx % ny, at / (nx * ny)];
                assert_eq!(sample(&words, number, place), value, "{number} {place:?}");
            }
        }
        // A box of 5 x 5 x 5, nothing, the whole grid.
        assert_eq!(words.len(), 3 * field::SIZE + (125 + nx * ny * nz).div_ceil(2) + 1);
    }

    #[test]
    fn neighbours_of_what_is_not_zero_are_in_the_box() {
        let mut fields = vec![0u16; 6 * 6 * 6];
        fields[2 * 36 + 3 * 6 + 1] = 9;
        assert_eq!(around(&fields, [6, 6, 6]), [0..3, 2..5, 1..4]);
        assert_eq!(around(&vec![0; 216], [6, 6, 6]), [0..0, 0..0, 0..0]);
    }
}

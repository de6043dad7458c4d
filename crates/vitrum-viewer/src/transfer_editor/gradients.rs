//! The histogram over value and gradient, in which surfaces between two kinds of matter are arcs (Kindlmann & Durkin 1998).

use vitrum::io::Volume;
use vitrum::preset::GradientMagnitudes;

/// The number of voxels by their value and by the magnitude of the scalar's gradient.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradients {
    /// The range of values: the volume's, outliers left out.
    pub range: [f32; 2],
    /// Counts, the columns of a row of equal gradient after one another.
    counts: Vec<u32>,
}

impl Gradients {
    /// Steps of value, and steps of gradient.
    pub const BINS: [usize; 2] = [128, 32];

    /// At most about this many voxels are counted, evenly spread.
    const MOST: usize = 1 << 20;

    /// Counts the voxels of a volume.
    #[must_use]
    pub fn of(volume: &Volume) -> Self {
        let range = volume.common_range();
        let [columns, rows] = Self::BINS;
        let mut stride = 1;
        while volume.voxel_count() / (stride * stride * stride) > Self::MOST {
            stride += 1;
        }
        let mut samples = Vec::new();
        let magnitudes = GradientMagnitudes::new(volume);
        let [width, height, depth] = volume.dimensions.map(|size| size as usize);
        for z in (0..depth).step_by(stride) {
            for y in (0..height).step_by(stride) {
                for x in (0..width).step_by(stride) {
                    samples.push((magnitudes.value([x, y, z]), magnitudes.at([x, y, z])));
                }
            }
        }
        // Some outliers have gradients far beyond all others.
        let mut sorted: Vec<f32> = samples.iter().map(|sample| sample.1).collect();
        sorted.sort_unstable_by(f32::total_cmp);
        let steepest = sorted.get(sorted.len().saturating_sub(1 + sorted.len() / 1000)).copied().unwrap_or(0.0);
        let mut counts = vec![0; columns * rows];
        for (value, gradient) in samples {
            let column = (value - range[0]) / (range[1] - range[0]) * columns as f32;
            // Most gradients are small: the root parts them.
            let row = (gradient / steepest).sqrt() * rows as f32;
            let is_inside = (0.0..=columns as f32).contains(&column) && row.is_finite();
            let index = (row as usize).min(rows - 1) * columns + (column as usize).min(columns - 1);
            if is_inside && let Some(count) = counts.get_mut(index) {
                *count += 1;
            }
        }
        Self { range, counts }
    }

    /// The steps that hold voxels: column, row, and the logarithm of the number of voxels as a share of the greatest.
    pub fn cells(&self) -> impl Iterator<Item = (usize, usize, f32)> + '_ {
        let logarithm = |count: u32| libm::log1p(f64::from(count));
        let greatest = logarithm(self.counts.iter().copied().max().unwrap_or(0));
        let filled = self.counts.iter().enumerate().filter(|(_, count)| **count > 0);
        let [columns, _] = Self::BINS;
        filled.map(move |(index, &count)| (index % columns, index / columns, (logarithm(count) / greatest) as f32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum::io::Voxels;

    fn cells(voxels: Vec<f32>) -> Vec<(usize, usize, f32)> {
        let volume = Volume::new("test", [16; 3], [1.0; 3], Voxels::from(voxels)).expect("a volume");
        Gradients::of(&volume).cells().collect()
    }

    #[test]
    fn matter_is_flat_and_its_surface_steep_in_the_middle() {
        // Two halves with a soft border between them.
        let value = |index: usize| ((index % 16) as f32 - 6.0).clamp(0.0, 4.0);
        let cells = cells((0..4096).map(value).collect());
        let [columns, rows] = Gradients::BINS;
        let in_row = |row: usize| cells.iter().filter(|cell| cell.1 == row).map(|cell| cell.0).collect::<Vec<_>>();
        assert_eq!(in_row(0), [0, columns - 1]);
        assert!(in_row(rows - 1).iter().all(|column| (columns / 5..columns * 4 / 5).contains(column)), "{cells:?}");
    }

    #[test]
    fn volumes_of_one_value_and_of_one_plane_are_counted() {
        assert!(cells(vec![3.0; 4096]).iter().all(|cell| cell.2.is_finite()));
        let flat = Volume::new("flat", [4, 4, 1], [1.0; 3], Voxels::from(vec![1_u8; 16])).expect("a volume");
        assert_eq!(Gradients::of(&flat).range.len(), 2);
    }
}

//! Thresholds and quantiles of a volume's values.

use std::ops::Range;
use vitrum_io::Volume;

/// A histogram of a volume's values: the number of voxels in each of many equal steps of its range without outliers.
pub(super) struct Histogram {
    counts: Vec<u64>,
    /// The range of the bins: outliers count to the first and the last.
    pub range: [f32; 2],
    /// Values per bin.
    step: f32,
}

impl Histogram {
    /// Fine enough for 16-bit samples, and for floats whose interesting part is a hundredth of their range.
    const BINS: usize = 1 << 16;

    /// `None` where all values are equal.
    pub fn of(volume: &Volume) -> Option<Self> {
        let range = volume.common_range();
        let step = (range[1] - range[0]) / Self::BINS as f32;
        let counts = volume.histogram_over(range, Self::BINS);
        (step.is_normal() && step > 0.0).then_some(Self { counts, range, step })
    }

    /// The range of all bins.
    pub fn all(&self) -> Range<usize> {
        0..self.counts.len()
    }

    /// The value at the lower edge of a bin.
    pub fn value(&self, bin: usize) -> f32 {
        self.range[0] + bin as f32 * self.step
    }

    /// The bin of a value, the number of bins for one above all.
    pub fn bin(&self, value: f32) -> usize {
        // The cast saturates.
        (((value - self.range[0]) / self.step).ceil() as usize).min(self.counts.len())
    }

    /// Number of voxels in `bins`.
    pub fn total(&self, bins: Range<usize>) -> u64 {
        self.counts[bins].iter().sum()
    }

    /// The bin within `bins` below which the given share of their voxels lies.
    pub fn quantile(&self, bins: Range<usize>, share: f64) -> usize {
        let wanted = share * self.total(bins.clone()) as f64;
        let mut below = 0;
        for bin in bins.clone() {
            below += self.counts[bin];
            if below as f64 >= wanted {
                return bin;
            }
        }
        bins.end.saturating_sub(1)
    }

    /// Otsu's threshold within `bins`: the first bin of the upper of two classes that differ most.
    ///
    /// Where a gap of empty bins parts the classes, the threshold is in its middle. `None` where fewer than two bins
    /// are occupied.
    pub fn otsu(&self, bins: Range<usize>) -> Option<usize> {
        let total = self.total(bins.clone()) as f64;
        let weighted = |bin: usize| bin as f64 * self.counts[bin] as f64;
        let sum: f64 = bins.clone().map(weighted).sum();
        let (mut below, mut sum_below) = (0.0, 0.0);
        // The first and the last threshold at which the variance between the classes is the greatest.
        let mut best: Option<(f64, usize, usize)> = None;
        for bin in bins {
            if self.counts[bin] == 0
                && let Some((_, _, last)) = &mut best
                && *last == bin
            {
                *last = bin + 1;
                continue;
            }
            below += self.counts[bin] as f64;
            sum_below += weighted(bin);
            let above = total - below;
            if below == 0.0 || above == 0.0 {
                continue;
            }
            let difference = sum_below / below - (sum - sum_below) / above;
            let variance = below * above * (difference * difference);
            if best.is_none_or(|(greatest, ..)| variance > greatest) {
                best = Some((variance, bin + 1, bin + 1));
            }
        }
        best.map(|(_, first, last)| first.midpoint(last))
    }
}

#[cfg(test)]
mod tests {
    use super::Histogram;

    fn histogram(counts: &[u64]) -> Histogram {
        Histogram { counts: counts.to_vec(), range: [0.0, counts.len() as f32], step: 1.0 }
    }

    #[test]
    fn otsu_parts_two_peaks_in_the_middle_of_their_gap() {
        assert_eq!(histogram(&[9, 1, 0, 0, 0, 0, 2, 5]).otsu(0..8), Some(4));
        assert_eq!(histogram(&[5, 0, 0, 0, 0, 0, 0, 5]).otsu(0..8), Some(4));
        assert_eq!(histogram(&[5, 5]).otsu(0..2), Some(1));
    }

    #[test]
    fn one_value_has_no_threshold() {
        assert_eq!(histogram(&[0, 7, 0]).otsu(0..3), None);
        assert_eq!(histogram(&[0, 0]).otsu(0..2), None);
        assert_eq!(histogram(&[1, 2]).otsu(1..1), None);
    }

    #[test]
    fn quantiles_are_counted_within_the_bins_asked_for() {
        let histogram = histogram(&[90, 4, 4, 2]);
        assert_eq!(histogram.quantile(0..4, 0.5), 0);
        assert_eq!(histogram.quantile(1..4, 0.5), 2);
        assert_eq!(histogram.quantile(1..4, 1.0), 3);
        assert_eq!(histogram.quantile(2..2, 0.5), 1);
    }
}

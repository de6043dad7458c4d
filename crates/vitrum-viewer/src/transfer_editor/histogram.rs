//! The histogram behind the curves.

use vitrum::io::Volume;

/// The number of voxels in each of many equal steps of a volume's values.
#[derive(Debug, Clone, PartialEq)]
pub struct Histogram {
    /// The range of the steps: the volume's, outliers left out.
    pub range: [f32; 2],
    counts: Vec<u64>,
}

impl Histogram {
    /// As many as there are pixels across, about.
    const BINS: usize = 256;

    /// Counts the voxels of a volume; outliers are in no step.
    #[must_use]
    pub fn of(volume: &Volume) -> Self {
        let [low, high] = volume.common_range();
        // The steps outside take the outliers.
        let step = (high - low) / Self::BINS as f32;
        let mut counts = volume.histogram_over([low - step, high + step], Self::BINS + 2);
        let (inner, ends) = (volume.range == [low, high], [0, counts.len().saturating_sub(1)]);
        if inner && counts.len() > 3 {
            // Without outliers nothing but rounding comes to the steps outside.
            let [first, last] = ends.map(|end| counts[end]);
            counts[1] += first;
            let end = counts.len() - 2;
            counts[end] += last;
        }
        let counts = counts.into_iter().skip(1).take(Self::BINS).collect();
        Self { range: [low, high], counts }
    }

    /// The steps: the values that each begins and ends at, and the logarithm of its number of voxels as a share of the greatest.
    pub fn bars(&self) -> impl Iterator<Item = ([f32; 2], f32)> + '_ {
        let [low, high] = self.range;
        let bins = self.counts.len() as f32;
        let edge = move |index: usize| low + (high - low) * index as f32 / bins;
        let logarithm = |count: u64| libm::log1p(count as f64);
        let greatest = logarithm(self.counts.iter().copied().max().unwrap_or(0));
        let share = move |count: u64| if greatest > 0.0 { (logarithm(count) / greatest) as f32 } else { 0.0 };
        self.counts.iter().enumerate().map(move |(index, &count)| ([edge(index), edge(index + 1)], share(count)))
    }

    /// The number of voxels in the step of a value.
    #[must_use]
    pub fn count_at(&self, value: f32) -> Option<u64> {
        let [low, high] = self.range;
        let share = (value - low) / (high - low);
        let index = (share * self.counts.len() as f32) as usize;
        (0.0..=1.0).contains(&share).then(|| self.counts.get(index.min(self.counts.len() - 1)).copied()).flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum::io::Voxels;

    #[test]
    fn every_voxel_but_outliers_is_counted_in_its_step() {
        let voxels: Vec<u8> = (0..4096_u32).map(|index| if index < 4000 { 10 } else { 200 }).collect();
        let volume = Volume::new("two values", [16; 3], [1.0; 3], Voxels::from(voxels)).expect("a volume");
        let histogram = Histogram::of(&volume);
        assert_eq!(histogram.counts.iter().sum::<u64>(), 4096);
        assert_eq!(
            [histogram.count_at(10.0), histogram.count_at(200.0), histogram.count_at(201.0)],
            [Some(4000), Some(96), None]
        );
        let tall: Vec<f32> = histogram.bars().map(|(_, share)| share).filter(|&share| share > 0.0).collect();
        assert!(tall.len() == 2 && tall[0] == 1.0 && (0.5..0.6).contains(&tall[1]), "logarithms: {tall:?}");
    }

    #[test]
    fn a_volume_of_one_value_has_a_histogram() {
        let volume = Volume::new("one value", [2; 3], [1.0; 3], Voxels::from(vec![7_u8; 8])).expect("a volume");
        let histogram = Histogram::of(&volume);
        assert!(histogram.bars().all(|(_, share)| share.is_finite()));
    }
}

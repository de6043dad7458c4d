//! The noise of a scan, by its differences from smooth fields.

use super::shape::sampling;
use super::subject::Subject;
use vitrum_io::Volume;

/// The noise of a volume's values within its matter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// Standard deviation of a voxel's value.
    pub deviation: f32,
    /// The deviation as a share of the way from the landmark `air` to `soft`.
    pub share: f32,
}

/// Differences below which a median says nothing.
const FEWEST: usize = 200;

/// The noise of a volume's matter; `None` where it has too little matter to tell.
#[must_use]
pub fn noise(volume: &Volume) -> Option<Noise> {
    of(volume, &Subject::above(volume, None))
}

/// As [`noise`], by landmarks that are known.
///
/// Second differences along each axis, one after another, vanish for every field that is quadratic along one of them, and of independent noise
/// they make noise of √6 times its deviation for each axis (Immerkær 1996, in three dimensions). Edges and details are few: the median of the
/// absolute differences leaves them out. Only voxels whose neighbours are all matter count, as many files have nothing but 0 around it.
pub(super) fn of(volume: &Volume, subject: &Subject) -> Option<Noise> {
    /// The standard deviation over the median of absolute deviations, of a normal distribution.
    const NORMAL: f32 = 1.482_6;
    let reach = reach(volume);
    let axes = reach.iter().filter(|&&reach| reach == 1).count();
    let (step, count) = sampling(volume);
    let mut differences = Vec::new();
    for z in (0..count[2]).map(|index| index * step[2]) {
        for y in (0..count[1]).map(|index| index * step[1]) {
            for x in (0..count[0]).map(|index| index * step[0]) {
                differences.extend(difference(volume, [x, y, z], reach, subject.surface).map(f32::abs));
            }
        }
    }
    if axes == 0 || differences.len() < FEWEST {
        return None;
    }
    let middle = differences.len() / 2;
    let (_, median, _) = differences.select_nth_unstable_by(middle, f32::total_cmp);
    let gain = libm::sqrtf(libm::powf(6.0, axes as f32));
    let deviation = NORMAL * *median / gain;
    Some(Noise { deviation, share: deviation / (subject.soft - subject.air) })
}

/// 1 along the axes whose voxels are near each other, and 0 along those whose slices are far apart or few.
fn reach(volume: &Volume) -> [u32; 3] {
    let finest = volume.finest_spacing();
    std::array::from_fn(|axis| u32::from(volume.dimensions[axis] >= 5 && volume.spacing[axis] <= 2.01 * finest))
}

/// The difference at a voxel; `None` where the grid ends, or a neighbour is below `least`.
fn difference(volume: &Volume, at: [u32; 3], reach: [u32; 3], least: f32) -> Option<f32> {
    if (0..3).any(|axis| at[axis] < reach[axis] || at[axis] + reach[axis] >= volume.dimensions[axis]) {
        return None;
    }
    let along = |axis: usize| at[axis] - reach[axis]..=at[axis] + reach[axis];
    // The middle of each three counts twice, against its neighbours.
    let weight = |axis: usize, index: u32| if reach[axis] == 1 && index == at[axis] { -2.0 } else { 1.0 };
    let mut sum = 0.0;
    for z in along(2) {
        for y in along(1) {
            for x in along(0) {
                let value = volume.value(x, y, z);
                if value < least {
                    return None;
                }
                sum += weight(0, x) * weight(1, y) * weight(2, z) * value;
            }
        }
    }
    Some(sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::preset::testing::{Normal, ball};
    use crate::preset::{Landmarks, landmarks};
    use vitrum_io::Voxels;

    fn noisy(deviation: f32, spacing: [f32; 3]) -> Volume {
        let mut normal = Normal::default();
        let voxels: Vec<f32> = ball(48).into_iter().map(|value| value + deviation * normal.next()).collect();
        Volume::new("noisy", [48; 3], spacing, Voxels::from(voxels)).expect("a volume")
    }

    #[test]
    fn the_deviation_of_known_noise_is_found() {
        for spacing in [[1.0; 3], [0.5, 0.5, 4.0]] {
            // Some thousand samples of a median: 2 %; the rim of a small ball, which is a quarter of it, adds the rest to little noise.
            for (deviation, bound) in [(2.0, 0.15), (20.0, 0.06), (60.0, 0.06)] {
                let volume = noisy(deviation, spacing);
                let found = noise(&volume).expect("there is matter");
                assert!((found.deviation / deviation - 1.0).abs() < bound, "{found:?}, expected {deviation}");
                let Landmarks { air, soft, .. } = landmarks(&volume);
                assert!((found.share - found.deviation / (soft - air)).abs() < 1e-6, "{found:?}");
            }
        }
    }

    #[test]
    fn a_field_without_noise_has_none() {
        let found = noise(&noisy(0.0, [1.0; 3])).expect("there is matter");
        assert!(found.share < 1e-4, "{found:?}");
        let empty = Volume::new("empty", [8; 3], [1.0; 3], Voxels::from(vec![0_u8; 512])).expect("a volume");
        assert!(noise(&empty).is_none_or(|noise| noise.share == 0.0));
        let flat = Volume::new("flat", [300, 1, 1], [1.0; 3], Voxels::from(vec![3_u8; 300])).expect("a volume");
        assert!(noise(&flat).is_none_or(|noise| noise.share == 0.0));
    }
}

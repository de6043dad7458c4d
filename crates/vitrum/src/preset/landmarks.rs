//! The landmarks that presets find among a volume's values, and its percentiles.

use super::histogram::Histogram;
use super::subject::{Subject, digits, round};
use vitrum_io::Volume;

/// Values of a volume that presets are fitted to, strictly increasing in the order of their declaration. In a CT of a head they are: noise
/// ends, skin begins, soft tissue, bone begins, hard bone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Landmarks {
    /// The upper end of noise and empty space.
    pub air: f32,
    /// Halfway from the surroundings into the matter.
    pub surface: f32,
    /// The commonest of the matter that is not dense.
    pub soft: f32,
    /// The densest class of matter begins here.
    pub dense: f32,
    /// Nearly all values are below.
    pub bright: f32,
}

impl Landmarks {
    /// Names and values, in ascending order.
    #[must_use]
    pub fn named(&self) -> [(&'static str, f32); 5] {
        let Self { air, surface, soft, dense, bright } = *self;
        [("air", air), ("surface", surface), ("soft", soft), ("dense", dense), ("bright", bright)]
    }
}

/// The landmarks of a volume.
#[must_use]
pub fn landmarks(volume: &Volume) -> Landmarks {
    let Subject { air, surface, soft, dense, bright, .. } = Subject::above(volume, None);
    Landmarks { air, surface, soft, dense, bright }
}

/// The values below which the given shares of the voxels lie, from 0 to 1; they are exact to a thousandth of the range.
#[must_use]
pub fn percentiles<const N: usize>(volume: &Volume, shares: [f64; N]) -> [f32; N] {
    let Some(histogram) = Histogram::of(volume) else { return [volume.range[0]; N] };
    let digits = digits(histogram.range[1] - histogram.range[0]);
    shares.map(|share| round(histogram.value(histogram.quantile(histogram.all(), share)), digits))
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_io::Voxels;

    #[test]
    fn percentiles_of_a_ramp_are_its_values() {
        let voxels: Vec<u8> = (0..=255).collect();
        let volume = Volume::new("ramp", [16, 16, 1], [1.0; 3], Voxels::from(voxels)).expect("a volume");
        let [low, quarter, half, high] = percentiles(&volume, [0.01, 0.25, 0.5, 0.99]);
        for (made, expected) in [(low, 2.0), (quarter, 63.0), (half, 127.0), (high, 253.0)] {
            assert!((made - expected).abs() <= 1.0, "{made}, expected {expected}");
        }
    }
}

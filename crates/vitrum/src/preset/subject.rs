//! The measurements of a volume that presets are fitted to: thresholds between its values, and its thickness.

use super::histogram::Histogram;
use super::shape::{clarity, thickness};
use crate::scene::{ColorPoint, IorPoint, OpacityPoint, Rgb};
use vitrum_io::Volume;

/// A volume as presets see it. The values are strictly increasing in the order of their declaration.
///
/// In a CT of a head they are: noise ends, skin begins, soft tissue, bone begins, hard bone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Subject {
    /// The upper end of noise and empty space: values below it must stay invisible and refract no light.
    pub air: f32,
    /// Halfway from the surroundings into the matter.
    pub surface: f32,
    /// The commonest of the matter that is not dense.
    pub soft: f32,
    /// The densest class of matter begins here.
    pub dense: f32,
    /// Nearly all values are below.
    pub bright: f32,
    /// The ends of the brightest hundredths, from the third to nearly all: vessels in angiographies.
    pub brightest: [f32; 2],
    /// Decimals that values are rounded to; negative to round to tens and more.
    digits: i32,
    /// World length that opacities and medium colours are stated for.
    pub reference_length: f32,
    /// The mean of `density` summed along the thick rays, in reference lengths; see [`Subject::absorption`].
    pub thickness: f32,
    /// The index contrast that the shape bears before it scatters rays, 0 to 1; see `shape::clarity`.
    pub clarity: f32,
}

/// Share of the longest edge that opacities are stated for: about a voxel of a usual scan.
const LAYERS: f32 = 256.0;

impl Subject {
    /// Looks at a volume.
    #[cfg(test)]
    pub fn of(volume: &Volume) -> Self {
        Self::above(volume, None)
    }

    /// Looks at a volume, all of whose values below `threshold` are nothing.
    pub fn above(volume: &Volume, threshold: Option<f32>) -> Self {
        let longest = volume.extent().into_iter().fold(0.0, f32::max);
        // A homogeneous block: make it matter, and nothing of it dense.
        let block = |value: f32| [-1.0, -0.5, 0.0, 1.0, 2.0].map(|step| value + step * value.abs().max(1.0));
        let ([air, surface, soft, dense, bright], brightest) = match (Histogram::of(volume), threshold) {
            (None, None) => (block(volume.range[0]), [volume.range[0]; 2]),
            (None, Some(threshold)) => {
                ([0.0, 0.5, 1.0, 2.0, 3.0].map(|step| threshold + step * threshold.abs().max(1.0)), [threshold; 2])
            }
            (Some(histogram), threshold) => {
                let values = match threshold {
                    None => landmarks(&histogram),
                    Some(threshold) => landmarks_above(&histogram, threshold),
                };
                (values, brightest(&histogram, threshold.unwrap_or(values[1])))
            }
        };
        let brightest = [brightest[0], brightest[1].max(brightest[0] + 4e-3 * (bright - air))];
        let reference_length = longest / LAYERS;
        let digits = digits(bright - air);
        let mut subject = Self {
            air,
            surface,
            soft,
            dense,
            bright,
            brightest,
            digits,
            reference_length,
            thickness: 0.0,
            clarity: 1.0,
        };
        subject.thickness = thickness(volume, &subject);
        subject.clarity = clarity(volume, surface);
        subject
    }

    /// Density from 0 (air) to 1 (bright), linear in the value.
    pub fn density(&self, value: f32) -> f32 {
        ((value - self.air) / (self.bright - self.air)).clamp(0.0, 1.0)
    }

    /// The absorption per reference length and density at which a thick ray has the optical depth `depth`.
    pub fn absorption(&self, depth: f32) -> f32 {
        // Even a nearly empty volume keeps to layers that are not black each.
        (depth / self.thickness.max(1e-3)).min(2.0)
    }

    /// The index of refraction with this contrast to the surroundings, less where the shape would scatter rays.
    pub fn index(&self, contrast: f32) -> f32 {
        round(1.0 + contrast * self.clarity, 3)
    }

    /// The value at a share of the way from one landmark to another, as round as the landmarks are.
    pub fn between(&self, from: f32, to: f32, share: f32) -> f32 {
        round(from + share * (to - from), self.digits).max(from).min(to)
    }
}

/// Air, surface, soft, dense and bright: Otsu's threshold parts matter from surroundings, and again within each.
fn landmarks(histogram: &Histogram) -> [f32; 5] {
    const OUTLIERS: f64 = 5e-4;
    let all = histogram.all();
    let end = all.end;
    // Fewer voxels than this are outliers, such as hot pixels and metal, and would claim a class of their own.
    let top = (histogram.quantile(all.clone(), 1.0 - 0.2 * OUTLIERS) + 1).min(end);
    let surface = histogram.otsu(0..top).or_else(|| histogram.otsu(all)).unwrap_or(end / 2);
    let air = histogram.otsu(0..surface).unwrap_or(surface / 2);
    let trimmed = (histogram.quantile(surface..end, 1.0 - OUTLIERS) + 1).min(end);
    let split = histogram.otsu(surface..trimmed);
    let [low, high] = histogram.range;
    let soft = histogram.value(histogram.quantile(surface..split.unwrap_or(end), 0.5));
    // Matter of one value, such as a mask, has nothing dense in it: the class begins beyond the range.
    let dense = split.map_or(high + 0.5 * (high - low), |bin| histogram.value(bin));
    let bright = match split {
        Some(bin) => histogram.value(histogram.quantile(bin..end, 0.9)),
        None => high + (high - low),
    };
    let values = [histogram.value(air), histogram.value(surface), soft, dense, bright];
    let digits = digits(bright - values[0]);
    spread(values, 4e-3 * (high - low)).map(|value| round(value, digits))
}

/// The landmarks where everything below `threshold` is nothing: air ends there, and the surface comes right behind it.
fn landmarks_above(histogram: &Histogram, threshold: f32) -> [f32; 5] {
    const OUTLIERS: f64 = 5e-4;
    let [low, high] = histogram.range;
    let all = histogram.all();
    let first = histogram.bin(threshold);
    if first >= all.end || histogram.total(first..all.end) == 0 {
        // Nothing is left: everything is beyond the values.
        let step = (high - low).max(threshold.abs() * 1e-3);
        return [0.0, 0.25, 0.5, 1.0, 2.0].map(|share| threshold + share * step);
    }
    let trimmed = (histogram.quantile(first..all.end, 1.0 - OUTLIERS) + 1).min(all.end);
    let split = histogram.otsu(first..trimmed);
    let soft = histogram.value(histogram.quantile(first..split.unwrap_or(all.end), 0.5));
    let dense = split.map_or(high + 0.5 * (high - low), |bin| histogram.value(bin));
    let bright = match split {
        Some(bin) => histogram.value(histogram.quantile(bin..all.end, 0.9)),
        None => high + (high - low),
    };
    let surface = threshold + (0.02 * (high - low)).min((0.5 * (soft - threshold)).max(4e-3 * (high - low)));
    spread([threshold, surface, soft, dense, bright], 4e-3 * (high - low))
}

/// The values between which the brightest voxels lie, none of them below `least`.
fn brightest(histogram: &Histogram, least: f32) -> [f32; 2] {
    let value = |share| histogram.value(histogram.quantile(histogram.all(), share));
    let low = value(0.97).max(least);
    [low, value(0.999).max(low)]
}

/// Decimals after which a thousandth of `range` is spent: finer differences cannot be seen.
pub(super) fn digits(range: f32) -> i32 {
    const FINEST: i32 = 30;
    (-libm::log10f(range / 1000.0).floor()).clamp(-FINEST as f32, FINEST as f32) as i32
}

/// People read and edit these values in scene files: 80 is better than 79.99765.
pub(super) fn round(value: f32, digits: i32) -> f32 {
    let scale = libm::pow(10.0, f64::from(digits));
    ((f64::from(value) * scale).round() / scale) as f32
}

/// Moves values apart that are equal or nearly so, upwards.
fn spread(mut values: [f32; 5], least: f32) -> [f32; 5] {
    for index in 1..values.len() {
        // The second term keeps values apart that are large for f32.
        let least = least.max(8.0 * f32::EPSILON * values[index - 1].abs());
        values[index] = values[index].max(values[index - 1] + least);
    }
    values
}

/// A point of an opacity function.
pub(super) fn opacity(value: f32, opacity: f32) -> OpacityPoint {
    OpacityPoint { value, opacity }
}

/// A point of an index of refraction.
pub(super) fn ior(value: f32, ior: f32) -> IorPoint {
    IorPoint::new(value, ior)
}

/// A point of a colour or medium function.
pub(super) fn color(value: f32, color: Rgb) -> ColorPoint {
    ColorPoint { value, color }
}

/// The medium colour of one layer, where `through` is left of white light behind `layers` of them.
pub(super) fn tint(through: Rgb, layers: f32) -> Rgb {
    through.map(|share| libm::powf(share, 1.0 / layers))
}

#[cfg(test)]
mod tests {
    use super::{Subject, digits, round};
    use vitrum_io::{Volume, Voxels};

    fn volume(dimensions: [u32; 3], voxels: Vec<f32>) -> Volume {
        Volume::new("test", dimensions, [1.0; 3], Voxels::from(voxels)).expect("the volume is valid")
    }

    /// Noise around 0, a box of tissue around 1000, a box of bone around 2000 in it; scaled and shifted.
    fn phantom(size: u32, scale: f32, offset: f32) -> Volume {
        let inside = |at: [u32; 3], margin: f32| {
            at.iter().all(|&index| (index as f32 + 0.5 - 0.5 * size as f32).abs() < margin * size as f32)
        };
        let mut noise = 1_u32;
        let voxels = (0..size.pow(3)).map(|index| {
            let at = [index % size, index / size % size, index / (size * size)];
            noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let base = if inside(at, 0.15) {
                2000.0
            } else if inside(at, 0.35) {
                1000.0
            } else {
                0.0
            };
            (base + 100.0 * (noise >> 8) as f32 / 16_777_216.0) * scale + offset
        });
        volume([size; 3], voxels.collect())
    }

    fn assert_increasing(subject: &Subject) {
        let values = [subject.air, subject.surface, subject.soft, subject.dense, subject.bright];
        assert!(values.is_sorted_by(|a, b| a < b), "{subject:?}");
        assert!(subject.thickness.is_finite() && subject.reference_length > 0.0, "{subject:?}");
    }

    #[test]
    fn landmarks_part_noise_tissue_and_bone_whatever_the_unit() {
        for (scale, offset) in [(1.0, 0.0), (0.001, 0.0), (1.0, -1024.0), (1e6, 5.0)] {
            let subject = Subject::of(&phantom(32, scale, offset));
            assert_increasing(&subject);
            let [air, surface, soft, dense] =
                [subject.air, subject.surface, subject.soft, subject.dense].map(|value| (value - offset) / scale);
            assert!((10.0..=400.0).contains(&air), "{air}");
            assert!((99.0..=1001.0).contains(&surface), "{surface}");
            assert!((999.0..=1101.0).contains(&soft), "{soft}");
            assert!((1099.0..=2001.0).contains(&dense), "{dense}");
        }
    }

    #[test]
    fn resolution_does_not_change_the_thickness() {
        let coarse = Subject::of(&phantom(24, 1.0, 0.0)).thickness;
        let fine = Subject::of(&phantom(96, 1.0, 0.0)).thickness;
        assert!((coarse / fine - 1.0).abs() < 0.1, "{coarse} and {fine}");
    }

    #[test]
    fn values_are_rounded_to_a_thousandth_of_their_range() {
        assert_eq!([digits(229.0), digits(0.9), digits(4e6)], [1, 4, -3]);
        assert_eq!([round(79.997_65, 1), round(0.123_456, 4), round(1_234_567.0, -3)], [80.0, 0.1235, 1_235_000.0]);
        assert!(round(f32::MAX, -30).is_finite() && digits(0.0) == 30 && digits(f32::INFINITY) == -30);
    }

    #[test]
    fn a_mask_has_its_surface_in_the_middle_and_nothing_dense() {
        let voxels = (0..512).map(|index| f32::from(u8::from(index % 8 > 3))).collect();
        let subject = Subject::of(&volume([8; 3], voxels));
        assert_increasing(&subject);
        assert!((subject.surface - 0.5).abs() < 0.01, "{subject:?}");
        assert!(subject.dense > 1.0, "{subject:?}");
    }

    #[test]
    fn degenerate_volumes_keep_their_landmarks_apart() {
        for voxels in [
            vec![0.0; 8],
            vec![-7.0; 8],
            vec![1e30; 8],
            vec![
                16_777_216.0,
                16_777_218.0,
                16_777_216.0,
                16_777_218.0,
                16_777_216.0,
                16_777_218.0,
                16_777_216.0,
                16_777_218.0,
            ],
        ] {
            assert_increasing(&Subject::of(&volume([2; 3], voxels)));
        }
    }
}

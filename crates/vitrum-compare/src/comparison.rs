//! Comparisons: the measured differences between two pictures or buffers.

use crate::error::{CompareError, require_equal_lengths};
use crate::flip;
use crate::ulp::UlpHistogram;

/// The differences between two pictures, or two buffers. The first of the two is the reference.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// Pixels in a row; the number of values for a buffer.
    pub width: u32,
    /// Rows; 1 for a buffer.
    pub height: u32,
    /// The largest difference between two channels; infinite where one is NaN.
    pub max_abs: f64,
    /// The root of the mean squared difference over all channels; infinite where one is NaN.
    pub rmse: f64,
    /// 20 log₁₀(peak / rmse) in decibels: infinite for equal pictures, negative infinite where a channel is NaN.
    pub psnr: f64,
    /// The largest finite magnitude in the reference.
    pub peak: f64,
    /// The mean ꟻLIP error, 0 to 1; nothing for buffers. It judges what a display shows: linear RGB cut off at 0 and 1
    /// and encoded as 8-bit sRGB.
    pub mean_flip: Option<f64>,
    /// The differences in representable numbers, channel by channel.
    pub ulps: UlpHistogram,
    /// The largest difference in each pixel; infinite where a channel is NaN.
    per_pixel: Vec<f64>,
}

impl Comparison {
    /// The share of pixels, 0 to 1, that have a channel whose difference is above `threshold`.
    #[must_use]
    pub fn share_above(&self, threshold: f64) -> f64 {
        let above = self.per_pixel.iter().filter(|&&difference| difference > threshold).count();
        above as f64 / self.per_pixel.len() as f64
    }

    /// Column and row of the first pixel with the largest difference, or nothing if none differs.
    #[must_use]
    pub fn worst_pixel(&self) -> Option<(u32, u32)> {
        let index = self.per_pixel.iter().position(|&difference| difference > 0.0 && difference == self.max_abs)?;
        let width = self.width as usize;
        Some(((index % width) as u32, (index / width) as u32))
    }
}

/// Compares two pictures in linear RGB, stored row by row.
///
/// # Errors
/// If the pictures are not both `width` × `height` pixels, or have none.
pub fn compare(a: &[[f32; 3]], b: &[[f32; 3]], width: u32, height: u32) -> Result<Comparison, CompareError> {
    let mut comparison = measure(a, b, width, height)?;
    comparison.mean_flip = Some(flip::mean(a, b, width, height));
    Ok(comparison)
}

/// Compares two buffers of values. Every value counts as a pixel, and ꟻLIP is not measured.
///
/// # Errors
/// If the lengths differ, are 0, or do not fit a `u32`.
pub fn compare_buffers(a: &[f32], b: &[f32]) -> Result<Comparison, CompareError> {
    let width = u32::try_from(a.len()).unwrap_or(u32::MAX);
    measure(a.as_chunks::<1>().0, b.as_chunks::<1>().0, width, 1)
}

fn measure<const CHANNELS: usize>(
    a: &[[f32; CHANNELS]],
    b: &[[f32; CHANNELS]],
    width: u32,
    height: u32,
) -> Result<Comparison, CompareError> {
    require_equal_lengths(a.len(), b.len())?;
    if a.len() as u64 != u64::from(width) * u64::from(height) {
        return Err(CompareError::Dimensions { width, height, pixels: a.len() });
    }
    let ulps = UlpHistogram::of(a.as_flattened(), b.as_flattened())?;
    let mut squares = 0.0;
    let per_pixel: Vec<f64> = a
        .iter()
        .zip(b)
        .map(|(a, b)| {
            let differences = a.iter().zip(b).map(|(&a, &b)| difference(a, b));
            squares += differences.clone().map(|difference| difference * difference).sum::<f64>();
            differences.fold(0.0, f64::max)
        })
        .collect();
    let max_abs = per_pixel.iter().copied().fold(0.0, f64::max);
    let rmse = (squares / (a.len() * CHANNELS) as f64).sqrt();
    let peak = a.as_flattened().iter().filter(|value| value.is_finite()).fold(0.0, |peak, value| value.abs().max(peak));
    let peak = f64::from(peak);
    let psnr = if rmse == 0.0 { f64::INFINITY } else { 20.0 * libm::log10(peak / rmse) };
    Ok(Comparison { width, height, max_abs, rmse, psnr, peak, mean_flip: None, ulps, per_pixel })
}

/// |a − b|, exact; 0 for equal infinities and infinite where either is NaN.
pub(crate) fn difference(a: f32, b: f32) -> f64 {
    if a == b {
        return 0.0;
    }
    let difference = (f64::from(a) - f64::from(b)).abs();
    if difference.is_nan() { f64::INFINITY } else { difference }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_pictures_have_no_difference() {
        let picture = [[0.5, 2.0, -3.0]; 6];
        let comparison = compare(&picture, &picture, 3, 2).unwrap();
        assert_eq!((comparison.max_abs, comparison.rmse, comparison.peak), (0.0, 0.0, 3.0));
        assert_eq!((comparison.psnr, comparison.mean_flip), (f64::INFINITY, Some(0.0)));
        assert_eq!((comparison.worst_pixel(), comparison.share_above(0.0)), (None, 0.0));
    }

    #[test]
    fn the_measures_are_those_of_the_textbook() {
        let a = [[0.0; 3], [4.0; 3]];
        let b = [[3.0, 0.0, 0.0], [4.0; 3]];
        let comparison = compare(&a, &b, 2, 1).unwrap();
        assert_eq!((comparison.max_abs, comparison.rmse), (3.0, (9.0f64 / 6.0).sqrt()));
        assert!((comparison.psnr - 20.0 * libm::log10(4.0 / 1.5f64.sqrt())).abs() < 1e-12);
        assert_eq!(comparison.worst_pixel(), Some((0, 0)));
        assert_eq!((comparison.share_above(2.9), comparison.share_above(3.0)), (0.5, 0.0));
    }

    #[test]
    fn not_a_number_is_an_infinite_difference() {
        let picture = [[0.0; 3], [0.0, f32::NAN, 0.0]];
        let comparison = compare(&picture, &picture, 1, 2).unwrap();
        assert_eq!((comparison.max_abs, comparison.rmse), (f64::INFINITY, f64::INFINITY));
        assert_eq!((comparison.psnr, comparison.worst_pixel()), (f64::NEG_INFINITY, Some((0, 1))));
        assert_eq!((comparison.share_above(1e30), comparison.ulps.undefined), (0.5, 1));
    }

    #[test]
    fn equal_infinities_agree_and_others_do_not() {
        let comparison = compare_buffers(&[f32::INFINITY, 1.0], &[f32::INFINITY, 1.0]).unwrap();
        assert_eq!((comparison.max_abs, comparison.peak), (0.0, 1.0));
        let comparison = compare_buffers(&[f32::INFINITY], &[f32::NEG_INFINITY]).unwrap();
        assert_eq!(comparison.max_abs, f64::INFINITY);
    }

    #[test]
    fn sizes_must_agree() {
        let picture = [[0.0; 3]; 6];
        assert_eq!(compare(&picture, &picture[..4], 3, 2), Err(CompareError::SizeMismatch { first: 6, second: 4 }));
        assert_eq!(compare(&picture, &picture, 3, 3), Err(CompareError::Dimensions { width: 3, height: 3, pixels: 6 }));
        assert_eq!(compare(&[], &[], 0, 0), Err(CompareError::Empty));
        assert_eq!(compare_buffers(&[], &[]), Err(CompareError::Empty));
    }
}

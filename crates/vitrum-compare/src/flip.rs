//! ꟻLIP: how much of a difference an observer sees when two pictures are shown in turn (Andersson et al. 2020).

use nv_flip::{DEFAULT_PIXELS_PER_DEGREE, FlipImageRgb8};
use vitrum_io::linear_to_srgb;

/// The mean ꟻLIP error of two pictures in linear RGB, 0 (no visible difference) to 1.
///
/// ꟻLIP judges what a display shows, so both pictures are cut off at 0 and 1 and encoded as 8-bit sRGB first: it is
/// blind above 1 and below half a level, where the other measures are not. A pixel that is NaN in either picture counts
/// as the largest error.
pub(crate) fn mean(a: &[[f32; 3]], b: &[[f32; 3]], width: u32, height: u32) -> f64 {
    let (shown_a, shown_b) = (encode(a), encode(b));
    let errors = if shown_a == shown_b {
        // The displayed pictures are equal: the filters would take seconds to find the error 0.
        vec![0.0; a.len()]
    } else {
        let [reference, test] = [shown_a, shown_b].map(|shown| FlipImageRgb8::with_data(width, height, &shown));
        nv_flip::flip(reference, test, DEFAULT_PIXELS_PER_DEGREE).to_vec()
    };
    let undefined = |pixel: &[f32; 3]| pixel.iter().any(|channel| channel.is_nan());
    let sum: f64 = errors
        .iter()
        .zip(a.iter().zip(b))
        .map(|(&error, (a, b))| if undefined(a) || undefined(b) { 1.0 } else { f64::from(error) })
        .sum();
    sum / errors.len() as f64
}

/// The 8-bit sRGB levels of linear RGB cut off at 0 and 1; NaN is shown black.
fn encode(pixels: &[[f32; 3]]) -> Vec<u8> {
    // The cast saturates, and takes NaN to 0.
    let level = |&value: &f32| (linear_to_srgb(value.clamp(0.0, 1.0)) * 255.0 + 0.5) as u8;
    pixels.as_flattened().iter().map(level).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn black_against_white_is_the_largest_error() {
        let error = mean(&[[0.0; 3]; 64], &[[1.0; 3]; 64], 8, 8);
        assert!(error > 0.9, "{error}");
    }

    #[test]
    fn a_picture_agrees_with_itself() {
        let picture: Vec<_> = (0..64).map(|index| [index as f32 / 64.0, 0.5, 0.25]).collect();
        assert_eq!(mean(&picture, &picture, 8, 8), 0.0);
    }

    #[test]
    fn a_difference_of_one_level_is_seen() {
        let error = mean(&[[0.5; 3]; 64], &[[0.51; 3]; 64], 8, 8);
        assert!(error > 0.0 && error < 0.1, "{error}");
    }

    #[test]
    fn one_pixel_that_is_not_a_number_is_seen() {
        let mut picture = [[0.0; 3]; 64];
        picture[9][1] = f32::NAN;
        assert_eq!(mean(&picture, &picture, 8, 8), 1.0 / 64.0);
    }
}

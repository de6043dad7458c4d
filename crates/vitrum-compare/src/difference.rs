//! Pictures of the difference between two pictures.

use crate::comparison::difference;
use crate::error::{CompareError, require_equal_lengths};

/// The colour of a pixel that is NaN in either picture.
const UNDEFINED: [f32; 3] = [1.0, 0.0, 1.0];

/// A picture of the difference of two pictures.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// The magnitude of the difference in each channel, times `gain`; infinite differences are shown as 1, and pixels
    /// with a NaN in magenta.
    pub pixels: Vec<[f32; 3]>,
    /// The factor on the differences, so that the largest finite one is 1; 1 if no difference is finite.
    pub gain: f64,
}

/// Shows where two pictures differ, scaled so that the largest finite difference is 1.
///
/// # Errors
/// If the pictures differ in size or have no pixels.
pub fn difference_picture(a: &[[f32; 3]], b: &[[f32; 3]]) -> Result<Difference, CompareError> {
    require_equal_lengths(a.len(), b.len())?;
    let differences = || a.as_flattened().iter().zip(b.as_flattened()).map(|(&a, &b)| difference(a, b));
    let largest = differences().filter(|difference| difference.is_finite()).fold(0.0, f64::max);
    let gain = if largest > 0.0 { largest.recip() } else { 1.0 };
    let show = |(a, b): (&[f32; 3], &[f32; 3])| {
        if a.iter().chain(b).any(|value| value.is_nan()) {
            UNDEFINED
        } else {
            std::array::from_fn(|channel| (difference(a[channel], b[channel]) * gain).min(1.0) as f32)
        }
    };
    Ok(Difference { pixels: a.iter().zip(b).map(show).collect(), gain })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_difference_is_white() {
        let a = [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]];
        let b = [[0.25, 0.0, 0.0], [1.0, 0.5, 1.0]];
        let difference = difference_picture(&a, &b).unwrap();
        assert_eq!((difference.pixels, difference.gain), (vec![[0.5, 0.0, 0.0], [0.0, 1.0, 0.0]], 2.0));
    }

    #[test]
    fn equal_pictures_give_black() {
        let difference = difference_picture(&[[7.0; 3]], &[[7.0; 3]]).unwrap();
        assert_eq!((difference.pixels, difference.gain), (vec![[0.0; 3]], 1.0));
    }

    #[test]
    fn the_undefined_and_the_infinite_are_seen() {
        let a = [[f32::NAN, 0.0, 0.0], [f32::INFINITY, 0.0, 0.0], [0.0; 3]];
        let b = [[f32::NAN, 0.0, 0.0], [0.0; 3], [0.0, 4.0, 0.0]];
        let difference = difference_picture(&a, &b).unwrap();
        assert_eq!(difference.pixels, [UNDEFINED, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        assert_eq!(difference.gain, 0.25);
    }

    #[test]
    fn sizes_must_agree() {
        let error = difference_picture(&[[0.0; 3]], &[]).unwrap_err();
        assert_eq!(error, CompareError::SizeMismatch { first: 1, second: 0 });
    }
}

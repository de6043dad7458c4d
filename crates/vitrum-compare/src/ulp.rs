//! Distances between `f32` values, counted in representable numbers.

use std::fmt;
use std::ops::RangeInclusive;

use crate::error::{CompareError, require_equal_lengths};

/// Buckets for the distances 0, 1, 2, 3–4, 5–8, … 2³¹+1–2³².
const BUCKETS: usize = 34;

/// The number of steps from one `f32` to the next that lead from `a` to `b`, or nothing if either is NaN.
///
/// The distance is 0 exactly when the bits are equal: negative zero is one step below positive zero. Infinity is one
/// step beyond the largest finite number.
#[must_use]
pub fn ulp_distance(a: f32, b: f32) -> Option<u32> {
    if a.is_nan() || b.is_nan() {
        return None;
    }
    u32::try_from(rank(a).abs_diff(rank(b))).ok()
}

/// The place of a number among all `f32` in ascending order, positive zero at 0.
fn rank(value: f32) -> i64 {
    let magnitude = i64::from(value.to_bits() & 0x7fff_ffff);
    if value.is_sign_negative() { -magnitude - 1 } else { magnitude }
}

/// A histogram of the distances between the values of two slices, in representable numbers (ULP).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UlpHistogram {
    counts: [usize; BUCKETS],
    /// Pairs in which at least one value is NaN; they are in no bucket.
    pub undefined: usize,
    /// The largest distance between two values that are not NaN.
    pub max: u32,
    /// The index of the first pair whose bits differ, or that has a NaN.
    pub first_difference: Option<usize>,
}

impl UlpHistogram {
    /// The histogram of two slices of equal length.
    ///
    /// # Errors
    /// If the lengths differ, or there are no values.
    pub fn of(a: &[f32], b: &[f32]) -> Result<Self, CompareError> {
        require_equal_lengths(a.len(), b.len())?;
        let mut histogram = Self { counts: [0; BUCKETS], undefined: 0, max: 0, first_difference: None };
        for (index, (&a, &b)) in a.iter().zip(b).enumerate() {
            let distance = ulp_distance(a, b);
            match distance {
                Some(distance) => {
                    histogram.counts[bucket(distance)] += 1;
                    histogram.max = histogram.max.max(distance);
                }
                None => histogram.undefined += 1,
            }
            if distance != Some(0) && histogram.first_difference.is_none() {
                histogram.first_difference = Some(index);
            }
        }
        Ok(histogram)
    }

    /// The number of pairs with equal bits.
    #[must_use]
    pub fn equal(&self) -> usize {
        self.counts[0]
    }

    /// The number of pairs that were compared, those with a NaN included.
    #[must_use]
    pub fn total(&self) -> usize {
        self.counts.iter().sum::<usize>() + self.undefined
    }

    /// The number of pairs more than `distance` apart, those with a NaN included. `distance` is 0 or a power of two, where a
    /// bucket ends; another is taken for the next one.
    #[must_use]
    pub fn above(&self, distance: u32) -> usize {
        self.counts[bucket(distance) + 1..].iter().sum::<usize>() + self.undefined
    }

    /// The distances that occur, as ranges in ascending order, and how often each does.
    pub fn buckets(&self) -> impl Iterator<Item = (RangeInclusive<u64>, usize)> + '_ {
        self.counts.iter().enumerate().filter(|&(_, &count)| count > 0).map(|(bucket, &count)| (range(bucket), count))
    }
}

/// The bucket of a distance: 0, 1, then one for each power of two that it does not exceed.
fn bucket(distance: u32) -> usize {
    match distance {
        0 => 0,
        _ => 1 + (u32::BITS - (distance - 1).leading_zeros()) as usize,
    }
}

/// The distances that fall into a bucket.
fn range(bucket: usize) -> RangeInclusive<u64> {
    match bucket {
        0 => 0..=0,
        1 => 1..=1,
        _ => (1 << (bucket - 2)) + 1..=1 << (bucket - 1),
    }
}

/// Text such as `0: 9210, 1: 3, 3–4: 1, NaN: 2`.
impl fmt::Display for UlpHistogram {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut separator = "";
        for (range, count) in self.buckets() {
            let (first, last) = (range.start(), range.end());
            if first == last {
                write!(formatter, "{separator}{first}: {count}")?;
            } else {
                write!(formatter, "{separator}{first}–{last}: {count}")?;
            }
            separator = ", ";
        }
        if self.undefined > 0 {
            write!(formatter, "{separator}NaN: {}", self.undefined)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_are_one_apart_everywhere() {
        for value in [0.0, f32::from_bits(1), 1.0, -1.0, 1.5e-40, -3.7e20, f32::MAX, -f32::MIN_POSITIVE, f32::MIN] {
            assert_eq!(ulp_distance(value, value), Some(0));
            assert_eq!(ulp_distance(value, value.next_up()), Some(1));
        }
    }

    #[test]
    fn the_sign_of_zero_counts() {
        assert_eq!(ulp_distance(-0.0, 0.0), Some(1));
        assert_eq!(ulp_distance(-f32::from_bits(1), f32::from_bits(1)), Some(3));
    }

    #[test]
    fn the_extremes_do_not_overflow() {
        assert_eq!(ulp_distance(f32::NEG_INFINITY, f32::INFINITY), Some(2 * 0x7f80_0000 + 1));
        assert_eq!(ulp_distance(f32::MAX, f32::INFINITY), Some(1));
        let histogram = UlpHistogram::of(&[f32::NEG_INFINITY], &[f32::INFINITY]).unwrap();
        assert_eq!(histogram.buckets().collect::<Vec<_>>(), [((1 << 31) + 1..=1 << 32, 1)]);
    }

    #[test]
    fn buckets_hold_the_distances_they_name() {
        for distance in (0..5000).chain([u32::MAX - 1, u32::MAX, 1 << 31, (1 << 31) + 1]) {
            assert!(range(bucket(distance)).contains(&u64::from(distance)), "{distance}");
        }
    }

    #[test]
    fn not_a_number_differs_from_itself() {
        let histogram = UlpHistogram::of(&[1.0, f32::NAN, 2.0], &[1.0, f32::NAN, 2.0]).unwrap();
        assert_eq!((histogram.undefined, histogram.first_difference, histogram.max), (1, Some(1), 0));
        assert_eq!((histogram.equal(), histogram.total()), (2, 3));
        assert_eq!(histogram.to_string(), "0: 2, NaN: 1");
    }

    #[test]
    fn distances_are_counted_in_their_buckets() {
        let b: Vec<f32> = [0, 0, 1, 2, 3, 4, 5].iter().map(|&steps| f32::from_bits(1.0f32.to_bits() + steps)).collect();
        let histogram = UlpHistogram::of(&[1.0; 7], &b).unwrap();
        assert_eq!(histogram.to_string(), "0: 2, 1: 1, 2: 1, 3–4: 2, 5–8: 1");
        assert_eq!((histogram.max, histogram.first_difference), (5, Some(2)));
        assert_eq!([0, 1, 2, 4, 8, u32::MAX].map(|distance| histogram.above(distance)), [5, 4, 3, 1, 0, 0]);
    }

    #[test]
    fn lengths_must_agree() {
        assert_eq!(UlpHistogram::of(&[], &[]), Err(CompareError::Empty));
        assert_eq!(UlpHistogram::of(&[1.0], &[]), Err(CompareError::SizeMismatch { first: 1, second: 0 }));
    }
}

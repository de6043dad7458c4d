//! A check that cannot fail is worth nothing: every bound is given a difference that it must find, and beside it one
//! that it must let through.

use vitrum_compare::{Bound, Breach, Comparison, Quantity, Tolerance, Verdict, compare, compare_buffers};

const WIDTH: u32 = 24;
const HEIGHT: u32 = 16;

fn picture() -> Vec<[f32; 3]> {
    (0..WIDTH * HEIGHT).map(|index| [index as f32 / 512.0, 0.5, 0.25 + (index % 7) as f32 / 16.0]).collect()
}

/// The picture against one in which `plant` has changed something.
fn planted(plant: impl FnOnce(&mut [[f32; 3]])) -> Comparison {
    let reference = picture();
    let mut other = reference.clone();
    plant(&mut other);
    compare(&reference, &other, WIDTH, HEIGHT).unwrap()
}

fn breached(bound: Bound, comparison: &Comparison) -> Vec<Quantity> {
    match bound.check(comparison) {
        Verdict::Pass => Vec::new(),
        Verdict::Fail(breaches) => breaches.iter().map(|breach| breach.quantity).collect(),
    }
}

#[test]
fn every_bound_accepts_equal_pictures() {
    let comparison = planted(|_| {});
    let strictest = Tolerance {
        relative_to_peak: true,
        max_abs: Some(0.0),
        rmse: Some(0.0),
        share_above: Some((0.0, 0.0)),
        mean_flip: Some(0.0),
    };
    for bound in [Bound::BitEqual, Bound::Ulp(0), Bound::Tolerance(strictest)] {
        assert_eq!(bound.check(&comparison), Verdict::Pass);
    }
}

#[test]
fn bit_equality_sees_the_last_bit_of_the_last_value() {
    let comparison = planted(|other| {
        let last = other.last_mut().unwrap();
        last[2] = last[2].next_up();
    });
    assert_eq!(breached(Bound::BitEqual, &comparison), [Quantity::Ulp]);
    assert_eq!(breached(Bound::Ulp(1), &comparison), []);
    assert_eq!(comparison.ulps.first_difference, Some((WIDTH * HEIGHT * 3 - 1) as usize));
}

#[test]
fn bit_equality_sees_the_sign_of_zero() {
    let comparison = planted(|other| other[0][0] = -0.0);
    assert_eq!(comparison.max_abs, 0.0);
    assert_eq!(breached(Bound::BitEqual, &comparison), [Quantity::Ulp]);
}

#[test]
fn a_ulp_bound_sees_one_step_too_many() {
    let comparison = planted(|other| other[5][1] = f32::from_bits(0.5f32.to_bits() + 4));
    assert_eq!(breached(Bound::Ulp(3), &comparison), [Quantity::Ulp]);
    assert_eq!(breached(Bound::Ulp(4), &comparison), []);
}

#[test]
fn a_bound_on_most_values_sees_one_value_too_many() {
    let comparison = planted(|other| {
        for pixel in &mut other[5..7] {
            pixel[1] = f32::from_bits(0.5f32.to_bits() + 5);
        }
    });
    let share = |count: f64| count / f64::from(WIDTH * HEIGHT * 3);
    assert_eq!(breached(Bound::MostlyUlp(4, share(1.0)), &comparison), [Quantity::UlpShare]);
    assert_eq!(breached(Bound::MostlyUlp(4, share(2.0)), &comparison), []);
    assert_eq!(breached(Bound::MostlyUlp(8, 0.0), &comparison), []);
}

#[test]
fn no_bound_lets_a_nan_through() {
    let mut reference = picture();
    reference[100][0] = f32::NAN;
    let comparison = compare(&reference, &reference, WIDTH, HEIGHT).unwrap();
    let unlimited = Bound::Tolerance(Tolerance::default());
    for bound in [Bound::BitEqual, Bound::Ulp(u32::MAX), Bound::MostlyUlp(1, 1.0), unlimited] {
        assert_eq!(breached(bound, &comparison), [Quantity::Undefined]);
    }
}

#[test]
fn a_limit_on_the_largest_difference_sees_one_pixel() {
    let comparison = planted(|other| other[77][1] += 0.125);
    let limit = |max_abs| Bound::Tolerance(Tolerance { max_abs: Some(max_abs), ..Tolerance::default() });
    assert_eq!(breached(limit(0.12), &comparison), [Quantity::MaxAbs]);
    assert_eq!(breached(limit(0.125), &comparison), []);
}

#[test]
fn a_limit_on_the_rmse_sees_many_small_differences() {
    let comparison = planted(|other| other.iter_mut().for_each(|pixel| *pixel = pixel.map(|value| value + 0.01)));
    let limit = |rmse| Bound::Tolerance(Tolerance { rmse: Some(rmse), ..Tolerance::default() });
    assert_eq!(breached(limit(0.0099), &comparison), [Quantity::Rmse]);
    assert_eq!(breached(limit(0.0101), &comparison), []);
}

#[test]
fn a_limit_on_the_share_counts_pixels() {
    let comparison = planted(|other| other[..3].iter_mut().for_each(|pixel| pixel[2] += 0.5));
    let share = |count: f64| Some((0.4, count / f64::from(WIDTH * HEIGHT)));
    let limit = |count| Bound::Tolerance(Tolerance { share_above: share(count), ..Tolerance::default() });
    assert_eq!(breached(limit(2.0), &comparison), [Quantity::Share]);
    assert_eq!(breached(limit(3.0), &comparison), []);
}

#[test]
fn a_limit_on_flip_sees_what_an_observer_sees() {
    let comparison = planted(|other| other[200..208].iter_mut().for_each(|pixel| *pixel = [1.0, 0.0, 0.0]));
    let limit = |flip| Bound::Tolerance(Tolerance { mean_flip: Some(flip), ..Tolerance::default() });
    assert_eq!(breached(limit(1e-3), &comparison), [Quantity::MeanFlip]);
    assert_eq!(breached(limit(0.5), &comparison), []);
}

#[test]
fn relative_limits_scale_with_the_peak_of_the_reference() {
    let comparison = compare_buffers(&[0.0, 1000.0], &[0.05, 1000.0]).unwrap();
    let limit = |relative_to_peak| Tolerance { relative_to_peak, max_abs: Some(1e-4), ..Tolerance::default() };
    assert_eq!(breached(Bound::Tolerance(limit(false)), &comparison), [Quantity::MaxAbs]);
    assert_eq!(breached(Bound::Tolerance(limit(true)), &comparison), []);
    let from_black = compare_buffers(&[0.0, 0.0], &[0.0, 1e-30]).unwrap();
    assert_eq!(breached(Bound::Tolerance(limit(true)), &from_black), [Quantity::MaxAbs]);
}

#[test]
fn a_limit_on_what_was_not_measured_is_breached() {
    let comparison = compare_buffers(&[1.0], &[1.0]).unwrap();
    let bound = Bound::Tolerance(Tolerance { mean_flip: Some(1.0), ..Tolerance::default() });
    let breach = Breach { quantity: Quantity::MeanFlip, measured: None, limit: 1.0 };
    assert_eq!(bound.check(&comparison), Verdict::Fail(vec![breach]));
}

#[test]
fn a_breach_says_what_was_measured_and_what_was_allowed() {
    let comparison = compare_buffers(&[1.0], &[1.5]).unwrap();
    let bound = Bound::Tolerance(Tolerance { max_abs: Some(1e-4), rmse: Some(1.0), ..Tolerance::default() });
    assert_eq!(bound.check(&comparison).to_string(), "largest difference 5.000e-1 exceeds 1e-4");
    assert_eq!(Bound::Ulp(2).check(&comparison).to_string(), "largest distance in ULP 4194304 exceeds 2");
}

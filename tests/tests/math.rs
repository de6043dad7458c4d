//! The error bounds that the kernels' own functions state, against `f64` over their whole range.

use vitrum_kernels::math::{asin, atan2, exp, half_to_f32, log2, sqrt};

/// Every `STEP`th float is tried.
const STEP: usize = 257;

/// The floats between `low` and `high`, every `STEP`th of them.
fn floats(low: f32, high: f32) -> impl Iterator<Item = f32> {
    (0..=u32::MAX).step_by(STEP).map(f32::from_bits).filter(move |x| (low..=high).contains(x))
}

#[test]
fn exp_is_within_two_units_in_the_last_place() {
    let worst = floats(-87.0, 88.0).map(|x| (f64::from(exp(x)) / f64::from(x).exp() - 1.0).abs()).fold(0.0, f64::max);
    println!("exp: relative error {worst:.3e}");
    assert!(worst < 1.5e-7, "{worst}");
    assert_eq!((exp(0.0), exp(-0.0)), (1.0, 1.0));
    assert_eq!((exp(1e4), exp(-1e4)), (exp(88.0), exp(-87.0)));
    assert_eq!(exp(f32::NAN), exp(-87.0));
}

#[test]
fn log2_is_within_its_bound() {
    let worst = floats(f32::MIN_POSITIVE, f32::MAX)
        .map(|x| {
            let truth = f64::from(x).log2();
            (f64::from(log2(x)) - truth).abs() / (4e-7 + 1e-7 * truth.abs())
        })
        .fold(0.0, f64::max);
    println!("log2: {worst:.3} of its bound");
    assert!(worst < 1.0, "{worst}");
    assert_eq!((log2(1.0), log2(1024.0), log2(0.0), log2(-1.0)), (0.0, 10.0, -126.0, -126.0));
}

#[test]
fn inverse_trigonometric_functions_are_within_their_bounds() {
    let mut worst = 0.0f64;
    for i in 0..4_000_000u32 {
        // All directions, lengths over twelve orders of magnitude.
        let angle = f64::from(i) * 2.399_963_229_728_653;
        let size = 10f64.powf(f64::from(i % 1201) * 0.01 - 6.0);
        let (y, x) = ((angle.sin() * size) as f32, (angle.cos() * size) as f32);
        worst = worst.max((f64::from(atan2(y, x)) - f64::from(y).atan2(f64::from(x))).abs());
    }
    println!("atan2: absolute error {worst:.3e}");
    assert!(worst < 4e-7, "{worst}");
    assert_eq!(atan2(0.0, 0.0), 0.0);
    let worst = floats(-1.0, 1.0).map(|x| (f64::from(asin(x)) - f64::from(x).asin()).abs()).fold(0.0, f64::max);
    println!("asin: absolute error {worst:.3e}");
    assert!(worst < 5e-7, "{worst}");
    assert_eq!((asin(2.0), asin(-2.0)), (asin(1.0), asin(-1.0)));
}

#[test]
fn halves_and_square_roots_are_exact() {
    for bits in 0..0x7c00u32 {
        let (exponent, mantissa) = (bits >> 10, f64::from(bits & 0x3ff) / 1024.0);
        if exponent > 0 {
            let truth = (1.0 + mantissa) * 2f64.powi(exponent as i32 - 15);
            assert_eq!(f64::from(half_to_f32(bits, 0)), truth);
            assert_eq!(f64::from(half_to_f32(bits, 4)), truth / 16.0);
        }
    }
    assert_eq!(half_to_f32(0, 4), 0.0);
    assert!(floats(0.0, f32::MAX).all(|x| sqrt(x) == x.sqrt()));
    assert_eq!((sqrt(-1.0), sqrt(f32::NEG_INFINITY)), (0.0, 0.0));
}

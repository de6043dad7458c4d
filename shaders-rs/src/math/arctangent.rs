//! Inverse trigonometric functions.

use super::{absolute, max, min, select, sqrt};
use core::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// The angle of (x, y) in −π…π; absolute error below 4e-7. 0 at the origin.
#[inline(always)]
pub fn atan2(y: f32, x: f32) -> f32 {
    let (ax, ay) = (absolute(x), absolute(y));
    let (low, high) = (min(ax, ay), max(ax, ay));
    // tan of the angle in the first octant, moved by π/8 steps to |t| ≤ tan(π/8).
    let q = low / max(high, f32::MIN_POSITIVE);
    let beyond = q > 0.414_213_57;
    let t = select(beyond, (q - 1.0) / (q + 1.0), q);
    let t2 = t * t;
    let p = -0.090_909_09 + t2 * 0.058_5;
    let p = 0.111_111_11 + t2 * p;
    let p = -0.142_857_14 + t2 * p;
    let p = 0.2 + t2 * p;
    let p = -0.333_333_34 + t2 * p;
    let angle = select(beyond, FRAC_PI_4, 0.0) + (t + t * t2 * p);
    let angle = select(ay > ax, FRAC_PI_2 - angle, angle);
    let angle = select(x < 0.0, PI - angle, angle);
    select(y < 0.0, -angle, angle)
}

/// arcsin x for −1 ≤ x ≤ 1 (limited to it); absolute error below 5e-7.
#[inline(always)]
pub fn asin(x: f32) -> f32 {
    let x = super::clamp(x, -1.0, 1.0);
    atan2(x, sqrt((1.0 - x) * (1.0 + x)))
}

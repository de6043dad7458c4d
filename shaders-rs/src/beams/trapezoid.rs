//! The distribution function of a trapezoid: the convolution of two boxes, across which a beam's flux is spread (the projection of its
//! parallelogram).

use crate::math::{clamp, max, min, select};

/// The share of the flux beyond `x` ≥ 0, of a trapezoid around 0 that is the convolution of boxes of the widths `wide` ≥ `narrow` > 0.
#[inline(always)]
fn tail(x: f32, wide: f32, narrow: f32) -> f32 {
    let edge = 0.5 * (wide + narrow);
    let slope = clamp(edge - x, 0.0, narrow);
    (slope * (slope / narrow) * 0.5 + max(edge - x - narrow, 0.0)) / wide
}

/// The share of the flux below `x`, 0 to 1, of a trapezoid around 0 that is the convolution of boxes of the widths `wide` ≥ `narrow` > 0.
#[inline(always)]
pub fn distribution(x: f32, wide: f32, narrow: f32) -> f32 {
    let beyond = tail(max(x, -x), wide, narrow);
    select(x >= 0.0, 1.0 - beyond, beyond)
}

/// The mean density of the flux over a pixel of width `filter` around `x`: the density of a beam's flux whose cross-section is projected to boxes
/// of the widths `first` and `second`, in any order, filtered by the pixel. No box is taken to be narrower than a ten-thousandth of the
/// pixel.
#[inline(always)]
pub fn filtered(x: f32, first: f32, second: f32, filter: f32) -> f32 {
    let least = 1e-4 * filter;
    let (wide, narrow) = (max(max(first, second), least), max(min(first, second), least));
    let half = 0.5 * filter;
    (distribution(x + half, wide, narrow) - distribution(x - half, wide, narrow)) / filter
}

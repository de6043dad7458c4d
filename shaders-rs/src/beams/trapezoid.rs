//! The distribution function of a trapezoid: the convolution of two boxes, across which a beam's flux is spread (the projection of its
//! parallelogram).

use crate::math::{clamp, max, min, select};

/// A trapezoid around 0 of area 1.
#[derive(Clone, Copy)]
pub struct Trapezoid {
    /// Half its width.
    pub half: f32,
    /// Width of the narrower of the two boxes.
    pub narrow: f32,
    /// 1 / (2 · `narrow`).
    pub slope: f32,
    /// 1 / width of the wider box.
    pub height: f32,
}

impl Trapezoid {
    /// The convolution of boxes of the widths `first` and `second`; no box is taken to be narrower than `least`.
    #[inline(always)]
    pub fn new(first: f32, second: f32, least: f32) -> Self {
        let (wide, narrow) = (max(max(first, second), least), max(min(first, second), least));
        Self { half: 0.5 * (wide + narrow), narrow, slope: 0.5 / narrow, height: 1.0 / wide }
    }

    /// The share of the area below `x`, 0 to 1.
    #[inline(always)]
    fn distribution(&self, x: f32) -> f32 {
        let within = self.half - max(x, -x);
        let edge = clamp(within, 0.0, self.narrow);
        let beyond = (edge * (edge * self.slope) + max(within - self.narrow, 0.0)) * self.height;
        select(x >= 0.0, 1.0 - beyond, beyond)
    }

    /// The mean density over a pixel of width `filter` around `x`.
    #[inline(always)]
    pub fn filtered(&self, x: f32, filter: f32, inverse_filter: f32) -> f32 {
        let half = 0.5 * filter;
        (self.distribution(x + half) - self.distribution(x - half)) * inverse_filter
    }
}

/// Width of the narrowest box, over the width of a pixel.
pub const LEAST: f32 = 1e-4;

/// The mean density of the flux over a pixel of width `filter` around `x`: the density of a beam's flux whose cross-section is projected to boxes
/// of the widths `first` and `second`, in any order, filtered by the pixel.
#[inline(always)]
pub fn filtered(x: f32, first: f32, second: f32, filter: f32) -> f32 {
    Trapezoid::new(first, second, LEAST * filter).filtered(x, filter, 1.0 / filter)
}

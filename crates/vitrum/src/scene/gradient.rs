//! The second dimension of transfer functions: the magnitude of the scalar's gradient.

use super::Rgb;
use super::piecewise::around;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::str::FromStr;

/// A factor of opacity at a gradient magnitude.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GradientPoint {
    /// Gradient magnitude: the change of the scalar over the mean edge of a voxel, across the steepest direction. `vitrum info` shows the common ones.
    #[schemars(range(min = 0), extend("x-unit" = "the volume's"))]
    pub magnitude: f32,
    /// Factor of the extinction: of a layer with the opacity α, 1 − (1 − α)^factor is left.
    #[schemars(range(min = 0, max = 1))]
    pub factor: f32,
}

/// A region of a two-dimensional transfer function, over the scalar and the magnitude of its gradient. Inside of a tissue the scalar hardly
/// changes, and between two of them it does: with a factor of 0 at small magnitudes, boundaries alone are seen.
///
/// Factors are computed for each voxel, by central differences, and interpolated in between. Where several functions apply to a scalar, their
/// factors are multiplied.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GradientFunction {
    /// The scalars to which the function applies, from the first to the second; all if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "the volume's"))]
    pub values: Option<[f32; 2]>,
    /// Factor of the colour of these scalars, linear RGB.
    #[serde(default = "white")]
    #[schemars(inner(range(min = 0, max = 1)), extend("x-unit" = "a share"))]
    pub color: Rgb,
    /// Factors of opacity, piecewise linear over the gradient magnitude, and constant beyond the first and the last point; 1 everywhere if empty.
    #[serde(default)]
    pub opacity: Vec<GradientPoint>,
}

impl FromStr for GradientPoint {
    type Err = String;

    /// The point of `MAGNITUDE:FACTOR`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let numbers = text.split_once(':').map(|(magnitude, factor)| (magnitude.trim().parse(), factor.trim().parse()));
        match numbers {
            Some((Ok(magnitude), Ok(factor)))
                if (0.0..=f32::MAX).contains(&magnitude) && (0.0..=1.0).contains(&factor) =>
            {
                Ok(Self { magnitude, factor })
            }
            _ => Err("expected MAGNITUDE:FACTOR, such as 20:0 or 120:0.8, with a factor from 0 to 1".to_owned()),
        }
    }
}

fn white() -> Rgb {
    [1.0; 3]
}

impl GradientFunction {
    /// The function of all scalars through `opacity`.
    #[must_use]
    pub fn of_opacity(opacity: Vec<GradientPoint>) -> Self {
        Self { values: None, color: white(), opacity }
    }

    /// Whether the function applies to a scalar.
    #[must_use]
    pub fn applies_to(&self, value: f32) -> bool {
        self.values.is_none_or(|[low, high]| value >= low && value <= high)
    }

    /// The factor of opacity at a gradient magnitude.
    #[must_use]
    pub fn factor(&self, magnitude: f32) -> f32 {
        around(&self.opacity, magnitude, |point| point.magnitude)
            .map_or(1.0, |(before, next, share)| before.factor + (next.factor - before.factor) * share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_linear_between_points_and_steps_are_steps() {
        let point = |magnitude, factor| GradientPoint { magnitude, factor };
        let function = GradientFunction::of_opacity(vec![point(10.0, 0.0), point(20.0, 0.5), point(20.0, 1.0)]);
        let found: Vec<f32> = [0.0, 10.0, 15.0, 19.0, 20.0, 99.0].map(|magnitude| function.factor(magnitude)).into();
        assert_eq!(found, [0.0, 0.0, 0.25, 0.45, 1.0, 1.0]);
        assert_eq!(GradientFunction::of_opacity(Vec::new()).factor(3.0), 1.0);
    }

    #[test]
    fn a_function_may_apply_to_some_scalars() {
        let function = GradientFunction { values: Some([2.0, 3.0]), ..GradientFunction::of_opacity(Vec::new()) };
        assert_eq!([1.9, 2.0, 3.0, 3.1].map(|value| function.applies_to(value)), [false, true, true, false]);
    }
}

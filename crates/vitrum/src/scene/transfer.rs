//! Transfer functions: piecewise linear over the physical scalar.

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A colour at a scalar value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ColorPoint {
    /// Scalar value.
    #[schemars(extend("x-unit" = "the volume's"))]
    pub value: f32,
    /// Linear RGB: the reflectance of particles, or the transmittance of a layer as thick as the reference length.
    #[schemars(inner(range(min = 0, max = 1)), extend("x-unit" = "a share"))]
    pub color: Rgb,
}

/// An opacity at a scalar value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OpacityPoint {
    /// Scalar value.
    #[schemars(extend("x-unit" = "the volume's"))]
    pub value: f32,
    /// Opacity of a layer as thick as the reference length.
    #[schemars(range(min = 0, max = 1))]
    pub opacity: f32,
}

/// An index of refraction at a scalar value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct IorPoint {
    /// Scalar value, of `ior_volume` where there is one.
    #[schemars(extend("x-unit" = "the volume's"))]
    pub value: f32,
    /// Index of refraction: 1 is air's, 1.33 water's, 1.5 that of glass. No light is bent where it is `surroundings.ior`.
    #[schemars(range(min = 0.2, max = 5))]
    pub ior: f32,
    /// Abbe number V_d: the smaller, the more blue bends than red, as crown glass (60) and flint glass (30) do. `ior` is
    /// then that of yellow light (587.6 nm). All colours bend alike if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 5, max = 1000))]
    pub abbe: Option<f32>,
    /// Coefficient B of Cauchy's η(λ) = A + B/λ², instead of `abbe`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0, max = 0.1), extend("x-unit" = "µm²"))]
    pub cauchy_b: Option<f32>,
}

/// Four piecewise linear functions over the scalar, each constant beyond its first and last point. Points are sorted by
/// `value`; two points at the same value make a step.
///
/// `color` and `opacity` describe pigment particles, `filter` the transmittance of the clear medium they float in (sweep §4.1). The
/// defaults for `ior` (1) and `filter` (white) make plain Porter–Duff volume rendering.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct TransferFunction {
    /// Thickness of the layer that `opacity` and `filter` are stated for; the smallest voxel edge if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "world units", "exclusiveMinimum" = 0))]
    pub reference_length: Option<f32>,
    /// Reflectance of particles; white if empty.
    pub color: Vec<ColorPoint>,
    /// Opacity of particles; a ramp over the volume's range, outliers left out, if empty.
    pub opacity: Vec<OpacityPoint>,
    /// Index of refraction; `surroundings.ior` if empty.
    pub ior: Vec<IorPoint>,
    /// Transmittance of the clear medium that particles float in; white if empty.
    pub filter: Vec<ColorPoint>,
}

impl TransferFunction {
    /// Whether colours bend differently somewhere.
    #[must_use]
    pub fn disperses(&self) -> bool {
        self.ior.iter().any(|point| point.cauchy_coefficient() != 0.0)
    }
}

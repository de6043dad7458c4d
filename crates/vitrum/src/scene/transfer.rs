//! Transfer functions: piecewise linear over the physical scalar.

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A colour at a scalar value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ColorPoint {
    /// Scalar value, in the volume's physical unit.
    pub value: f32,
    /// Linear RGB, 0 to 1.
    #[schemars(inner(range(min = 0, max = 1)))]
    pub color: Rgb,
}

/// An opacity at a scalar value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OpacityPoint {
    /// Scalar value, in the volume's physical unit.
    pub value: f32,
    /// Opacity of a layer as thick as the reference length, 0 to 1.
    #[schemars(range(min = 0, max = 1))]
    pub opacity: f32,
}

/// An index of refraction at a scalar value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct IorPoint {
    /// Scalar value, in the (index) volume's physical unit.
    pub value: f32,
    /// Index of refraction relative to the surroundings, 0.2 to 5.
    #[schemars(range(min = 0.2, max = 5))]
    pub ior: f32,
    /// Abbe number V_d: how little `ior`, which is then that of yellow light (587.6 nm), differs between colours. 5 to 1000; glass has
    /// 20 to 90. All colours bend alike if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 5, max = 1000))]
    pub abbe: Option<f32>,
    /// Cauchy's B in µm², 0 to 0.1, instead of `abbe`: η(λ) = A + B/λ².
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0, max = 0.1))]
    pub cauchy_b: Option<f32>,
}

/// Four piecewise linear functions over the scalar, each constant beyond its first and last point. Points are sorted by
/// `value`; two points at the same value make a step.
///
/// `color` and `opacity` describe pigment particles, `medium` the colour of the filter they float in (sweep §4.1). The
/// defaults for `ior` (1) and `medium` (white) make plain Porter–Duff volume rendering.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct TransferFunction {
    /// Thickness, in world units, of the layer that `opacity` and `medium` are stated for, above 0; the
    /// smallest voxel edge if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub reference_length: Option<f32>,
    /// Particle colour. White if empty.
    pub color: Vec<ColorPoint>,
    /// Particle opacity. A ramp over the volume's range if empty.
    pub opacity: Vec<OpacityPoint>,
    /// Index of refraction. 1 if empty.
    pub ior: Vec<IorPoint>,
    /// Medium colour: the share of light a layer of the reference length lets pass. White if empty.
    pub medium: Vec<ColorPoint>,
}

impl TransferFunction {
    /// Whether colours bend differently somewhere.
    #[must_use]
    pub fn disperses(&self) -> bool {
        self.ior.iter().any(|point| point.cauchy_coefficient() != 0.0)
    }
}

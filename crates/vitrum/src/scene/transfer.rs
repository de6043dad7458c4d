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

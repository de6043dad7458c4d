//! Specular reflection, ambient light, and what is shown of the scalars along a ray.

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What is shown of the scalars along a viewing ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BlendMode {
    /// Every part of the way through colour, opacity, filter and refraction, in light.
    #[default]
    Composite,
    /// The largest scalar (maximum intensity projection).
    Maximum,
    /// The smallest scalar.
    Minimum,
    /// The mean of the scalar over the length of the way.
    Mean,
}

/// Specular reflection (Cook–Torrance, GGX; sweep §4.3) and ambient light.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Shading {
    /// What a picture of a volume shows of the scalars along a viewing ray, by method `sweep`. All but `composite` show one scalar of the way inside
    /// the volume, the crop box and the clipping planes, in the colour and with the opacity that `transfer` gives it for one reference length, without
    /// light, ground, wall, filter and refraction.
    pub blend_mode: BlendMode,
    /// Roughness of specular reflection (GGX); 0.02 is polished.
    #[schemars(range(min = 0.02, max = 1))]
    pub roughness: f32,
    /// Factor on specular reflection; 0 turns it off.
    #[schemars(range(min = 0, max = 100))]
    pub specular: f32,
    /// Radiance that reaches every particle and receiver from all sides, linear RGB.
    #[schemars(inner(range(min = 0, max = 1e6)), extend("x-unit" = "radiance"))]
    pub ambient: Rgb,
}

impl Default for Shading {
    fn default() -> Self {
        Self { blend_mode: BlendMode::Composite, roughness: 0.25, specular: 1.0, ambient: [0.08, 0.08, 0.08] }
    }
}

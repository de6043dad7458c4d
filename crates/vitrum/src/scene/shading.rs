//! Specular reflection and ambient light.

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Specular reflection (Cook–Torrance, GGX; sweep §4.3) and ambient light.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Shading {
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
        Self { roughness: 0.25, specular: 1.0, ambient: [0.08, 0.08, 0.08] }
    }
}

//! Specular reflection and ambient light.

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Specular reflection (Cook–Torrance, GGX; sweep §4.3) and ambient light.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Shading {
    /// GGX roughness, 0.02 (polished) to 1.
    #[schemars(range(min = 0.02, max = 1))]
    pub roughness: f32,
    /// Factor on the specular term, 0 to 100; 0 turns it off.
    #[schemars(range(min = 0, max = 100))]
    pub specular: f32,
    /// Radiance that reaches every particle and receiver from all sides; linear RGB, each 0 to 1e6.
    #[schemars(inner(range(min = 0, max = 1e6)))]
    pub ambient: Rgb,
}

impl Default for Shading {
    fn default() -> Self {
        Self { roughness: 0.25, specular: 1.0, ambient: [0.08, 0.08, 0.08] }
    }
}

//! What bodies of a mesh are made of.

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A clear material.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Material {
    /// The material of the mesh that this one stands for; all that are not named if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Index of refraction, 1 to 4.
    #[schemars(range(min = 1, max = 4))]
    pub ior: f32,
    /// Linear RGB, each 0.001 to 1, that is left of white light on its way through `attenuation_distance`.
    #[schemars(inner(range(min = 0.001, max = 1)))]
    pub attenuation_color: Rgb,
    /// In world units, above 0; the mesh's longest edge if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub attenuation_distance: Option<f32>,
}

impl Default for Material {
    fn default() -> Self {
        Self { name: None, ior: 1.5, attenuation_color: [1.0; 3], attenuation_distance: None }
    }
}

//! What bodies of a mesh are made of.

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A material, clear or opaque.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Material {
    /// The material of the mesh that this one stands for; all that are not named if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Whether the body is opaque and reflects light diffusely, instead of being clear.
    pub opaque: bool,
    /// Of an opaque body: linear RGB, each 0 to 1, of the light that it reflects. If absent what the mesh says of its vertices or of the
    /// material, else a light grey.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(inner(range(min = 0, max = 1)))]
    pub color: Option<Rgb>,
    /// Of an opaque body: how much light each of its triangles absorbs in the shadow map, 0 to 1000, times
    /// [`super::Shadow::absorption`]. With the default nothing gets through.
    #[schemars(range(min = 0, max = 1000))]
    pub density: f32,
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
        Self {
            name: None,
            opaque: false,
            color: None,
            density: 16.0,
            ior: 1.5,
            attenuation_color: [1.0; 3],
            attenuation_distance: None,
        }
    }
}

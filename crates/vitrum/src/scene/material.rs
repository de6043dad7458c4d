//! The materials of a mesh's bodies.

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A material, clear, opaque or mirroring.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Material {
    /// Name of the mesh's material that the entry stands for; if absent all materials that no other entry names.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a name"))]
    pub name: Option<String>,
    /// Whether the body is opaque and reflects light diffusely, on both sides of its surface, instead of being clear.
    pub opaque: bool,
    /// Whether the body is opaque and reflects light like a polished metal.
    pub mirror: bool,
    /// Diffuse reflectance of an opaque body, linear RGB; if absent that of the mesh's vertices, or of its material
    /// (`Kd`, base colour), or a light grey. Specular reflectance of a mirror; if absent that of the mesh's material, or 0.95.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(inner(range(min = 0, max = 1)), extend("x-unit" = "reflectance"))]
    pub color: Option<Rgb>,
    /// Factor on the optical depth `shadow.optical_depth` of each triangle of an opaque body. 16 is solid; leaves, of
    /// which light goes through many, have less than 1. A triangle that is lit from behind shows the light that it lets
    /// through.
    #[schemars(range(min = 0, max = 1000))]
    pub density: f32,
    /// Index of refraction of a clear body.
    #[schemars(range(min = 1, max = 4))]
    pub ior: f32,
    /// Abbe number V_d of a clear body: the smaller, the more blue bends than red, as crown glass (60), diamond (55) and
    /// flint glass (30) do. `ior` is then that of yellow light (587.6 nm), and the picture takes the time of one frame for
    /// each of `voxels.wavelengths`, `beams.wavelengths` or `sweep.wavelengths`. All colours bend alike if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 5, max = 1000))]
    pub abbe: Option<f32>,
    /// Coefficient B of Cauchy's η(λ) = A + B/λ², instead of `abbe`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0, max = 0.1), extend("x-unit" = "µm²"))]
    pub cauchy_b: Option<f32>,
    /// Transmittance of a clear body `attenuation_distance` thick, linear RGB.
    #[schemars(inner(range(min = 0.001, max = 1)), extend("x-unit" = "transmittance"))]
    pub attenuation_color: Rgb,
    /// Thickness that `attenuation_color` is stated for; the longest edge of the mesh, or of all meshes together, if
    /// absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "world units", "exclusiveMinimum" = 0))]
    pub attenuation_distance: Option<f32>,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            name: None,
            opaque: false,
            mirror: false,
            color: None,
            density: 16.0,
            ior: 1.5,
            abbe: None,
            cauchy_b: None,
            attenuation_color: [1.0; 3],
            attenuation_distance: None,
        }
    }
}

//! Diffuse and specular reflection, ambient light, and the quantity of the scalars along a ray that is shown.

use super::{Light, Rgb};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The quantity by which opaque matter in a volume is shaded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Diffuse {
    /// The light that arrives, which matter in front of it attenuates (sweep §4.2).
    Light,
    /// That light times the cosine between it and the gradient of the scalar, as of a surface (Levoy 1988, Eq. 3).
    Gradient,
}

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

/// Diffuse reflection, specular reflection (Cook–Torrance, GGX; sweep §4.3) and ambient light.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Shading {
    /// Quantity by which opaque matter in a volume is shaded; if absent `gradient` by lights without shadows, which leave it flat, else `light`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diffuse: Option<Diffuse>,
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
        Self {
            diffuse: None,
            blend_mode: BlendMode::Composite,
            roughness: 0.25,
            specular: 1.0,
            ambient: [0.08, 0.08, 0.08],
        }
    }
}

impl Shading {
    /// Whether `light` shades opaque matter by the gradient of the scalar.
    pub(crate) fn is_by_gradient(&self, light: &Light) -> bool {
        self.diffuse.map_or(!light.shadows, |diffuse| diffuse == Diffuse::Gradient)
    }
}

//! A participating medium around and in what is shown.

use super::{Rgb, VolumeSource};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A participating medium: it absorbs light and scatters it into other directions. No method renders one yet.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Medium {
    /// Absorption coefficient σ_a, linear RGB, where the density is 1.
    #[schemars(inner(range(min = 0, max = 1e6)), extend("x-unit" = "1 / world unit"))]
    pub absorption: Rgb,
    /// Scattering coefficient σ_s, linear RGB, where the density is 1.
    #[schemars(inner(range(min = 0, max = 1e6)), extend("x-unit" = "1 / world unit"))]
    pub scattering: Rgb,
    /// Mean cosine g of the angle that light is scattered by (Henyey and Greenstein 1941): 0 is equally to all sides, positive forward.
    #[schemars(range(min = -0.99, max = 0.99))]
    pub anisotropy: f32,
    /// Volume whose scalar is the density, a factor on both coefficients; 1 everywhere if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub density: Option<VolumeSource>,
}

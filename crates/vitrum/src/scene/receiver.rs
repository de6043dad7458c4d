//! Diffuse receivers: crisp planes that show shadow and caustics (sweep, Figs. 6 and 8).

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A horizontal plane below the volume.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Ground {
    /// Height along the camera's `up`, in world units; the volume's lowest point if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height: Option<f32>,
    /// Diffuse reflectance, linear RGB, 0 to 1.
    #[schemars(inner(range(min = 0, max = 1)))]
    pub color: Rgb,
}

impl Default for Ground {
    fn default() -> Self {
        Self { height: None, color: [0.7, 0.7, 0.7] }
    }
}

/// A vertical plane behind the volume.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Wall {
    /// Distance from the volume's centre, in world units, above 0; the volume's bounding radius if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub distance: Option<f32>,
    /// Degrees around `up` of the direction the wall faces, like the camera's azimuth.
    pub azimuth: f32,
    /// Diffuse reflectance, linear RGB, 0 to 1.
    #[schemars(inner(range(min = 0, max = 1)))]
    pub color: Rgb,
}

impl Default for Wall {
    fn default() -> Self {
        Self { distance: None, azimuth: 0.0, color: [0.7, 0.7, 0.7] }
    }
}

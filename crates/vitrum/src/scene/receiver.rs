//! Diffuse receivers: crisp planes that show shadow and caustics (sweep, Figs. 6 and 8).

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A horizontal plane below the volume.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Ground {
    /// Height along `camera.up`; the lowest point of the volume or mesh if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "world units"))]
    pub height: Option<f32>,
    /// Diffuse reflectance, linear RGB.
    #[schemars(inner(range(min = 0, max = 1)), extend("x-unit" = "reflectance"))]
    pub color: Rgb,
    /// Whether the plane itself is left out of the picture, and its shadows and caustics stay on the scene's `background`, which this needs; by methods `sweep`
    /// and `voxels`. In an alpha they are the share that is dark. The picture is rendered with and without the plane, and takes twice as long.
    pub shadow_catcher: bool,
}

impl Default for Ground {
    fn default() -> Self {
        Self { height: None, color: [0.7, 0.7, 0.7], shadow_catcher: false }
    }
}

/// A vertical plane behind the volume.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Wall {
    /// Distance from the centre of the volume or mesh; its bounding radius if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "world units", "exclusiveMinimum" = 0))]
    pub distance: Option<f32>,
    /// Direction that the wall faces, an angle around `camera.up` as the camera's azimuth.
    #[schemars(extend("x-unit" = "degrees"))]
    pub azimuth: f32,
    /// Diffuse reflectance, linear RGB.
    #[schemars(inner(range(min = 0, max = 1)), extend("x-unit" = "reflectance"))]
    pub color: Rgb,
}

impl Default for Wall {
    fn default() -> Self {
        Self { distance: None, azimuth: 0.0, color: [0.7, 0.7, 0.7] }
    }
}

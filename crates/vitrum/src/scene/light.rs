//! The one distant light.

use super::{Rgb, Vector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What the light turns with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Attachment {
    /// Angles and direction are relative to the camera.
    #[default]
    Camera,
    /// Angles and direction are in world space.
    World,
}

/// A distant light. It must shine away from the camera: at most 85° from the viewing direction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Light {
    /// `camera` or `world`.
    pub attachment: Attachment,
    /// Degrees to the side the light comes from: 0 is from the camera (or, in the world, from the front), positive from the right.
    pub azimuth: f32,
    /// Degrees above the horizon the light comes from, −90 to 90.
    #[schemars(range(min = -90, max = 90))]
    pub elevation: f32,
    /// The direction the light travels in; replaces `azimuth` and `elevation`. In the camera's axes (x right, y up, z towards
    /// the viewer) or the world's, by `attachment`; of any length but 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<Vector>,
    /// Linear RGB, each 0 to 1e6.
    #[schemars(inner(range(min = 0, max = 1e6)))]
    pub color: Rgb,
    /// Factor on `color`, 0 to 1e6.
    #[schemars(range(min = 0, max = 1e6))]
    pub intensity: f32,
    /// Whether the volume casts shadows, colours light and focuses it. `false` leaves the light unoccluded everywhere, without
    /// caustics, and takes much less time.
    pub shadows: bool,
    /// Half-angle of the light source in degrees, 0 (crisp) to 45.
    #[schemars(range(min = 0, max = 45))]
    pub softness: f32,
    /// Light texels per pixel edge, 0.125 to 4.
    #[schemars(range(min = 0.125, max = 4))]
    pub resolution: f32,
    /// Margin of the light grid around what it covers, as a share of its size, 0 to 1.
    #[schemars(range(min = 0, max = 1))]
    pub margin: f32,
}

impl Default for Light {
    fn default() -> Self {
        Self {
            attachment: Attachment::Camera,
            azimuth: -35.0,
            elevation: 40.0,
            direction: None,
            color: [1.0, 1.0, 1.0],
            intensity: 1.0,
            shadows: true,
            softness: 1.0,
            resolution: 0.75,
            margin: 0.05,
        }
    }
}

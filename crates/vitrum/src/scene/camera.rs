//! The camera orbits a target; view space looks along −z.

use super::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a pixel becomes a viewing ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Projection {
    /// Rays leave one eye point.
    #[default]
    Perspective,
    /// Rays are parallel.
    Orthographic,
}

/// Where the picture is taken from: an orbit around `target`, or an explicit `position`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Camera {
    /// `perspective` or `orthographic`.
    pub projection: Projection,
    /// Degrees around `up`, counted from the front (for scans, the patient's front; world +y), positive to the viewer's right.
    pub azimuth: f32,
    /// Degrees above the horizon, −89 to 89.
    #[schemars(range(min = -89, max = 89))]
    pub elevation: f32,
    /// Degrees by which the camera turns around its viewing direction, positive counter-clockwise.
    pub roll: f32,
    /// Magnification, 0.01 to 100; 1 shows the whole volume.
    #[schemars(range(min = 0.01, max = 100))]
    pub zoom: f32,
    /// Vertical field of view in degrees, 1 to 120 (perspective only).
    #[schemars(range(min = 1, max = 120))]
    pub field_of_view: f32,
    /// The world point in the middle of the picture; the volume's centre if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<Vector>,
    /// The eye's world position; replaces `azimuth`, `elevation` and `zoom`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<Vector>,
    /// The world direction that is up in the picture, of any length but 0.
    pub up: Vector,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            projection: Projection::Perspective,
            azimuth: 25.0,
            elevation: 15.0,
            roll: 0.0,
            zoom: 1.0,
            field_of_view: 30.0,
            target: None,
            position: None,
            up: [0.0, 0.0, 1.0],
        }
    }
}

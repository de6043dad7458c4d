//! The camera orbits a target; view space looks along −z.

use super::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Projection: the viewing ray of a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Projection {
    /// Viewing rays leave one eye point.
    #[default]
    Perspective,
    /// Viewing rays are parallel.
    Orthographic,
}

/// Framing: what a picture with `zoom` 1 shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Framing {
    /// The sphere around the whole volume or mesh, at a distance at which a box face on fills the picture well and corners may touch its edge: the same
    /// from all sides.
    #[default]
    Whole,
    /// All of what is visible from this side, and little more: what the transfer function shows or bends light by, less specks and what is clipped
    /// away, or the vertices of the mesh. A ground without `height` lies under it.
    Visible,
}

/// The camera: on an orbit around `target`, or at an explicit `position`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Camera {
    /// Form of the viewing rays.
    pub projection: Projection,
    /// What the picture shows where `zoom` is 1 and neither `distance` nor `position` is given. Files of volumes and meshes alone are shown with `visible`;
    /// turntables then take the distance that suits all sides.
    pub framing: Framing,
    /// Angle around `up`, from the front (world +y; for scans the patient's front), positive to the viewer's right.
    #[schemars(extend("x-unit" = "degrees"))]
    pub azimuth: f32,
    /// Angle above the horizon.
    #[schemars(range(min = -89, max = 89), extend("x-unit" = "degrees"))]
    pub elevation: f32,
    /// Angle by which the camera turns around its viewing direction, positive counter-clockwise.
    #[schemars(extend("x-unit" = "degrees"))]
    pub roll: f32,
    /// Magnification; 1 shows what `framing` says where neither `distance` nor `position` is given. In perspective it divides the tangent of
    /// half the field of view, and the eye stays where it is.
    #[schemars(range(min = 0.01, max = 100))]
    pub zoom: f32,
    /// Vertical field of view where `zoom` is 1; perspective only.
    #[schemars(range(min = 1, max = 120), extend("x-unit" = "degrees"))]
    pub field_of_view: f32,
    /// Distance of the eye from `target`; perspective only. If absent, the distance at which `field_of_view`, or its part in the width of a picture
    /// that is higher than wide, shows what `framing` says.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1e-6, max = 1e6), extend("x-unit" = "world units"))]
    pub distance: Option<f64>,
    /// Point in the middle of the picture; if absent the centre of the volume or mesh, or of what is visible.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "world units"))]
    pub target: Option<Vector>,
    /// Position of the eye. It replaces `azimuth`, `elevation` and `distance`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "world units"))]
    pub position: Option<Vector>,
    /// World direction that is up in the picture, of any length but 0.
    #[schemars(extend("x-range" = "three numbers, not all 0"))]
    pub up: Vector,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            projection: Projection::Perspective,
            framing: Framing::Whole,
            azimuth: 25.0,
            elevation: 15.0,
            roll: 0.0,
            zoom: 1.0,
            field_of_view: 30.0,
            distance: None,
            target: None,
            position: None,
            up: [0.0, 0.0, 1.0],
        }
    }
}

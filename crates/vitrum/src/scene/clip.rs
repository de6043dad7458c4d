//! Clipping planes.

use super::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The effect of a clipping plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Removes {
    /// Opacity alone: the clear medium stays and goes on bending light (sweep, Fig. 9).
    Opacity,
    /// Opacity, filter and refraction.
    #[default]
    Everything,
}

/// A half-space that is cut away: all points further than `offset` along `normal` from the volume's centre.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Clip {
    /// Normal of the plane, into the half-space that is removed, of any length but 0; world axes.
    #[schemars(extend("x-range" = "three numbers, not all 0"))]
    pub normal: Vector,
    /// Signed distance of the plane from the volume's centre, along `normal`.
    #[schemars(extend("x-unit" = "world units"))]
    pub offset: f32,
    /// Properties that are removed.
    pub removes: Removes,
}

impl Default for Clip {
    fn default() -> Self {
        Self { normal: [0.0, 1.0, 0.0], offset: 0.0, removes: Removes::Everything }
    }
}

//! Clipping planes.

use super::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a clipping plane takes away.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Removes {
    /// Opacity only: the medium stays and goes on bending light (sweep, Fig. 9).
    Opacity,
    /// Everything: opacity, medium and refraction.
    #[default]
    Everything,
}

/// A half-space that is cut away: all points further than `offset` along `normal` from the volume's centre.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Clip {
    /// Points into the half-space that is removed; world axes, any length but 0.
    pub normal: Vector,
    /// Signed distance of the plane from the volume's centre along `normal`, in world units.
    pub offset: f32,
    /// `opacity` or `everything`.
    pub removes: Removes,
}

impl Default for Clip {
    fn default() -> Self {
        Self { normal: [0.0, 1.0, 0.0], offset: 0.0, removes: Removes::Everything }
    }
}

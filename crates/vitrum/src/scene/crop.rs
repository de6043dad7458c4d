//! The crop box.

use super::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A box along the volume's own axes, outside which there is nothing: no opacity, filter, refraction or shadow. Light is bent at its faces as at
/// those of a volume that ends there.
///
/// Corners are in shares of the volume along its axes, as its voxels are stored: 0 is the outer face of the first voxel, 1 that of the last one. A
/// position p in voxels from the centre of the first one is (p + ½) / n of n voxels.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Crop {
    /// Low corner.
    #[schemars(inner(range(min = 0, max = 1)), extend("x-unit" = "shares of the volume"))]
    pub min: Vector,
    /// High corner, above the low one on each axis.
    #[schemars(inner(range(min = 0, max = 1)), extend("x-unit" = "shares of the volume"))]
    pub max: Vector,
}

impl Default for Crop {
    fn default() -> Self {
        Self { min: [0.0; 3], max: [1.0; 3] }
    }
}

//! Settings of the voxelization of a mesh, which both methods use.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Voxelization of a mesh, for rays through voxels and for a plane sweep alike.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Voxelization {
    /// Number of voxels along the longest edge of the mesh; the box around it has five more on each side, and 2^30 at most for all its clear
    /// materials together (1013 for a cube of one).
    #[schemars(range(min = 8, max = 2048), extend("x-unit" = "voxels"))]
    pub resolution: u32,
}

impl Default for Voxelization {
    fn default() -> Self {
        Self { resolution: 256 }
    }
}

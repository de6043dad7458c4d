//! The shadow that a mesh casts (voxels §3).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a voxel of the shadow map absorbs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Coefficient {
    /// As much as the triangles in it, by their number and material (Chang et al. 2010).
    #[default]
    Counted,
    /// The same wherever there is anything (Eisemann & Décoret 2006), for comparison.
    Uniform,
}

/// How light is attenuated on its way through a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Shadow {
    /// Voxels of the shadow map along the longest edge of the mesh's box in the light's direction, 16 to 1024.
    #[schemars(range(min = 16, max = 1024))]
    pub resolution: u32,
    /// `counted` or `uniform`.
    pub coefficient: Coefficient,
    /// Optical depth of a triangle of density 1 that light goes through, or of an occupied voxel where the coefficient is uniform;
    /// 0 to 100. What is left behind it is e to the power of minus that.
    #[schemars(range(min = 0, max = 100))]
    pub absorption: f32,
    /// World units, 0 to 1e6: light is averaged over columns that are up to so far away across it, 15 voxels at most.
    #[schemars(range(min = 0, max = 1e6))]
    pub softness: f32,
}

impl Default for Shadow {
    fn default() -> Self {
        Self { resolution: 256, coefficient: Coefficient::Counted, absorption: 1.0, softness: 0.0 }
    }
}

//! How rays go through a mesh of clear materials (voxels §4).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The surfaces that a ray is followed through.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Surfaces {
    /// Two, where it enters and where it leaves (Wyman 2005).
    Two,
    /// All, up to `bounces`.
    #[default]
    Multi,
    /// All, of the triangles themselves: no voxels.
    Exact,
}

/// Where the normals of voxels come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Normals {
    /// From how much of the neighbouring voxels is inside.
    #[default]
    Filtered,
    /// The sum of the triangles' that meet the voxel, as in the paper.
    Paper,
}

/// How rays go through a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Voxels {
    /// Voxels along the mesh's longest edge, 8 to 2048; of the box around it, five more on each side, 2^30 at most for all its clear materials together (1013 for a cube of one).
    #[schemars(range(min = 8, max = 2048))]
    pub resolution: u32,
    /// `two`, `multi` or `exact`.
    pub surfaces: Surfaces,
    /// Surfaces that a ray may be refracted or reflected at, 1 to 64, where `surfaces` is not `two`.
    #[schemars(range(min = 1, max = 64))]
    pub bounces: u32,
    /// `filtered` or `paper`. Where `surfaces` is `exact` and the mesh has no normals: between the triangles', or the triangles' own.
    pub normals: Normals,
    /// By how much a voxel reaches over its neighbours where triangles meet it, 0 to 1 of its edge, with the paper's normals: slices
    /// overlap, so that no ray slips between two voxels of a surface.
    #[schemars(range(min = 0, max = 1))]
    pub overlap: f32,
    /// Degrees, 0 to 90: two surfaces whose normals differ by less are taken for one that was met twice, within two voxels or, with
    /// the paper's normals, anywhere.
    #[schemars(range(min = 0, max = 90))]
    pub threshold: f32,
    /// Whether surfaces reflect, as they must (Fresnel); `false` lets all light through that is not reflected totally.
    pub reflection: bool,
}

impl Default for Voxels {
    fn default() -> Self {
        Self {
            resolution: 256,
            surfaces: Surfaces::Multi,
            bounces: 16,
            normals: Normals::Filtered,
            overlap: 0.0,
            threshold: 30.0,
            reflection: true,
        }
    }
}

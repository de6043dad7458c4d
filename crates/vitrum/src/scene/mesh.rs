//! The mesh that is shown instead of a volume.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A triangle mesh on disk, or one that Vitrum computes, whose surface encloses bodies.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MeshSource {
    /// An OBJ, PLY, STL or glTF file; a relative path starts at the scene file's folder. Exactly one of `file` and `builtin` is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<std::path::PathBuf>,
    /// A procedural mesh by name, e.g. `vase` or `torus`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub builtin: Option<String>,
    /// The direction that is turned to point up: `x`, `-x`, `y`, `-y`, `z`, `-z`. If absent `y` for OBJ and glTF, else `z`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub up: Option<String>,
    /// Degrees, −3600 to 3600, by which the mesh's top is turned against its bottom about the upright line through its middle. The mesh
    /// is made into voxels anew for each value.
    #[schemars(range(min = -3600, max = 3600))]
    pub twist: f32,
}

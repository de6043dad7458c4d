//! The mesh that the method `voxels` shows.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A triangle mesh on disk, whose surface encloses clear bodies.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshSource {
    /// An OBJ, PLY, STL or glTF file; a relative path starts at the scene file's folder.
    pub file: std::path::PathBuf,
    /// The direction that is turned to point up: `x`, `-x`, `y`, `-y`, `z`, `-z`. If absent `y` for OBJ and glTF, else `z`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub up: Option<String>,
}

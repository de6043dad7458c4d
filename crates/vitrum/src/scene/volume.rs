//! Where voxels come from.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A volume on disk, or one that Vitrum computes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct VolumeSource {
    /// A file; a relative path starts at the scene file's folder. Exactly one of `file` and `builtin` is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<std::path::PathBuf>,
    /// A procedural volume by name, e.g. `glass` or `supernova`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub builtin: Option<String>,
    /// Voxels along the longest edge of a procedural volume (16 to 1024); ignored for files.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 16, max = 1024))]
    pub resolution: Option<u32>,
    /// Replaces the file's voxel spacing (world units, each > 0).
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("items" = { "type": "number", "format": "float", "exclusiveMinimum": 0 }))]
    pub spacing: Option<[f32; 3]>,
}

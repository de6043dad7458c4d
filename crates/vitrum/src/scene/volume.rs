//! Where voxels come from.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A volume on disk, or one that Vitrum computes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct VolumeSource {
    /// A file, or a folder of DICOM files; a relative path starts at the scene file's folder, and `-` is standard input.
    /// Exactly one of `file` and `builtin` is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<std::path::PathBuf>,
    /// A procedural volume by name, e.g. `glass` or `supernova`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub builtin: Option<String>,
    /// Voxels along the longest edge of a procedural volume (16 to 2048); ignored for files.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 16, max = 2048))]
    pub resolution: Option<u32>,
    /// Replaces the file's voxel spacing (world units, each > 0).
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("items" = { "type": "number", "format": "float", "exclusiveMinimum": 0 }))]
    pub spacing: Option<[f32; 3]>,
    /// How a file without a header is laid out: `WxHxD:TYPE`, then perhaps `:le` or `:be` and `:skip=BYTES`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub raw: Option<String>,
    /// The array to show of a VTK or NumPy file with several, or the number of a channel of a TIFF file, counted from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub array: Option<String>,
    /// The point in time to show of a file with several, counted from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0, max = 1_000_000_000))]
    pub time: Option<u32>,
    /// The direction that is turned to point up: `x`, `-x`, `y`, `-y`, `z`, `-z`, or `right`, `left`, `anterior`,
    /// `posterior`, `superior`, `inferior`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub up: Option<String>,
}

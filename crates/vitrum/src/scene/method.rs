//! The name of the method that makes a picture.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The method that makes a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MethodName {
    /// A plane sweep through a volume, or through the volumes that are made of meshes.
    #[default]
    Sweep,
    /// Rays through the voxels or triangles of meshes.
    Voxels,
}

impl MethodName {
    /// Every name.
    pub const ALL: [Self; 2] = [Self::Sweep, Self::Voxels];

    /// The name in scene files.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Sweep => "sweep",
            Self::Voxels => "voxels",
        }
    }
}

//! The name of the method that makes a picture, and the parts of a scene that the method renders.

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

    /// The parts of a scene that the method renders.
    #[must_use]
    pub const fn capabilities(self) -> Capabilities {
        match self {
            Self::Sweep => {
                Capabilities { volumes: true, streaming: true, meshes: true, opaque_bodies: false, clipping: true }
            }
            Self::Voxels => {
                Capabilities { volumes: false, streaming: false, meshes: true, opaque_bodies: true, clipping: false }
            }
        }
    }
}

/// The parts of a scene that a method renders; a scene with another part is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Capabilities {
    /// Volumes.
    pub volumes: bool,
    /// Volumes of more bytes than the device's memory, streamed in parts.
    pub streaming: bool,
    /// Meshes.
    pub meshes: bool,
    /// Opaque bodies of a mesh.
    pub opaque_bodies: bool,
    /// Clipping planes.
    pub clipping: bool,
}

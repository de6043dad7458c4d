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
    /// Beams of light that clear and mirroring bodies send through a scattering medium.
    Beams,
}

impl MethodName {
    /// Every name.
    pub const ALL: [Self; 3] = [Self::Sweep, Self::Voxels, Self::Beams];

    /// The name in scene files.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Sweep => "sweep",
            Self::Voxels => "voxels",
            Self::Beams => "beams",
        }
    }

    /// The parts of a scene that the method renders.
    #[must_use]
    pub const fn capabilities(self) -> Capabilities {
        match self {
            Self::Sweep => Capabilities {
                volumes: true,
                streaming: true,
                meshes: true,
                opaque_bodies: false,
                mirrors: false,
                clipping: true,
                placed_lights: true,
                medium: false,
                medium_density: false,
            },
            Self::Voxels => Capabilities {
                volumes: false,
                streaming: false,
                meshes: true,
                opaque_bodies: true,
                mirrors: false,
                clipping: false,
                placed_lights: true,
                medium: false,
                medium_density: false,
            },
            Self::Beams => Capabilities {
                volumes: false,
                streaming: false,
                meshes: true,
                opaque_bodies: true,
                mirrors: true,
                clipping: false,
                placed_lights: true,
                medium: true,
                medium_density: true,
            },
        }
    }

    /// The first method that renders what `part` picks; messages advise it.
    pub(crate) fn that_renders(part: impl Fn(Capabilities) -> bool) -> Option<Self> {
        Self::ALL.into_iter().find(|method| part(method.capabilities()))
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
    /// Mirroring bodies of a mesh.
    pub mirrors: bool,
    /// Clipping planes.
    pub clipping: bool,
    /// Lights that have a place: points and spots.
    pub placed_lights: bool,
    /// A participating medium.
    pub medium: bool,
    /// A participating medium whose density is a volume.
    pub medium_density: bool,
}

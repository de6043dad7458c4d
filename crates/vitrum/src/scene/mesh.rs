//! The meshes that are shown instead of a volume.

use super::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A triangle mesh on disk, or one that Vitrum computes, whose surface encloses bodies, and its place.
///
/// It is turned upright, scaled and rotated about its own origin, then moved: a point p of the file comes to
/// `position` + R · `scale` · U p.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MeshSource {
    /// OBJ, PLY, STL or glTF file; a relative path starts at the scene file's folder. Exactly one of `file` and `builtin`
    /// is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a path"))]
    pub file: Option<std::path::PathBuf>,
    /// Procedural mesh: `vase`, `angel-ball`, `goblet`, `still-life`, `torus`, `tree`, `ball`, `ring`, `gem`,
    /// `waves`, `statue`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a name"))]
    pub builtin: Option<String>,
    /// Direction that is turned to point up, as `volume.up`; if absent y for OBJ and glTF, else z.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "an axis"))]
    pub up: Option<String>,
    /// Factor on the mesh's size.
    #[schemars(range(max = 1e6), extend("exclusiveMinimum" = 0))]
    pub scale: f32,
    /// Angles by which the mesh is rotated about the world's x axis, then about y, then about z, each counterclockwise for a
    /// viewer that the axis points at.
    #[schemars(extend("x-unit" = "degrees"))]
    pub rotation: Vector,
    /// Place that the mesh's own origin is moved to.
    #[schemars(extend("x-unit" = "world units"))]
    pub position: Vector,
    /// Name of an entry of `material` that all of this mesh's bodies take, whatever its file names; a mesh without it keeps its
    /// own materials.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a name"))]
    pub material: Option<String>,
    /// Angle by which the mesh's top is turned against its bottom, about the upright line through its middle, after it has been
    /// placed. It may change from frame to frame, and the mesh is made into voxels anew for each; only a mesh that is alone can
    /// be twisted.
    #[schemars(range(min = -3600, max = 3600), extend("x-unit" = "degrees"))]
    pub twist: f32,
    /// Moment at which a built-in mesh that moves is shown, 0 if absent; other meshes have none. `waves` moves: its waves travel as waves of gravity
    /// in deep water do, ω² = g k with g = 9.81 m/s², where a world unit is a metre, so that at a larger `scale` they are longer and
    /// slower. It may change from frame to frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "seconds"))]
    pub time: Option<f32>,
}

impl Default for MeshSource {
    fn default() -> Self {
        Self {
            file: None,
            builtin: None,
            up: None,
            scale: 1.0,
            rotation: [0.0; 3],
            position: [0.0; 3],
            material: None,
            twist: 0.0,
            time: None,
        }
    }
}

//! How a mesh becomes voxels.

/// What is inside a surface that crosses itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FillRule {
    /// Where the surface winds about a point at all: where bodies overlap is inside, and a cavity is where a part within faces the
    /// other way. Which way the surface as a whole faces does not matter.
    #[default]
    Nonzero,
    /// Where it takes an odd number of crossings to get out: where two bodies overlap is outside, whichever way they face.
    EvenOdd,
}

/// How a mesh becomes voxels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Voxels along the mesh's longest edge, from 1.
    pub resolution: u32,
    /// Empty voxels around the mesh.
    pub padding: u32,
    /// By how much a voxel reaches over its neighbours for the surface, as a part of its edge, 0 to 1 (§4.1.1 of the paper, which
    /// enlarges slices along their axis alone).
    pub overlap: f32,
    /// Whether the voxels that triangles meet are marked.
    pub surface: bool,
    /// Whether counts, normals, colours and materials are summed up; implies `surface`.
    pub attributes: bool,
    /// Whether and how the inside is filled.
    pub solid: Option<FillRule>,
}

impl Settings {
    /// The surface alone.
    #[must_use]
    pub fn new(resolution: u32) -> Self {
        Self { resolution, padding: 1, overlap: 0.0, surface: true, attributes: false, solid: None }
    }
}

//! Settings of the voxelization of a mesh.

/// The fill rule: the inside of a surface that crosses itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FillRule {
    /// Nonzero: a point is inside where the surface's winding number is not 0. The overlap of bodies is inside, and a part within that
    /// faces the other way makes a cavity. The surface as a whole may face either way.
    #[default]
    Nonzero,
    /// Even-odd: a point is inside where a ray from it crosses the surface an odd number of times. The overlap of two bodies is
    /// outside, whichever way they face.
    EvenOdd,
}

/// Settings of the voxelization of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Voxels along the mesh's longest edge, from 1.
    pub resolution: u32,
    /// Empty voxels around the mesh.
    pub padding: u32,
    /// Overlap of a voxel with its neighbours where triangles meet it, in edges of a voxel, 0 to 1 (§4.1.1 of the paper, which enlarges
    /// slices along their axis alone).
    pub overlap: f32,
    /// Whether the voxels that triangles meet are marked.
    pub surface: bool,
    /// Whether counts, normals, colours and materials are summed up; implies `surface`.
    pub attributes: bool,
    /// Whether and how the inside is filled.
    pub solid: Option<FillRule>,
}

impl Settings {
    /// Settings for the surface alone.
    #[must_use]
    pub fn new(resolution: u32) -> Self {
        Self { resolution, padding: 1, overlap: 0.0, surface: true, attributes: false, solid: None }
    }
}

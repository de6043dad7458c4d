//! Triangle meshes and the files that hold them: OBJ, PLY, STL and glTF.
//!
//! The readers are written here rather than taken from libraries: `docs/adr/0015-readers-of-our-own.md` says why.

mod build;
mod check;
mod content;
#[cfg(feature = "gltf")]
mod gltf;
mod material;
mod measure;
#[cfg(feature = "obj")]
mod obj;
#[cfg(feature = "ply")]
mod ply;
mod reader;
pub(crate) mod registry;
#[cfg(feature = "stl")]
mod stl;
mod strip;
mod subdivide;
mod topology;
mod triangulate;
mod weld;
mod words;

pub use material::Material;
pub use reader::MeshReader;
pub use registry::{mesh_readers, open_mesh, open_mesh_bytes};
pub use topology::Topology;

use glam::DVec3;

use crate::error::Error;
use crate::source::Source;

/// Triangles in space that share their vertices.
///
/// Where a file gives a vertex several normals, as along a crease, the vertex is there several times, at positions
/// that are equal to the bit. [`Self::topology`] takes those for one point.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Name for messages: the file's.
    pub name: String,
    /// The vertices, in the file's units, each coordinate finite.
    pub positions: Vec<[f32; 3]>,
    /// Three indices into [`Self::positions`] each; seen from the outside they run counterclockwise.
    pub triangles: Vec<[u32; 3]>,
    /// A vector of length 1 for each vertex, or 0 where the file gives that vertex none.
    pub normals: Option<Vec<[f32; 3]>>,
    /// Linear RGB and alpha for each vertex. What files hold as integers, and as text in OBJ, is taken for sRGB and
    /// decoded; floats of PLY and all colours of glTF are linear already. Alpha is never decoded.
    pub colors: Option<Vec<[f32; 4]>>,
    /// Materials of the triangles; empty where the format knows none or the file names none.
    pub materials: Vec<Material>,
    /// For each triangle, an index into [`Self::materials`]; empty for a mesh without materials.
    pub triangle_materials: Vec<u32>,
    /// Origin of the mesh; the sample type is the coordinates' type.
    pub source: Source,
}

impl Mesh {
    /// A mesh of positions and triangles alone.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`] where there is no triangle, where a position is not finite or beyond ±1e18, and where a
    /// triangle names a vertex that is not there.
    pub fn new(name: impl Into<String>, positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>) -> Result<Self, Error> {
        let name = name.into();
        check::check(&name, &positions, &triangles)?;
        Ok(Self {
            name,
            positions,
            triangles,
            normals: None,
            colors: None,
            materials: Vec::new(),
            triangle_materials: Vec::new(),
            source: Source::default(),
        })
    }

    /// Bytes of memory that vertices and triangles take.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.positions)
            + size_of_val(&*self.triangles)
            + self.normals.as_deref().map_or(0, size_of_val)
            + self.colors.as_deref().map_or(0, size_of_val)
            + size_of_val(&*self.triangle_materials)
    }

    /// The corners of a triangle in float64. The index is below the count of triangles.
    fn corners(&self, triangle: &[u32; 3]) -> [DVec3; 3] {
        triangle.map(|vertex| DVec3::from(self.positions[vertex as usize].map(f64::from)))
    }
}

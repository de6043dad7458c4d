//! The interface of mesh file formats.

use super::Mesh;
use crate::error::Error;
use crate::formats::Format;
use crate::input::Input;
use crate::options::OpenOptions;

/// One mesh file format. A new one is a folder of its own, an entry in `src/formats.rs` and a line in
/// [`crate::mesh_readers`].
pub trait MeshReader: Sync {
    /// The format's name and extensions. Behind each extension may stand `.gz` or `.zst`.
    fn format(&self) -> &'static Format;

    /// Whether a file is of this format by its first bytes, seen through its packing, and its size.
    fn recognises(&self, input: &Input) -> bool;

    /// Reads the mesh.
    ///
    /// # Errors
    ///
    /// Those of [`crate::open_mesh`].
    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Mesh, Error>;
}

//! The surface of a mesh.

use crate::error::Error;
use crate::unrenderable::Unrenderable;
use vitrum_io::Mesh;

/// Whether a mesh has a surface.
///
/// # Errors
/// [`Error::Unrenderable`] where no triangle has an area.
pub(in crate::method) fn check_mesh(mesh: &Mesh) -> Result<(), Error> {
    if mesh.surface_area() > 0.0 {
        return Ok(());
    }
    Err(Unrenderable::NoSurface { name: mesh.name.clone(), count: mesh.triangles.len() }.into())
}

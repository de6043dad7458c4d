//! Opening a mesh file of any format: the content decides, the extension only helps.

use std::path::Path;

use super::Mesh;
use super::reader::MeshReader;
use crate::error::{Error, Place, Report};
use crate::formats::{self, MESH_FORMATS};
use crate::input::Input;
use crate::options::OpenOptions;

/// The formats of meshes that this build reads, in the order in which readers are asked.
#[must_use]
pub fn mesh_readers() -> &'static [&'static dyn MeshReader] {
    &[
        #[cfg(feature = "ply")]
        &super::ply::Ply,
        #[cfg(feature = "gltf")]
        &super::gltf::Gltf,
        #[cfg(feature = "stl")]
        &super::stl::Stl,
        #[cfg(feature = "obj")]
        &super::obj::Obj,
    ]
}

/// Reads the mesh at `path`, whatever its format. Whole files may be compressed by gzip or zstd.
///
/// # Errors
///
/// [`Error::Unreadable`] where the file cannot be read, [`Error::Unsupported`] where its format or something in it is
/// not known here, [`Error::LeftOut`] where this build has no reader of its format, [`Error::Invalid`] where it contradicts its
/// format, holds no triangle, or holds positions that are not finite, and [`Error::TooLarge`] where the decompressed file and the
/// mesh would together not fit `options`; that is found before any memory is taken for them.
pub fn open_mesh(path: &Path, options: &OpenOptions) -> Result<Mesh, Error> {
    read(&Input::new(path, options)?, options)
}

/// Reads a mesh from the bytes of its file, whatever its format. `name` is the file's name, which decides the format as it does
/// in [`open_mesh`], and stands in messages. The materials of an OBJ file, which lie in a file beside it, have their names alone.
///
/// # Errors
///
/// Those of [`open_mesh`]; [`Error::Unsupported`] also where a glTF file names buffers in further files.
pub fn open_mesh_bytes(name: &str, bytes: &[u8], options: &OpenOptions) -> Result<Mesh, Error> {
    read(&Input::of_bytes(name, bytes), options)
}

fn read(input: &Input, options: &OpenOptions) -> Result<Mesh, Error> {
    let report = Report::new(&input.name);
    let left_out = |name: &str| formats::left_out(MESH_FORMATS, &input.head, name);
    let name = input.packing.strip(&input.name);
    if input.is_folder() {
        return Err(unknown(report));
    }
    if let Some(reader) = by_content(input) {
        return reader.read(input, options);
    }
    if let Some(format) = left_out("") {
        return Err(report.left_out(format));
    }
    match (by_extension(input), left_out(name)) {
        (Some(reader), _) => reader.read(input, options),
        (None, Some(format)) => Err(report.left_out(format)),
        (None, None) => Err(unknown(report)),
    }
}

fn unknown(report: Report) -> Error {
    report.unsupported(
        Place::File,
        "neither the content nor the extension is of a known mesh format",
        format!("convert it to one of: {}", formats::described(mesh_readers().iter().map(|reader| reader.format()))),
    )
}

/// The reader that recognises a file's first bytes.
pub(crate) fn by_content(input: &Input) -> Option<&'static dyn MeshReader> {
    mesh_readers().iter().copied().find(|reader| reader.recognises(input))
}

/// The reader whose extension a file has.
pub(crate) fn by_extension(input: &Input) -> Option<&'static dyn MeshReader> {
    let name = input.packing.strip(&input.name);
    mesh_readers().iter().copied().find(|reader| reader.format().has_extension(name))
}

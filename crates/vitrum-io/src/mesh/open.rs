//! Opening a mesh file of any format: the content decides, the extension only helps.

use std::path::Path;

use super::Mesh;
use super::build::Builder;
use super::content::{self, Budget};
use super::gltf::Gltf;
use super::obj::Obj;
use super::ply::Ply;
use super::stl::Stl;
use crate::error::{Error, Place, Report};
use crate::input::Input;
use crate::open::{OpenOptions, readers};

/// One mesh file format. A new one is a folder of its own and a line in [`mesh_readers`].
pub trait MeshReader: Sync {
    /// The format's name, such as `PLY`.
    fn name(&self) -> &'static str;

    /// Its file extensions: lower case, with the dot. Behind each may stand `.gz` or `.zst`.
    fn extensions(&self) -> &'static [&'static str];

    /// Whether a file is of this format by its first bytes, seen through gzip, and its size.
    fn recognises(&self, input: &Input) -> bool;

    /// Reads it.
    ///
    /// # Errors
    ///
    /// Those of [`open_mesh`].
    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Mesh, Error>;
}

/// All formats, in the order in which they are asked.
#[must_use]
pub fn mesh_readers() -> &'static [&'static dyn MeshReader] {
    &[&Ply, &Gltf, &Stl, &Obj]
}

/// Whether `path` is a mesh's file rather than a volume's, as far as its first bytes and its extension tell.
///
/// # Errors
///
/// Those of [`Input::new`].
pub fn is_mesh(path: &Path) -> Result<bool, Error> {
    Ok(looks_like_mesh(&Input::new(path, &OpenOptions::default())?))
}

/// [`is_mesh`] of a file that was looked at.
pub(crate) fn looks_like_mesh(input: &Input) -> bool {
    let volume = || readers().iter().any(|reader| reader.recognises(&input.head, input.path));
    !input.is_folder() && (by_content(input).is_some() || by_extension(input).is_some() && !volume())
}

/// Reads the mesh at `path`, whatever its format. Whole files may be compressed by gzip or zstd.
///
/// # Errors
///
/// [`Error::Unreadable`] where the file cannot be read, [`Error::Unsupported`] where its format or something in it is
/// not known here, [`Error::Invalid`] where it contradicts its format, holds no triangle, or holds positions that are
/// not finite, and [`Error::TooLarge`] where the decompressed file and the mesh would together not fit `options`; that
/// is found before any memory is taken for them.
pub fn open_mesh(path: &Path, options: &OpenOptions) -> Result<Mesh, Error> {
    let input = Input::new(path, options)?;
    match by_content(&input).or_else(|| by_extension(&input)) {
        Some(reader) if !input.is_folder() => reader.read(&input, options),
        _ => Err(Report::new(&input.name).unsupported(
            Place::File,
            "neither the content nor the extension is of a known mesh format",
            format!("convert it to one of: {}", known_formats()),
        )),
    }
}

fn by_content(input: &Input) -> Option<&'static dyn MeshReader> {
    mesh_readers().iter().copied().find(|reader| reader.recognises(input))
}

fn by_extension(input: &Input) -> Option<&'static dyn MeshReader> {
    let name = input.packing.strip(&input.name).to_ascii_lowercase();
    let fits = |reader: &&dyn MeshReader| reader.extensions().iter().any(|extension| name.ends_with(extension));
    mesh_readers().iter().copied().find(fits)
}

fn known_formats() -> String {
    let described =
        mesh_readers().iter().map(|reader| format!("{} ({})", reader.name(), reader.extensions().join(", ")));
    described.collect::<Vec<_>>().join(", ")
}

/// The file's bytes and an empty mesh: how every reader starts.
pub(super) fn start<'a>(input: &'a Input, options: &OpenOptions) -> Result<(Vec<u8>, Builder<'a>), Error> {
    let report = Report::new(&input.name);
    let mut budget = Budget::new(report, options);
    let bytes = content::read(input, &mut budget)?;
    Ok((bytes, Builder::new(report, budget)))
}

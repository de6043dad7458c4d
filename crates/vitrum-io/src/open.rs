//! Opening a volume file of any format: the content decides, the extension only helps.

use std::fs::{self, File};
use std::io::{BufReader, Read};
use std::path::Path;

use flate2::read::MultiGzDecoder;

use crate::error::{Error, Place, Report};
use crate::mesh::is_mesh;
use crate::metaimage::MetaImage;
use crate::nifti::Nifti;
use crate::nrrd::Nrrd;
use crate::numpy::Numpy;
use crate::raw::Raw;
use crate::samples::read_up_to;
use crate::stack::Stack;
use crate::volume::Volume;
use crate::vti::Vti;
use crate::vtk::Vtk;

/// What a caller may set about reading.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct OpenOptions {
    /// Most bytes that the decoded voxels may take, or the decompressed file and the mesh in it together; the memory
    /// available where it is `None`.
    pub max_bytes: Option<u64>,
}

/// One volume file format. A new one is a file of its own and a line in [`readers`].
pub trait VolumeReader: Sync {
    /// The format's name, such as `NRRD`.
    fn name(&self) -> &'static str;

    /// Its file extensions: lower case, with the dot.
    fn extensions(&self) -> &'static [&'static str];

    /// Whether a file is of this format by its first bytes, at most 1024, seen through gzip.
    fn recognises(&self, head: &[u8], path: &Path) -> bool;

    /// Reads it.
    ///
    /// # Errors
    ///
    /// Those of [`open`].
    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error>;
}

/// All formats, in the order in which they are asked.
#[must_use]
pub fn readers() -> &'static [&'static dyn VolumeReader] {
    &[&Nrrd, &Nifti, &MetaImage, &Numpy, &Vti, &Vtk, &Stack, &Raw]
}

/// A file about to be read.
#[derive(Debug)]
pub struct Input<'a> {
    /// Its path.
    pub path: &'a Path,
    /// Its name for messages, without folders.
    pub name: String,
    /// Its size in bytes; 0 for a folder.
    pub length: u64,
    /// Its first bytes, at most 1024, decompressed where the whole file is gzip.
    pub head: Vec<u8>,
    /// Whether the whole file is gzip.
    pub gzipped: bool,
}

impl<'a> Input<'a> {
    /// Looks at the file, or the folder, at `path`.
    ///
    /// # Errors
    ///
    /// [`Error::Unreadable`] where it is not there or not ours to read; [`Error::Unsupported`]
    /// where it is neither a file nor a folder, since a pipe or a device has no size to check.
    pub fn new(path: &'a Path) -> Result<Self, Error> {
        const HEAD: u64 = 1024;
        let name = display_name(path);
        let report = Report::new(&name);
        let unreadable = |error| report.unreadable(error);
        let metadata = fs::metadata(path).map_err(unreadable)?;
        let mut head = Vec::new();
        let mut gzipped = false;
        if metadata.is_file() {
            let open = || File::open(path).map(BufReader::new).map_err(unreadable);
            open()?.take(HEAD).read_to_end(&mut head).map_err(unreadable)?;
            gzipped = head.starts_with(&[0x1f, 0x8b]);
            if gzipped {
                let mut inflated = vec![0; HEAD as usize];
                // A damaged stream shows as far as it goes; the reader reports the damage.
                let (filled, _) = read_up_to(&mut MultiGzDecoder::new(open()?), &mut inflated);
                inflated.truncate(filled);
                head = inflated;
            }
        } else if !metadata.is_dir() {
            return Err(report.unsupported(
                Place::File,
                "this is a pipe or a device",
                "save its content to a file first",
            ));
        }
        let length = if metadata.is_file() { metadata.len() } else { 0 };
        Ok(Self { path, name, length, head, gzipped })
    }
}

/// Reads the volume at `path`, whatever its format.
///
/// # Errors
///
/// [`Error::Unreadable`] where the file cannot be read, [`Error::Unsupported`] where its format or
/// something in it is not known here, [`Error::Invalid`] where it contradicts its format, and
/// [`Error::TooLarge`] where its voxels would not fit `options`; that is found before any memory
/// is taken for them.
pub fn open(path: &Path, options: &OpenOptions) -> Result<Volume, Error> {
    let input = Input::new(path)?;
    let extension_fits = |reader: &&&dyn VolumeReader| {
        let name = input.name.to_ascii_lowercase();
        reader.extensions().iter().any(|extension| name.ends_with(extension))
    };
    let by_content = readers().iter().find(|reader| reader.recognises(&input.head, path));
    match by_content.or_else(|| readers().iter().find(extension_fits)) {
        Some(reader) => reader.read(&input, options),
        None => Err(Report::new(&input.name).unsupported(
            Place::File,
            if path.is_dir() {
                "this is a folder without a known series of files"
            } else if is_mesh(path)? {
                "this is a mesh, and volumes alone are read here"
            } else {
                "neither the content nor the extension is of a known volume format"
            },
            format!("convert it to one of: {}", known_formats()),
        )),
    }
}

fn known_formats() -> String {
    let described = readers().iter().map(|reader| format!("{} ({})", reader.name(), reader.extensions().join(", ")));
    described.collect::<Vec<_>>().join(", ")
}

/// The last part of a path, for messages.
pub(crate) fn display_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

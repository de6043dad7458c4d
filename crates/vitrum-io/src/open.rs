//! Opening a volume file of any format: the content decides, the extension only helps.

use std::path::Path;

use crate::dicom::Dicom;
use crate::error::{Error, Place, Report};
use crate::input::Input;
use crate::mesh::looks_like_mesh;
use crate::metaimage::MetaImage;
use crate::nifti::Nifti;
use crate::nrrd::Nrrd;
use crate::numpy::{Npz, Numpy};
use crate::raw::{Raw, RawLayout};
use crate::stack::Stack;
use crate::up::Up;
use crate::volume::Volume;
use crate::vti::Vti;
use crate::vtk::Vtk;

/// What a caller may set about reading.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct OpenOptions {
    /// Most bytes that the decoded voxels may take, or the decompressed file and the mesh in it together, and likewise a file
    /// that has to be unpacked or comes by standard input; the memory available where it is `None`.
    pub max_bytes: Option<u64>,
    /// Reads the file as voxels without a header, laid out like this, whatever it looks like.
    pub raw: Option<RawLayout>,
    /// Replaces the file's spacing; the middle of the grid stays where it is.
    pub spacing: Option<[f32; 3]>,
    /// The array to read of a file with several.
    pub array: Option<String>,
    /// The point in time to read of a file with several, counted from 0.
    pub time: Option<u32>,
    /// The world direction that is to point up; the volume is turned for it.
    pub up: Option<Up>,
}

impl OpenOptions {
    /// Applies what is set here of a volume's place, its spacing and its up.
    ///
    /// # Errors
    ///
    /// Those of [`Volume::with_spacing`].
    pub fn place(&self, mut volume: Volume) -> Result<Volume, Error> {
        if let Some(spacing) = self.spacing {
            volume = volume.with_spacing(spacing)?;
        }
        Ok(match self.up {
            Some(up) => volume.turned(up),
            None => volume,
        })
    }
}

/// What can be picked out of the files of a format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// [`OpenOptions::array`].
    Array,
    /// [`OpenOptions::time`].
    Time,
}

/// One volume file format. A new one is a file of its own and a line in [`readers`].
pub trait VolumeReader: Sync {
    /// The format's name, such as `NRRD`.
    fn name(&self) -> &'static str;

    /// Its file extensions: lower case, with the dot.
    fn extensions(&self) -> &'static [&'static str];

    /// Whether a file is of this format by its first bytes, at most 1024, unpacked; of a folder, by
    /// what lies in it.
    fn recognises(&self, head: &[u8], path: &Path) -> bool;

    /// What [`OpenOptions`] can pick out of a file.
    fn parts(&self) -> &'static [Part] {
        &[]
    }

    /// Whether it unpacks whole files while it reads them; others get them unpacked.
    fn unpacks(&self) -> bool {
        false
    }

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
    &[&Nrrd, &Nifti, &MetaImage, &Numpy, &Npz, &Vti, &Vtk, &Dicom, &Stack, &Raw]
}

/// Reads the volume at `path`, whatever its format; [`crate::STANDARD_INPUT`] stands for standard input.
///
/// # Errors
///
/// [`Error::Unreadable`] where the file cannot be read, [`Error::Unsupported`] where its format or
/// something in it is not known here, [`Error::Invalid`] where it contradicts its format, and
/// [`Error::TooLarge`] where its voxels would not fit `options`; that is found before any memory
/// is taken for them.
pub fn open(path: &Path, options: &OpenOptions) -> Result<Volume, Error> {
    let mut input = Input::new(path, options)?;
    let reader = choose(&input, options)?;
    refuse_parts(&input, reader, options)?;
    if !reader.unpacks() {
        input.unpack(options)?;
    }
    options.place(reader.read(&input, options)?)
}

fn choose(input: &Input, options: &OpenOptions) -> Result<&'static dyn VolumeReader, Error> {
    if options.raw.is_some() && !input.is_folder() {
        return Ok(&Raw);
    }
    let name = input.packing.strip(&input.name).to_ascii_lowercase();
    let extension_fits =
        |reader: &&&dyn VolumeReader| reader.extensions().iter().any(|extension| name.ends_with(extension));
    let by_content = readers().iter().find(|reader| reader.recognises(&input.head, input.path));
    let by_name = || readers().iter().filter(|_| !input.is_folder()).find(extension_fits);
    by_content.or_else(by_name).copied().ok_or_else(|| {
        let (problem, advice) = if input.is_folder() {
            (
                "this is a folder without DICOM or TIFF files, and without DICOM files below it",
                "give a folder that has them, TIFF files in it and not below it, or a file",
            )
        } else if looks_like_mesh(input) {
            (
                "this is a mesh, and volumes alone are read here",
                "make a volume of it by `vitrum voxelize`, or say by --raw how voxels without a header are laid out",
            )
        } else {
            ("neither the content nor the extension is of a known volume format", "")
        };
        let advice = match advice {
            "" => format!(
                "convert it to one of: {}; or say by --raw how voxels without a header are laid out",
                known_formats()
            ),
            advice => advice.to_owned(),
        };
        Report::new(&input.name).unsupported(Place::File, problem, advice)
    })
}

/// Nobody should believe to have picked something that the format does not have.
fn refuse_parts(input: &Input, reader: &dyn VolumeReader, options: &OpenOptions) -> Result<(), Error> {
    let name = reader.name();
    let refuse =
        |problem: String, advice: &str| Err(Report::new(&input.name).unsupported(Place::File, problem, advice));
    if let Some(array) = &options.array
        && !reader.parts().contains(&Part::Array)
    {
        let problem = format!("the array `{array}` is asked for, and the format {name} has no arrays with names");
        return refuse(problem, "leave out the array");
    }
    match options.time {
        Some(time) if time > 0 && !reader.parts().contains(&Part::Time) => {
            let problem = format!("the point in time {time} is asked for, and only one is read of the format {name}");
            refuse(problem, "leave out the time, or give 0")
        }
        _ => Ok(()),
    }
}

fn known_formats() -> String {
    let described = readers().iter().map(|reader| format!("{} ({})", reader.name(), reader.extensions().join(", ")));
    described.collect::<Vec<_>>().join(", ")
}

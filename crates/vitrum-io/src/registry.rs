//! Opening a file of any format: the content decides, the extension only helps.

use std::path::Path;

use crate::error::{Error, Found, Place, Report};
use crate::formats::{self, Format, VOLUME_FORMATS};
use crate::input::Input;
use crate::labels;
use crate::mesh::registry as mesh;
use crate::options::{OpenOptions, Part};
use crate::reader::VolumeReader;
use crate::setting::Setting;
use crate::volume::Volume;

/// The formats of volumes that this build reads, in the order in which readers are asked.
#[must_use]
pub fn readers() -> &'static [&'static dyn VolumeReader] {
    &[
        #[cfg(feature = "nrrd")]
        &crate::nrrd::Nrrd,
        #[cfg(feature = "nifti")]
        &crate::nifti::Nifti,
        #[cfg(feature = "metaimage")]
        &crate::metaimage::MetaImage,
        #[cfg(feature = "numpy")]
        &crate::numpy::Numpy,
        #[cfg(feature = "numpy")]
        &crate::numpy::Npz,
        #[cfg(feature = "vti")]
        &crate::vti::Pvd,
        #[cfg(feature = "vti")]
        &crate::vti::Vti,
        #[cfg(feature = "vtk")]
        &crate::vtk::Vtk,
        #[cfg(feature = "dicom")]
        &crate::dicom::Dicom,
        #[cfg(feature = "tiff")]
        &crate::stack::Stack,
        #[cfg(feature = "raw")]
        &crate::raw::Raw,
    ]
}

/// Reads the volume at `path`, whatever its format; [`crate::STANDARD_INPUT`] stands for standard input.
///
/// # Errors
///
/// [`Error::Unreadable`] where the file cannot be read, [`Error::UnknownFormat`] and [`Error::LeftOut`] where its format is not
/// known here, [`Error::Unsupported`] where something in it is not, [`Error::UnknownLayout`] of voxels without a header,
/// [`Error::Invalid`] where it contradicts its format, and [`Error::TooLarge`] where its voxels would not fit `options`; that is
/// found before any memory is taken for them.
pub fn open(path: &Path, options: &OpenOptions) -> Result<Volume, Error> {
    read(Input::new(path, options)?, options)
}

/// Reads a volume from the bytes of its file, whatever its format. `name` is the file's name, which decides the format as it does
/// in [`open`], and stands in messages.
///
/// # Errors
///
/// Those of [`open`]; [`Error::Unsupported`] also where the data lies in further files, which such a header names.
pub fn open_bytes(name: &str, bytes: &[u8], options: &OpenOptions) -> Result<Volume, Error> {
    read(Input::of_bytes(name, bytes), options)
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
fn looks_like_mesh(input: &Input) -> bool {
    let volume = || readers().iter().any(|reader| reader.recognises(input));
    !input.is_folder() && (mesh::by_content(input).is_some() || mesh::by_extension(input).is_some() && !volume())
}

fn read(mut input: Input, options: &OpenOptions) -> Result<Volume, Error> {
    let reader = choose(&input, options)?;
    refuse_parts(&input, reader, options)?;
    if !reader.unpacks() {
        input.unpack(options)?;
    }
    let mut volume = reader.read(&input, options)?;
    labels::tell(&mut volume);
    options.place(volume)
}

fn choose(input: &Input, options: &OpenOptions) -> Result<&'static dyn VolumeReader, Error> {
    #[cfg(feature = "raw")]
    if options.raw.is_some() && !input.is_folder() {
        return Ok(&crate::raw::Raw);
    }
    if options.raw.is_some() && !formats::RAW.included {
        return Err(Report::new(&input.name).left_out(&formats::RAW));
    }
    let name = input.packing.strip(&input.name);
    let by_content = readers().iter().find(|reader| reader.recognises(input));
    let left_out = |by_name: &str| formats::left_out(VOLUME_FORMATS, &input.head, by_name);
    let by_name = || readers().iter().find(|reader| !input.is_folder() && reader.format().has_extension(name));
    if let Some(reader) = by_content {
        return Ok(*reader);
    }
    // The content of a file tells more than its name, also where it tells a format that is left out.
    if let Some(format) = left_out("") {
        return Err(Report::new(&input.name).left_out(format));
    }
    if let Some(reader) = by_name() {
        return Ok(*reader);
    }
    match left_out(name) {
        Some(format) if !input.is_folder() => Err(Report::new(&input.name).left_out(format)),
        _ => Err(unknown(input)),
    }
}

fn unknown(input: &Input) -> Error {
    let found = match () {
        () if input.is_folder() => Found::Folder,
        () if looks_like_mesh(input) => Found::Mesh,
        () => Found::Unknown,
    };
    let known = readers().iter().map(|reader| reader.format());
    Error::UnknownFormat { file: input.name.clone(), found, expected: formats::described(known) }
}

/// Fails where a part is asked for that the format does not have.
fn refuse_parts(input: &Input, reader: &dyn VolumeReader, options: &OpenOptions) -> Result<(), Error> {
    let Format { name, .. } = reader.format();
    let report = Report::new(&input.name);
    if let Some(array) = &options.array
        && !reader.parts().contains(&Part::Array)
    {
        let problem = format!("the array `{array}` is asked for, and the format {name} has no arrays with names");
        return Err(report.unsupported(Place::File, problem, "leave out the array").with_setting(Setting::Array));
    }
    if let Some(seconds) = options.seconds
        && !reader.parts().contains(&Part::Time)
    {
        let problem =
            format!("the moment {seconds} s is asked for, and only one point in time is read of the format {name}");
        return Err(report.unsupported(Place::File, problem, "leave out the time").with_setting(Setting::Time));
    }
    match options.time {
        Some(time) if time > 0 && !reader.parts().contains(&Part::Time) => {
            let problem = format!("the point in time {time} is asked for, and only one is read of the format {name}");
            let advice = "leave out the time, or give 0";
            Err(report.unsupported(Place::File, problem, advice).with_setting(Setting::Time))
        }
        _ => Ok(()),
    }
}

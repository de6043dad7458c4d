//! Writing a volume as NRRD or NumPy, so that other programs can read what Vitrum has read.

use std::path::Path;

use crate::atomic_write::create_beside;
use crate::error::{Error, Place, Report};
use crate::formats::{Format, NRRD, NUMPY};
use crate::input::display_name;
use crate::volume::Volume;

/// A format that volumes are written in.
struct Writer {
    extension: &'static str,
    format: &'static Format,
    write: fn(Report, &Path, &Volume) -> Result<(), Error>,
}

const WRITERS: &[Writer] = &[
    Writer { extension: "nrrd", format: &NRRD, write: write_nrrd },
    Writer { extension: "npy", format: &NUMPY, write: write_npy },
];

#[cfg(feature = "nrrd")]
fn write_nrrd(_report: Report, path: &Path, volume: &Volume) -> Result<(), Error> {
    use crate::nrrd::{Lattice, Samples, write_nrrd};
    write_nrrd(path, &Lattice::of(volume), Samples::Volume(volume), &[])
}

#[cfg(not(feature = "nrrd"))]
fn write_nrrd(report: Report, _path: &Path, _volume: &Volume) -> Result<(), Error> {
    Err(report.left_out(&NRRD))
}

#[cfg(feature = "numpy")]
use crate::numpy::write_npy;

#[cfg(not(feature = "numpy"))]
fn write_npy(report: Report, _path: &Path, _volume: &Volume) -> Result<(), Error> {
    Err(report.left_out(&NUMPY))
}

/// Writes a volume's physical values in the format that the extension of `path` names.
///
/// | Extension | What is written |
/// |---|---|
/// | `.nrrd` | gzip, with spacing, origin and axes; the space is right-anterior-superior for a patient, 3D-right-handed for another world, and not named where [`Volume::orientation`] is unknown |
/// | `.npy` | an array of the shape (z, y, x), without its place in the world |
///
/// Values are whole numbers of the smallest type of 8 or 16 bits that holds all of them where they were stored as whole
/// numbers, and float32 otherwise. The file appears at `path` whole or not at all.
///
/// # Errors
///
/// [`Error::Unsupported`] where the extension is unknown, [`Error::LeftOut`] where this build does not write the format,
/// [`Error::Write`] where the operating system fails.
pub fn write_volume(path: &Path, volume: &Volume) -> Result<(), Error> {
    let name = display_name(path);
    let report = Report::new(&name);
    volume.require_whole("a file of the volume")?;
    (writer(report, path)?.write)(report, path, volume)
}

/// Whether [`write_volume`] could write to `path` now.
///
/// # Errors
///
/// Those of [`write_volume`].
pub fn check_volume_writable(path: &Path) -> Result<(), Error> {
    let name = display_name(path);
    let report = Report::new(&name);
    writer(report, path)?;
    create_beside(report, path).map(drop)
}

fn writer(report: Report, path: &Path) -> Result<&'static Writer, Error> {
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    match WRITERS.iter().find(|writer| writer.extension == extension) {
        Some(writer) if writer.format.included => Ok(writer),
        Some(writer) => Err(report.left_out(writer.format)),
        None => Err(report.unsupported(
            Place::File,
            format!("`.{extension}` is no volume format that is written"),
            "use one of .nrrd, .npy",
        )),
    }
}

//! Writing a picture: checked first, then encoded into memory, or beside its path and renamed.

use std::io::{self, Cursor};
use std::path::Path;

use super::check::{check_metadata, check_picture};
use super::format::PictureFormat;
use super::options::{Metadata, WriteOptions, check_options};
use super::picture::Picture;
use crate::atomic_write::{Sink, Staged, create_beside, stage_whole};
use crate::error::{Error, Report};
use crate::input::display_name;

/// Writes a picture in the format that the extension of `path` names, with default options.
///
/// | Extension | What is written |
/// |---|---|
/// | `.png` | the first layer as sRGB in 8 bits, with straight alpha where it has one |
/// | `.exr` | every layer as float32, each a part with its name |
/// | `.hdr` | the first layer's colour, shared-exponent RGBE |
/// | `.jpg`, `.jpeg` | the first layer's colour as sRGB |
/// | `.tif`, `.tiff` | the first layer as float32, with straight alpha where it has one; of a vector X, Y, Z in the places of R, G, B |
///
/// Vectors are written by OpenEXR and TIFF alone: the others hold no negative values.
///
/// `metadata` is kept by PNG, as `iTXt` chunks, and by OpenEXR, as string attributes; the other
/// formats drop it. The file appears at `path` whole or not at all.
///
/// # Errors
///
/// [`Error::Unsupported`] where the extension is unknown, [`Error::LeftOut`] where this build leaves out its format,
/// [`Error::Write`] where the picture or the
/// metadata cannot be written so, or where the operating system fails.
pub fn write_picture(path: &Path, picture: &Picture, metadata: &[(String, String)]) -> Result<(), Error> {
    write_picture_with(path, picture, metadata, &WriteOptions::default())
}

/// As [`write_picture`], with options.
///
/// # Errors
///
/// Those of [`write_picture`], and [`Error::Write`] for options out of range.
pub fn write_picture_with(
    path: &Path,
    picture: &Picture,
    metadata: &[(String, String)],
    options: &WriteOptions,
) -> Result<(), Error> {
    stage_picture_with(path, picture, metadata, options)?.put()
}

/// As [`write_picture_with`], up to the moment when the file appears at `path`.
///
/// # Errors
///
/// Those of [`write_picture_with`].
pub fn stage_picture_with(
    path: &Path,
    picture: &Picture,
    metadata: &[(String, String)],
    options: &WriteOptions,
) -> Result<Staged, Error> {
    let name = display_name(path);
    let report = Report::new(&name);
    let format = PictureFormat::named(report, path)?;
    check(report, picture, format, metadata, *options)?;
    stage_whole(report, path, |sink| encode(sink, picture, format, metadata, *options))
}

/// The bytes of a picture's file, as [`write_picture_with`] writes them.
///
/// # Errors
///
/// [`Error::LeftOut`] where this build leaves out the format, [`Error::Write`] where the picture, the metadata or the options
/// cannot be written so.
pub fn encode_picture(
    picture: &Picture,
    format: PictureFormat,
    metadata: &[(String, String)],
    options: &WriteOptions,
) -> Result<Vec<u8>, Error> {
    let name = format!("{} picture", format.format().name);
    let report = Report::new(&name);
    if !format.format().included {
        return Err(report.left_out(format.format()));
    }
    check(report, picture, format, metadata, *options)?;
    let mut bytes = Cursor::new(Vec::new());
    encode(&mut bytes, picture, format, metadata, *options)
        .map_err(|error| report.write(error.to_string(), "write it in another format", Some(error)))?;
    Ok(bytes.into_inner())
}

/// Whether [`write_picture`] could write to `path` now; worth asking before a long render.
///
/// Creates and removes an empty file beside `path`, the one sure way to know.
///
/// # Errors
///
/// [`Error::Unsupported`] where the extension is unknown, [`Error::Write`] where the folder is not
/// there or not writable, or where `path` is a folder.
pub fn check_writable(path: &Path) -> Result<(), Error> {
    let name = display_name(path);
    let report = Report::new(&name);
    PictureFormat::named(report, path)?;
    create_beside(report, path).map(drop)
}

/// Whether values beyond 0 to 1, such as lengths in world units, can be written in the format that the extension of `path` names.
///
/// # Errors
///
/// [`Error::Unsupported`] where the extension is unknown, [`Error::Write`] where the format clips them.
pub fn check_holds_lengths(path: &Path, name: &str) -> Result<(), Error> {
    let shown = display_name(path);
    let report = Report::new(&shown);
    if !PictureFormat::named(report, path)?.clips() {
        return Ok(());
    }
    let problem = format!("`{name}` goes beyond 1, and this format holds values from 0 to 1");
    Err(report.write(problem, "write it to .exr or .tif", None))
}

/// Whether a vector called `name` can be written in the format that the extension of `path` names.
///
/// # Errors
///
/// [`Error::Unsupported`] where the extension is unknown, [`Error::Write`] where the format holds no negative values.
pub fn check_holds_vectors(path: &Path, name: &str) -> Result<(), Error> {
    let shown = display_name(path);
    let report = Report::new(&shown);
    check_signs(report, name, PictureFormat::named(report, path)?)
}

/// Fails where a picture cannot be written so.
fn check(
    report: Report,
    picture: &Picture,
    format: PictureFormat,
    metadata: &Metadata,
    options: WriteOptions,
) -> Result<(), Error> {
    check_options(report, options)?;
    check_picture(report, picture)?;
    if let Some(layer) = picture.layers.first().filter(|layer| layer.is_vector()) {
        check_signs(report, &layer.name, format)?;
    }
    check_metadata(report, metadata)
}

/// Encodes a picture that [`check`] let through.
#[allow(unused_variables, reason = "without any of the formats")]
fn encode(
    sink: &mut dyn Sink,
    picture: &Picture,
    format: PictureFormat,
    metadata: &Metadata,
    options: WriteOptions,
) -> io::Result<()> {
    match format {
        #[cfg(feature = "png")]
        PictureFormat::Png => super::png::encode(sink, picture, metadata, options),
        #[cfg(feature = "exr")]
        PictureFormat::Exr => super::exr::encode(sink, picture, metadata),
        #[cfg(feature = "hdr")]
        PictureFormat::Hdr => super::hdr::encode(sink, picture),
        #[cfg(feature = "jpeg")]
        PictureFormat::Jpeg => super::jpeg::encode(sink, picture, options),
        #[cfg(feature = "tiff")]
        PictureFormat::Tiff => super::tiff::encode(sink, picture),
        // Formats that are left out are refused before.
        #[allow(unreachable_patterns)]
        _ => Err(io::ErrorKind::Unsupported.into()),
    }
}

/// Fails for a vector in a format without negative values, which would lose half of its values silently.
fn check_signs(report: Report, name: &str, format: PictureFormat) -> Result<(), Error> {
    if format.is_signed() {
        return Ok(());
    }
    let problem = format!("`{name}` is a vector, and this format holds no negative values");
    Err(report.write(problem, "write it to .exr or .tif", None))
}

//! Writing a picture by its extension: checked first, then written beside its path and renamed.

use std::io;
use std::path::Path;

use super::picture::Picture;
use super::{exr, hdr, jpeg, png, tiff};
use crate::beside::{Sink, create_beside, write_whole};
use crate::error::{Error, Report};
use crate::input::display_name;

/// What a caller may set about writing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WriteOptions {
    /// Bits per channel of PNG: 8 or 16.
    pub png_bits: u8,
    /// Quality of JPEG from 1, smallest, to 100, best.
    pub jpeg_quality: u8,
}

impl Default for WriteOptions {
    fn default() -> Self {
        Self { png_bits: 8, jpeg_quality: 95 }
    }
}

/// Text about a picture: keys, and values.
pub(super) type Metadata = [(String, String)];

/// One file format, for pictures that [`check_picture`] let through.
struct Format {
    extensions: &'static [&'static str],
    /// Whether it holds negative values.
    signed: bool,
    encode: fn(&mut Sink, &Picture, &Metadata, WriteOptions) -> io::Result<()>,
}

static FORMATS: [Format; 5] = [
    Format { extensions: &["png"], signed: false, encode: png::encode },
    Format { extensions: &["exr"], signed: true, encode: exr::encode },
    Format { extensions: &["hdr"], signed: false, encode: hdr::encode },
    Format { extensions: &["jpg", "jpeg"], signed: false, encode: jpeg::encode },
    Format { extensions: &["tif", "tiff"], signed: true, encode: tiff::encode },
];

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
/// [`Error::Unsupported`] where the extension is unknown, [`Error::Write`] where the picture or the
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
    let name = display_name(path);
    let report = Report::new(&name);
    let format = format(report, path)?;
    check_options(report, *options)?;
    check_picture(report, picture)?;
    if let Some(layer) = picture.layers.first().filter(|layer| layer.is_vector()) {
        check_signs(report, &layer.name, format)?;
    }
    check_metadata(report, metadata)?;
    write_whole(report, path, |sink| (format.encode)(sink, picture, metadata, *options))
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
    format(report, path)?;
    create_beside(report, path).map(drop)
}

/// Whether a vector called `name` can be written in the format that the extension of `path` names.
///
/// # Errors
///
/// [`Error::Unsupported`] where the extension is unknown, [`Error::Write`] where the format holds no negative values.
pub fn check_holds_vectors(path: &Path, name: &str) -> Result<(), Error> {
    let shown = display_name(path);
    let report = Report::new(&shown);
    check_signs(report, name, format(report, path)?)
}

fn format(report: Report, path: &Path) -> Result<&'static Format, Error> {
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let known = |format: &&Format| format.extensions.contains(&extension.as_str());
    FORMATS.iter().find(known).ok_or_else(|| {
        let extensions = FORMATS.iter().flat_map(|format| format.extensions);
        let extensions: Vec<_> = extensions.map(|extension| format!(".{extension}")).collect();
        let found = match extension.as_str() {
            "" => "there is no extension to tell the format".to_owned(),
            extension => format!("`.{extension}` is no known picture format"),
        };
        report.unsupported(crate::Place::File, found, format!("use one of {}", extensions.join(", ")))
    })
}

fn check_options(report: Report, options: WriteOptions) -> Result<(), Error> {
    let WriteOptions { png_bits, jpeg_quality } = options;
    if !matches!(png_bits, 8 | 16) {
        return Err(report.write(format!("PNG with {png_bits} bits"), "choose 8 or 16", None));
    }
    if !(1..=100).contains(&jpeg_quality) {
        let problem = format!("a JPEG quality of {jpeg_quality}");
        return Err(report.write(problem, "choose 1 to 100", None));
    }
    Ok(())
}

/// Encoders rely on this: at least one pixel, and each channel complete.
fn check_picture(report: Report, picture: &Picture) -> Result<(), Error> {
    let Picture { width, height, ref layers } = *picture;
    let pixels = u64::from(width) * u64::from(height);
    let refuse = |problem: String| Err(report.write(problem, "this is the caller's mistake: report it", None));
    if pixels == 0 || layers.is_empty() {
        return refuse(format!("{width} x {height} pixels in {} layers", layers.len()));
    }
    for (index, layer) in layers.iter().enumerate() {
        let name = &layer.name;
        if layer.channels.is_empty() {
            return refuse(format!("layer `{name}` has no channels"));
        }
        if layers.iter().take(index).any(|other| other.name == *name) {
            return refuse(format!("two layers have the name `{name}`"));
        }
        for (index, channel) in layer.channels.iter().enumerate() {
            let (inner, count) = (&channel.name, channel.data.len());
            if layer.channels.iter().take(index).any(|other| other.name == *inner) {
                return refuse(format!("layer `{name}` has two channels of the name `{inner}`"));
            }
            if count as u64 != pixels {
                return refuse(format!(
                    "layer `{name}`, channel `{inner}` has {count} values for {width} x {height} \
                     pixels"
                ));
            }
            for text in [name, inner] {
                // A C string of at most 255 bytes is what OpenEXR's names are.
                if text.is_empty() || text.len() > 255 || text.contains('\0') {
                    return refuse(format!("`{}` is no layer or channel name", text.escape_debug()));
                }
            }
        }
    }
    Ok(())
}

/// Half of a vector's values would be lost without a word where there are no negative ones.
fn check_signs(report: Report, name: &str, format: &Format) -> Result<(), Error> {
    if format.signed {
        return Ok(());
    }
    let problem = format!("`{name}` is a vector, and this format holds no negative values");
    Err(report.write(problem, "write it to .exr or .tif", None))
}

/// Keys that every format takes: PNG's limits are the tightest.
fn check_metadata(report: Report, metadata: &Metadata) -> Result<(), Error> {
    for (index, (key, value)) in metadata.iter().enumerate() {
        let characters = key.bytes().all(|byte| byte.is_ascii_graphic() || byte == b' ');
        let trimmed = key.trim() == key && (1..=79).contains(&key.len());
        let unique = metadata.iter().take(index).all(|(other, _)| other != key);
        if !(characters && trimmed && unique && !value.contains('\0')) {
            return Err(report.write(
                format!("the metadata `{}` cannot be kept", key.escape_debug()),
                "use keys of 1 to 79 printable ASCII characters, each once, and values without NUL",
                None,
            ));
        }
    }
    Ok(())
}

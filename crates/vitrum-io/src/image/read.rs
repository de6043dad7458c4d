//! Reading a picture of any format: the content decides.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use image::error::ImageError;
use image::{DynamicImage, ImageReader, Limits};

use super::exr;
use super::picture::{Channel, Picture};
use super::srgb::srgb_to_linear;
use crate::error::{Error, Place, Report};
use crate::memory;
use crate::open::{OpenOptions, display_name};

/// Most pixels of a picture: 16384 squared, as much as a graphics card takes in one texture.
const MOST_PIXELS: u64 = 1 << 28;

/// Reads a PNG, JPEG, Radiance HDR, OpenEXR or TIFF file as linear values.
///
/// Integer samples are decoded as sRGB, alpha is left as it is, and floats are taken as linear.
/// Embedded colour profiles are not applied.
///
/// # Errors
///
/// [`Error::Unreadable`] where the file cannot be read, [`Error::Unsupported`] where its format is
/// none of these, [`Error::Invalid`] where it contradicts its format, and [`Error::TooLarge`] where
/// it has more than 16384 x 16384 pixels, or more than the available memory holds; that is found
/// before its pixels are decoded.
pub fn read_picture(path: &Path) -> Result<Picture, Error> {
    read_picture_with(path, &OpenOptions::default())
}

/// As [`read_picture`], with options: `max_bytes` is the most that the decoded pixels may take.
///
/// # Errors
///
/// Those of [`read_picture`].
pub fn read_picture_with(path: &Path, options: &OpenOptions) -> Result<Picture, Error> {
    let name = display_name(path);
    let report = Report::new(&name);
    let unreadable = |error| report.unreadable(error);
    let metadata = std::fs::metadata(path).map_err(unreadable)?;
    if !metadata.is_file() {
        return Err(report.unsupported(Place::File, "this is not a regular file", "name a picture"));
    }
    let mut magic = Vec::new();
    File::open(path).map_err(unreadable)?.take(4).read_to_end(&mut magic).map_err(unreadable)?;
    if magic == exr::MAGIC {
        return exr::decode(path, report, options);
    }
    let wrong = |error| decode_error(report, error);
    let (width, height) = reader(path, report)?.into_dimensions().map_err(wrong)?;
    if width == 0 || height == 0 {
        return Err(empty(report));
    }
    // Four channels in memory twice: as decoded, and as returned.
    check_size(report, width.into(), height.into(), 8, options)?;
    let mut reader = reader(path, report)?;
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(options.max_bytes.unwrap_or_else(memory::available));
    reader.limits(limits);
    Ok(linear(reader.decode().map_err(wrong)?))
}

/// The error of a picture that is whole, and shows nothing.
pub(super) fn empty(report: Report) -> Error {
    report.invalid(Place::File, "there are no pixels in it", "get the file again, or write it anew")
}

/// Fails where `channels` of float32 in this size are too many, before they are allocated.
pub(super) fn check_size(
    report: Report,
    width: u64,
    height: u64,
    channels: u64,
    options: &OpenOptions,
) -> Result<(), Error> {
    let pixels = width.saturating_mul(height);
    let bytes = |pixels: u64| pixels.saturating_mul(channels).saturating_mul(4);
    if pixels > MOST_PIXELS {
        let advice = format!("scale it down from {width} x {height} pixels");
        return Err(report.too_large(bytes(pixels), bytes(MOST_PIXELS), advice));
    }
    memory::check(report, bytes(pixels), options.max_bytes)
}

fn reader(path: &Path, report: Report) -> Result<ImageReader<BufReader<File>>, Error> {
    let file = File::open(path).map_err(|error| report.unreadable(error))?;
    // Content alone: an extension that lies should not choose the decoder.
    ImageReader::new(BufReader::new(file)).with_guessed_format().map_err(|error| report.unreadable(error))
}

fn decode_error(report: Report, error: ImageError) -> Error {
    let problem = error.to_string();
    match error {
        ImageError::Unsupported(_) => report.unsupported(
            Place::File,
            problem,
            "convert it to PNG, JPEG, Radiance HDR, OpenEXR or float32 RGB TIFF",
        ),
        // What a decoder needs besides the pixels.
        ImageError::Limits(_) => {
            report.unsupported(Place::File, problem, "free some memory, raise the limit, or scale the picture down")
        }
        ImageError::IoError(error) if error.kind() != std::io::ErrorKind::UnexpectedEof => report.unreadable(error),
        _ => report.invalid(Place::File, problem, "get the file again, or write it anew"),
    }
}

fn linear(decoded: DynamicImage) -> Picture {
    let (width, height) = (decoded.width(), decoded.height());
    let color = decoded.color();
    let float = matches!(decoded, DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_));
    let names: &[(&str, usize)] = match (color.has_color(), color.has_alpha()) {
        (false, false) => &[("Y", 0)],
        (false, true) => &[("Y", 0), ("A", 3)],
        (true, false) => &[("R", 0), ("G", 1), ("B", 2)],
        (true, true) => &[("R", 0), ("G", 1), ("B", 2), ("A", 3)],
    };
    let pixels = decoded.into_rgba32f().into_raw();
    let to_linear = |name: &str, value: f32| match name {
        "A" => value,
        _ if float => value,
        _ => srgb_to_linear(value),
    };
    let channels = names.iter().map(|&(name, offset)| Channel {
        name: name.to_owned(),
        data: pixels.iter().skip(offset).step_by(4).map(|&v| to_linear(name, v)).collect(),
    });
    let mut picture = Picture::gray(width, height, Vec::new());
    picture.layers[0].channels = channels.collect();
    picture
}

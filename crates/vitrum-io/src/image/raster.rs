//! Reading PNG, JPEG, Radiance HDR and TIFF files by the crate `image`.

use image::error::ImageError;
use image::{DynamicImage, ImageReader, Limits};

use super::picture::{Channel, Picture};
use super::size::{check_size, empty};
use super::srgb::srgb_to_linear;
use crate::error::{Error, Place, Report};
use crate::memory;
use crate::options::OpenOptions;
use crate::storage::{ByteReader, Storage};

/// Reads a picture of any of these formats.
pub(super) fn decode(storage: &Storage, report: Report, options: &OpenOptions) -> Result<Picture, Error> {
    let wrong = |error| decode_error(report, error);
    let (width, height) = reader(storage, report)?.into_dimensions().map_err(wrong)?;
    if width == 0 || height == 0 {
        return Err(empty(report));
    }
    // Four channels in memory twice: as decoded, and as returned.
    check_size(report, width.into(), height.into(), 8, options)?;
    let mut reader = reader(storage, report)?;
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(options.max_bytes.unwrap_or_else(memory::available));
    reader.limits(limits);
    Ok(linear(reader.decode().map_err(wrong)?))
}

fn reader<'a>(storage: &Storage<'a>, report: Report) -> Result<ImageReader<ByteReader<'a>>, Error> {
    let bytes = storage.open().map_err(|error| report.unreadable(error))?;
    // Content alone: an extension that lies should not choose the decoder.
    ImageReader::new(bytes).with_guessed_format().map_err(|error| report.unreadable(error))
}

fn decode_error(report: Report, error: ImageError) -> Error {
    let problem = error.to_string();
    match error {
        ImageError::Unsupported(_) => report.unsupported(
            Place::File,
            problem,
            "convert it to PNG, JPEG, Radiance HDR, OpenEXR or float32 RGB TIFF",
        ),
        // Memory of a decoder besides the pixels.
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

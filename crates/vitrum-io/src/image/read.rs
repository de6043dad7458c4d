//! Reading a picture of any format: the content decides.

use std::borrow::Cow;
use std::io::Read;
use std::path::Path;

use super::picture::Picture;
use crate::error::{Error, Place, Report};
use crate::formats::{self, PICTURE_FORMATS};
use crate::input::display_name;
use crate::options::OpenOptions;
use crate::storage::Storage;

/// Reads a PNG, JPEG, Radiance HDR, OpenEXR or TIFF file as linear values.
///
/// Integer samples are decoded as sRGB, alpha is left as it is, and floats are taken as linear.
/// Embedded colour profiles are not applied.
///
/// # Errors
///
/// [`Error::Unreadable`] where the file cannot be read, [`Error::Unsupported`] where its format is
/// none of these, [`Error::LeftOut`] where this build leaves it out, [`Error::Invalid`] where it contradicts its format, and [`Error::TooLarge`] where
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
    decode(&Storage::Disk(Cow::Borrowed(path)), report, options)
}

/// Reads a picture from the bytes of its file, as [`read_picture_with`] does; `name` stands in messages.
///
/// # Errors
///
/// Those of [`read_picture`].
pub fn read_picture_bytes(name: &str, bytes: &[u8], options: &OpenOptions) -> Result<Picture, Error> {
    let name = display_name(Path::new(name));
    decode(&Storage::Memory(bytes), Report::new(&name), options)
}

fn decode(storage: &Storage, report: Report, options: &OpenOptions) -> Result<Picture, Error> {
    /// Bytes of a file's beginning by which every format is recognised.
    const HEAD: u64 = 16;
    let unreadable = |error| report.unreadable(error);
    let mut head = Vec::new();
    storage.open().map_err(unreadable)?.take(HEAD).read_to_end(&mut head).map_err(unreadable)?;
    if let Some(format) = formats::left_out(PICTURE_FORMATS, &head, "") {
        return Err(report.left_out(format));
    }
    #[cfg(feature = "exr")]
    if formats::EXR.begins(&head) {
        return super::exr::decode(storage, report, options);
    }
    #[cfg(any(feature = "png", feature = "hdr", feature = "jpeg", feature = "tiff"))]
    return super::raster::decode(storage, report, options);
    #[cfg(not(any(feature = "png", feature = "hdr", feature = "jpeg", feature = "tiff")))]
    {
        // No decoder is left that takes them.
        let _ = options;
        let included = PICTURE_FORMATS.iter().copied().filter(|format| format.included);
        let advice = format!("convert it to one of: {}", formats::described(included));
        Err(report.unsupported(Place::File, "the content is of no known picture format", advice))
    }
}

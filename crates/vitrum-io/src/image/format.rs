//! The file formats of pictures.

use std::path::Path;

use crate::error::{Error, Place, Report};
use crate::formats::{EXR, Format, HDR, JPEG, PICTURE_FORMATS, PNG, TIFF};

/// A file format of pictures, and what of a picture it holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PictureFormat {
    /// The first layer as sRGB in 8 or 16 bits, with straight alpha where it has one, and metadata.
    Png,
    /// Every layer as float32, each a part with its name, and metadata.
    Exr,
    /// The first layer's colour, shared-exponent RGBE.
    Hdr,
    /// The first layer's colour as sRGB in 8 bits.
    Jpeg,
    /// The first layer as float32, with straight alpha where it has one; of a vector X, Y, Z in the places of R, G, B.
    Tiff,
}

impl PictureFormat {
    /// All formats.
    pub const ALL: [Self; 5] = [Self::Png, Self::Exr, Self::Hdr, Self::Jpeg, Self::Tiff];

    /// Name, extensions and feature of the format.
    #[must_use]
    pub fn format(self) -> &'static Format {
        match self {
            Self::Png => &PNG,
            Self::Exr => &EXR,
            Self::Hdr => &HDR,
            Self::Jpeg => &JPEG,
            Self::Tiff => &TIFF,
        }
    }

    /// The format that the extension of a path names.
    ///
    /// # Errors
    ///
    /// [`Error::Unsupported`] where the extension is unknown, [`Error::LeftOut`] where this build leaves out its format.
    pub fn of_path(path: &Path) -> Result<Self, Error> {
        let name = crate::input::display_name(path);
        Self::named(Report::new(&name), path)
    }

    pub(super) fn named(report: Report, path: &Path) -> Result<Self, Error> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let dotted = format!(".{extension}");
        let known = |format: &Self| format.format().extensions.contains(&dotted.as_str());
        if let Some(format) = Self::ALL.into_iter().find(known) {
            return if format.format().included { Ok(format) } else { Err(report.left_out(format.format())) };
        }
        let extensions: Vec<_> = PICTURE_FORMATS.iter().flat_map(|format| format.extensions).copied().collect();
        let found = match extension.as_str() {
            "" => "there is no extension to tell the format".to_owned(),
            extension => format!("`.{extension}` is no known picture format"),
        };
        Err(report.unsupported(Place::File, found, format!("use one of {}", extensions.join(", "))))
    }

    /// Whether the format stores values from 0 to 1 alone.
    pub(super) fn clips(self) -> bool {
        matches!(self, Self::Png | Self::Jpeg)
    }

    /// Whether the format stores negative values.
    pub(super) fn is_signed(self) -> bool {
        matches!(self, Self::Exr | Self::Tiff)
    }
}

//! Errors of files: each names the file, the place in it, the problem, and the way to mend it.

use std::fmt;
use std::io;

use crate::formats::Format;
use crate::setting::Setting;

/// Why a volume or a picture could not be read or written.
///
/// Every message names the file, the place in it, what was expected there and what to do. Where a field of
/// [`OpenOptions`](crate::OpenOptions) is the remedy, [`Self::setting`] names it.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The operating system would not give us the file.
    #[error("{file}: cannot be read: {source}; {advice}")]
    Unreadable {
        /// The file's path, as it was given.
        file: String,
        /// Error of the operating system.
        source: io::Error,
        /// Advice: a remedy.
        advice: String,
    },

    /// The file, or the data given, contradicts its format or itself.
    #[error("{file}{place}: {problem}; {advice}")]
    Invalid {
        /// The file's path, as it was given.
        file: String,
        /// Place in the file.
        place: Place,
        /// The contradiction: found and expected.
        problem: String,
        /// Advice: a remedy.
        advice: String,
    },

    /// The file may well be valid, but it uses something that Vitrum does not read or write.
    #[error("{file}{place}: {problem}; {advice}")]
    Unsupported {
        /// The file's path, as it was given.
        file: String,
        /// Place in the file.
        place: Place,
        /// The thing that is not supported, and those that are.
        problem: String,
        /// Advice: a remedy.
        advice: String,
        /// The field of [`OpenOptions`](crate::OpenOptions) that does it, where one does.
        setting: Option<Setting>,
    },

    /// A file of an unknown format, by its content and by its name.
    #[error("{file}: {found}; expected one of: {expected}; or voxels without a header, with their layout given")]
    UnknownFormat {
        /// The file's path, as it was given.
        file: String,
        /// Kind of the file, as far as it is known.
        found: Found,
        /// The known formats with their extensions.
        expected: String,
    },

    /// The layout of voxels without a header is not known, or contradicts the file's size.
    #[error(
        "{file}: {problem}; expected a layout such as 256x256x109:u8 or 64x64x32:i16:be:skip=512, or a name such as \
             NAME_256x256x109_uint8.raw; if a header lies beside it, open that"
    )]
    UnknownLayout {
        /// The file's path, as it was given.
        file: String,
        /// The part of the layout that is missing or wrong.
        problem: String,
    },

    /// The file is of a format that this build of the library leaves out.
    #[error("{file}: this build leaves out the format {format}; expected vitrum-io with its feature `{feature}`")]
    LeftOut {
        /// The file's path, as it was given.
        file: String,
        /// The format's name.
        format: &'static str,
        /// The feature that has it.
        feature: &'static str,
    },

    /// The decoded data would not fit; nothing was allocated.
    #[error("{file}: needs {needed} bytes once decoded, and the limit is {limit} bytes; {advice}")]
    TooLarge {
        /// The file's path, as it was given.
        file: String,
        /// Bytes that the decoded data would take.
        needed: u64,
        /// Bytes that it may take.
        limit: u64,
        /// Advice: a remedy.
        advice: String,
    },

    /// A file could not be written; whatever stood at its path before stands there still.
    #[error("{file}: cannot be written: {problem}; {advice}")]
    Write {
        /// The file's path, as it was given.
        file: String,
        /// The obstacle.
        problem: String,
        /// Advice: a remedy.
        advice: String,
        /// Error of the operating system, where it was asked.
        source: Option<io::Error>,
    },
}

impl Error {
    /// The error with the field of [`OpenOptions`](crate::OpenOptions) that can mend it.
    pub(crate) fn with_setting(self, setting: Setting) -> Self {
        match self {
            Self::Unsupported { file, place, problem, advice, .. } => {
                Self::Unsupported { file, place, problem, advice, setting: Some(setting) }
            }
            other => other,
        }
    }

    /// The field of [`OpenOptions`](crate::OpenOptions) that can mend it, where one can.
    #[must_use]
    pub fn setting(&self) -> Option<Setting> {
        match self {
            Self::Unsupported { setting, .. } => *setting,
            Self::UnknownFormat { found: Found::Mesh | Found::Unknown, .. } | Self::UnknownLayout { .. } => {
                Some(Setting::Raw)
            }
            _ => None,
        }
    }

    /// Advice in the error's own words, where it has such; a program may have better ones.
    #[must_use]
    pub fn advice(&self) -> Option<&str> {
        match self {
            Self::Unreadable { advice, .. }
            | Self::Invalid { advice, .. }
            | Self::Unsupported { advice, .. }
            | Self::TooLarge { advice, .. }
            | Self::Write { advice, .. } => Some(advice),
            Self::UnknownFormat { .. } | Self::UnknownLayout { .. } | Self::LeftOut { .. } => None,
        }
    }
}

/// Kind of a file that is no volume of a known format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Found {
    /// A folder without the files of a series.
    Folder,
    /// A mesh.
    Mesh,
    /// Content of an unknown kind.
    Unknown,
}

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Folder => "this is a folder without DICOM or TIFF files, and without DICOM files below it",
            Self::Mesh => "this is a mesh, and volumes alone are read here",
            Self::Unknown => "neither the content nor the extension is of a known volume format",
        })
    }
}

/// Place of an [`Error`] in a file; displayed behind the file's name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// The file as a whole.
    File,
    /// A header line, counted from 1.
    Line(usize),
    /// A byte offset from the start of the file, seen through its compression.
    Byte(u64),
    /// A voxel's index (x, y, z), counted from 0.
    Voxel([u32; 3]),
    /// A mesh's vertex, counted from 0.
    Vertex(u32),
    /// A mesh's triangle, counted from 0.
    Triangle(u32),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => Ok(()),
            Self::Line(number) => write!(f, ", line {number}"),
            Self::Byte(offset) => write!(f, ", byte {offset}"),
            Self::Voxel([x, y, z]) => write!(f, ", voxel ({x}, {y}, {z})"),
            Self::Vertex(index) => write!(f, ", vertex {index}"),
            Self::Triangle(index) => write!(f, ", triangle {index}"),
        }
    }
}

/// Puts the file's name into errors, so that a parser states only the place and the problem.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Report<'a> {
    pub file: &'a str,
}

impl<'a> Report<'a> {
    pub fn new(file: &'a str) -> Self {
        Self { file }
    }

    pub fn invalid(self, place: Place, problem: impl Into<String>, advice: impl Into<String>) -> Error {
        Error::Invalid { file: self.file.to_owned(), place, problem: problem.into(), advice: advice.into() }
    }

    pub fn unsupported(self, place: Place, problem: impl Into<String>, advice: impl Into<String>) -> Error {
        let (problem, advice) = (problem.into(), advice.into());
        Error::Unsupported { file: self.file.to_owned(), place, problem, advice, setting: None }
    }

    pub fn left_out(self, format: &Format) -> Error {
        Error::LeftOut { file: self.file.to_owned(), format: format.name, feature: format.feature }
    }

    pub fn too_large(self, needed: u64, limit: u64, advice: impl Into<String>) -> Error {
        Error::TooLarge { file: self.file.to_owned(), needed, limit, advice: advice.into() }
    }

    pub fn unreadable(self, source: io::Error) -> Error {
        let advice = match source.kind() {
            io::ErrorKind::NotFound => "check the path",
            io::ErrorKind::PermissionDenied => "check the file's permissions",
            _ => "check the disk, then try again",
        };
        Error::Unreadable { file: self.file.to_owned(), source, advice: advice.to_owned() }
    }

    pub fn write(self, problem: impl Into<String>, advice: impl Into<String>, source: Option<io::Error>) -> Error {
        Error::Write { file: self.file.to_owned(), problem: problem.into(), advice: advice.into(), source }
    }
}

/// The start of a text from a file, fit for a message.
pub(crate) fn clip(text: &str) -> String {
    const MOST: usize = 60;
    let mut clipped: String = text.chars().take(MOST).collect::<String>().escape_debug().collect();
    if text.chars().nth(MOST).is_some() {
        clipped.push('…');
    }
    clipped
}

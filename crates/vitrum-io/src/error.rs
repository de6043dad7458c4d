//! Everything that can go wrong with a file, told so that the reader of the message can act on it.

use std::fmt;
use std::io;

/// Why a volume or a picture could not be read or written.
///
/// Every message names the file, the place in it, what was expected there and what to do.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The operating system would not give us the file.
    #[error("{file}: cannot be read: {source}; {advice}")]
    Unreadable {
        /// The file's path, as it was given.
        file: String,
        /// What the operating system said.
        source: io::Error,
        /// What to do.
        advice: String,
    },

    /// The file, or the data given, contradicts its format or itself.
    #[error("{file}{place}: {problem}; {advice}")]
    Invalid {
        /// The file's path, as it was given.
        file: String,
        /// Where in it.
        place: Place,
        /// What was found, and what was expected.
        problem: String,
        /// What to do.
        advice: String,
    },

    /// The file may well be valid, but it uses something that Vitrum does not read or write.
    #[error("{file}{place}: {problem}; {advice}")]
    Unsupported {
        /// The file's path, as it was given.
        file: String,
        /// Where in it.
        place: Place,
        /// What is not supported, and what is.
        problem: String,
        /// What to do.
        advice: String,
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
        /// What to do.
        advice: String,
    },

    /// A file could not be written; whatever stood at its path before stands there still.
    #[error("{file}: cannot be written: {problem}; {advice}")]
    Write {
        /// The file's path, as it was given.
        file: String,
        /// What stood in the way.
        problem: String,
        /// What to do.
        advice: String,
        /// What the operating system said, where it was asked.
        source: Option<io::Error>,
    },
}

impl Error {
    /// The same error at a place that only the caller knows.
    pub(crate) fn at(self, place: Place) -> Self {
        match self {
            Self::Invalid { file, problem, advice, .. } => Self::Invalid { file, place, problem, advice },
            other => other,
        }
    }
}

/// Where in a file an [`Error`] was found; displayed behind the file's name.
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
        Error::Unsupported { file: self.file.to_owned(), place, problem: problem.into(), advice: advice.into() }
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

//! Why a frame could not be made.

use crate::backend::BackendError;
use crate::scene::SceneError;
use crate::unrenderable::Unrenderable;

/// Why a frame could not be made.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A file could not be read or written, or is not valid.
    #[error(transparent)]
    Io(#[from] vitrum_io::Error),
    /// A scene file is not valid.
    #[error(transparent)]
    SceneFile(#[from] SceneError),
    /// The scene and its data make no frame together.
    #[error("{0}; {advice}", advice = .0.advice())]
    Unrenderable(Box<Unrenderable>),
    /// The backend failed.
    #[error(transparent)]
    Backend(#[from] BackendError),
}

impl From<Unrenderable> for Error {
    fn from(problem: Unrenderable) -> Self {
        Self::Unrenderable(Box::new(problem))
    }
}

impl Error {
    /// The program's exit code: 2 for a memory limit that is too low, 3 for inputs, 4 for devices.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Io(_) | Self::SceneFile(_) | Self::Unrenderable(_) => 3,
            Self::Backend(error) if error.is_of_use() => 2,
            Self::Backend(_) => 4,
        }
    }

    /// What to do about it, if that is not in the message.
    pub fn help(&self) -> Option<String> {
        match self {
            Self::Backend(error) => error.help().map(str::to_owned),
            Self::Io(_) | Self::SceneFile(_) | Self::Unrenderable(_) => None,
        }
    }

    /// Whether the caller cancelled.
    pub fn is_cancelled(&self) -> bool {
        matches!(self, Self::Backend(BackendError::Cancelled))
    }
}

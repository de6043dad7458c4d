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
    /// Whether the caller cancelled.
    pub fn is_cancelled(&self) -> bool {
        matches!(self, Self::Backend(BackendError::Cancelled))
    }
}

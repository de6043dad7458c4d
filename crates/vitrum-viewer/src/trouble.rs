//! What went wrong, for people to read.

use vitrum::backend::BackendError;
use vitrum::composition::CompositionError;
use vitrum::scene::SceneError;
use vitrum_annotations::AnnotationError;

/// What went wrong, and what to do about it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Trouble {
    /// What went wrong.
    pub message: String,
    /// What to do about it.
    pub help: String,
    /// Whether nothing went wrong, and the work was given up.
    pub is_cancelled: bool,
}

impl Trouble {
    /// A message with its advice.
    pub fn new(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { message: message.into(), help: help.into(), is_cancelled: false }
    }
}

impl From<vitrum::io::Error> for Trouble {
    fn from(error: vitrum::io::Error) -> Self {
        let mut message = error.to_string();
        let advice = error.advice().unwrap_or_default();
        // Messages end in their advice.
        if let Some(head) = message.strip_suffix(advice).and_then(|head| head.strip_suffix("; ")) {
            message.truncate(head.len());
        }
        Self::new(message, advice)
    }
}

impl From<SceneError> for Trouble {
    fn from(error: SceneError) -> Self {
        Self::new(error.to_string(), error.help())
    }
}

impl From<BackendError> for Trouble {
    fn from(error: BackendError) -> Self {
        let help = match &error {
            BackendError::TooLarge { .. } | BackendError::OutOfMemory { .. } | BackendError::VolumeLimit { .. } => {
                "choose the CPU in the menu Backend, or a smaller picture"
            }
            BackendError::Threads { .. } => "start the window with fewer threads (--threads)",
            _ => {
                "choose the CPU in the menu Backend; a GPU needs a driver of its own (Debian: mesa-vulkan-drivers libvulkan1)"
            }
        };
        let is_cancelled = matches!(error, BackendError::Cancelled);
        Self { is_cancelled, ..Self::new(error.to_string(), help) }
    }
}

impl From<vitrum::Error> for Trouble {
    fn from(error: vitrum::Error) -> Self {
        match error {
            vitrum::Error::Io(error) => error.into(),
            vitrum::Error::SceneFile(error) => error.into(),
            vitrum::Error::Backend(error) => error.into(),
            vitrum::Error::Unrenderable(problem) => Self::new(problem.to_string(), problem.advice()),
        }
    }
}

impl From<CompositionError> for Trouble {
    fn from(error: CompositionError) -> Self {
        match error {
            CompositionError::Scene(error) => error.into(),
            error => {
                let help = error.advice().unwrap_or_default();
                Self::new(error.to_string(), help)
            }
        }
    }
}

impl From<AnnotationError> for Trouble {
    fn from(error: AnnotationError) -> Self {
        Self::new(error.to_string(), error.advice())
    }
}

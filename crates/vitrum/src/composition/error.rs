//! The ways in which a scene fails to be composed.

use super::Side;
use crate::assets::made;
use crate::error::Error;
use crate::preset::{MediumError, PresetError};
use crate::scene::SceneError;
use crate::suggest::nearest;
use std::path::PathBuf;

/// Why a scene could not be composed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CompositionError {
    /// The name after `builtin:` is no scene's.
    #[error("there is no built-in scene `{name}`")]
    UnknownBuiltin {
        /// The name that was asked for.
        name: String,
    },
    /// A text file could not be read.
    #[error("{}: {reason}", file.display())]
    Text {
        /// The file.
        file: PathBuf,
        /// The reason.
        reason: String,
        /// Advice: a sentence that says how to mend it.
        advice: &'static str,
    },
    /// A side of a patient was asked for, and the data does not say where it is.
    #[error("there is no {} view: {kind}", side.name())]
    NoSides {
        /// The side.
        side: Side,
        /// Why it is not known.
        kind: &'static str,
    },
    /// A transfer function, or a change of one, for a mesh.
    #[error("{input}: a mesh has no transfer function")]
    NoTransferFunction {
        /// The input.
        input: String,
    },
    /// An unknown preset, for the input's kind.
    #[error(transparent)]
    Preset(#[from] PresetError),
    /// An unknown medium, or a medium for a volume.
    #[error(transparent)]
    Medium(#[from] MediumError),
    /// The scene is not valid, or its data could not be read.
    #[error(transparent)]
    Scene(#[from] Error),
}

impl From<SceneError> for CompositionError {
    fn from(error: SceneError) -> Self {
        Self::Scene(error.into())
    }
}

impl CompositionError {
    /// Advice for an unknown name or an unreadable text, in one sentence; errors of other kinds have their own advice.
    #[must_use]
    pub fn advice(&self) -> Option<String> {
        match self {
            Self::UnknownBuiltin { name } => {
                let known: Vec<_> = made::scene_names().collect();
                Some(match nearest(name, known.iter().copied()) {
                    Some(near) => format!("did you mean `builtin:{near}`?"),
                    None if known.is_empty() => "this build has no built-in scenes".to_owned(),
                    None => format!("the built-in scenes are: {}", known.join(", ")),
                })
            }
            Self::Text { advice, .. } => Some((*advice).to_owned()),
            Self::NoSides { side, .. } => {
                Some(format!("turn the camera yourself, where world z is up and y the front: {}", side.settings()))
            }
            Self::NoTransferFunction { .. } => {
                Some("name a volume, or set materials by keys such as `material.0.color`".to_owned())
            }
            Self::Preset(error) => Some(error.help()),
            Self::Medium(error) => Some(error.help()),
            Self::Scene(_) => None,
        }
    }
}

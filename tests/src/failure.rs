//! Why a run came to no result.

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use vitrum::backend::BackendError;
use vitrum::preset::PresetError;
use vitrum::scene::SceneError;
use vitrum_compare::CompareError;

/// Why a run came to no result. A breach is a result, and no failure.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// Wrong use, or something that the run needs is missing. The message says what to do.
    #[error("{0}")]
    Setup(String),
    /// A frame could not be made.
    #[error(transparent)]
    Render(#[from] vitrum::Error),
    /// Two things do not even have the same size.
    #[error("{what}: {error}")]
    Compare {
        /// The name of the comparison.
        what: String,
        /// Why that is impossible.
        error: CompareError,
    },
    /// A result could not be written.
    #[error("{}: cannot be written: {error}", path.display())]
    Output {
        /// The file or folder.
        path: PathBuf,
        /// The error of the operating system.
        error: io::Error,
    },
}

impl From<BackendError> for Failure {
    fn from(error: BackendError) -> Self {
        Self::Render(error.into())
    }
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Self::Render(error.into())
    }
}

impl From<vitrum_io::Error> for Failure {
    fn from(error: vitrum_io::Error) -> Self {
        Self::Render(error.into())
    }
}

impl From<PresetError> for Failure {
    fn from(error: PresetError) -> Self {
        Self::Setup(format!("{error}: {}", error.help()))
    }
}

impl Failure {
    fn exit_code(&self) -> u8 {
        match self {
            Self::Compare { .. } => 1,
            Self::Setup(_) | Self::Output { .. } => 2,
            Self::Render(vitrum::Error::Backend(_)) => 4,
            Self::Render(_) => 3,
        }
    }
}

/// The exit code of a program whose run gave `outcome`, whether every bound held: 0 if so, 1 if not, and 2 or more for a
/// failure, which is printed.
#[must_use]
pub fn exit(outcome: Result<bool, Failure>) -> ExitCode {
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::from(failure.exit_code())
        }
    }
}

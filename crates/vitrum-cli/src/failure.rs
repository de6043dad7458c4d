//! Why a command failed, as the user reads it.

use crate::{advice, interrupt};
use std::process::ExitCode;
use vitrum::Unrenderable;
use vitrum::backend::BackendError;
use vitrum::composition::CompositionError;
use vitrum::preset::PresetError;
use vitrum::scene::{Origin, SceneError};
use vitrum::suggest::nearest;

/// The kind of a failure; the numbers are the exit codes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    WrongUse = 2,
    Input = 3,
    Device = 4,
    /// The exit code of timeout(1).
    TimedOut = 124,
    /// 128 + SIGINT, as shells have it.
    Interrupted = 130,
}

/// A message, what to do about it, and the exit code.
#[derive(Debug)]
pub struct Failure {
    status: Status,
    message: String,
    help: Option<String>,
}

impl Failure {
    pub fn new(status: Status, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { status, message: message.into(), help: Some(help.into()) }
    }

    /// The failure of a part of the work.
    pub fn at(self, place: &str) -> Self {
        Self { message: format!("{place}: {}", self.message), ..self }
    }

    /// An output that cannot be written: the user named it.
    pub fn output(error: &vitrum::io::Error) -> Self {
        let (message, help) = advice::on_error(error);
        Self { status: Status::WrongUse, message, help }
    }

    /// The failure with other advice.
    pub fn with_help(self, help: &str) -> Self {
        Self { help: Some(help.to_owned()), ..self }
    }

    pub fn status(&self) -> Status {
        self.status
    }

    /// Prints it to standard error.
    pub fn report(&self) -> ExitCode {
        eprintln!("error: {}", self.message);
        if let Some(help) = &self.help {
            eprintln!("help: {help}");
        }
        ExitCode::from(self.status as u8)
    }
}

/// An input that cannot be read.
impl From<vitrum::io::Error> for Failure {
    fn from(error: vitrum::io::Error) -> Self {
        let (message, help) = advice::on_error(&error);
        Self { status: Status::Input, message, help }
    }
}

/// A scene that a file holds is an input; one that flags changed is a matter of use.
impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        let status = match error.origin {
            Origin::File { .. } => Status::Input,
            Origin::Setting(_) | Origin::Memory => Status::WrongUse,
        };
        Self::new(status, error.to_string(), error.help())
    }
}

impl From<PresetError> for Failure {
    fn from(error: PresetError) -> Self {
        let flags = match &error {
            PresetError::NotHounsfield { .. } => " (--window, --level)",
            _ => "",
        };
        Self::new(Status::WrongUse, error.to_string(), error.help() + flags)
    }
}

impl From<CompositionError> for Failure {
    fn from(error: CompositionError) -> Self {
        match error {
            CompositionError::Preset(error) => error.into(),
            CompositionError::Scene(error) => error.into(),
            error => {
                let status =
                    if matches!(error, CompositionError::Text { .. }) { Status::Input } else { Status::WrongUse };
                Self { status, message: error.to_string(), help: error.advice() }
            }
        }
    }
}

impl From<vitrum::Error> for Failure {
    fn from(error: vitrum::Error) -> Self {
        match error {
            vitrum::Error::Io(error) => error.into(),
            vitrum::Error::SceneFile(error) => error.into(),
            vitrum::Error::Backend(error) => error.into(),
            // A contradiction between the scene and its files, in which no single value is wrong.
            vitrum::Error::Unrenderable(problem) => {
                let help = match &*problem {
                    // The program has a command that lists them with their variants.
                    Unrenderable::UnknownBuiltin { kind: "volume", name, known } => {
                        match nearest(name, known.iter().copied()) {
                            Some(near) => format!("did you mean `{near}`?"),
                            None => "`vitrum scenes` lists the built-in scenes".to_owned(),
                        }
                    }
                    problem => problem.advice(),
                };
                Self::new(Status::Input, problem.to_string(), help)
            }
        }
    }
}

impl From<BackendError> for Failure {
    fn from(error: BackendError) -> Self {
        match error {
            BackendError::Cancelled => interrupt::failure(),
            error => {
                let status = if error.is_usage_error() { Status::WrongUse } else { Status::Device };
                Self { status, message: error.to_string(), help: advice::on_backend(&error).map(str::to_owned) }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lost_device_exits_4_and_says_what_to_do() {
        let lost = BackendError::DeviceLost { adapter: "a card".to_owned(), reason: "the driver was reset".to_owned() };
        let failure = Failure::from(vitrum::Error::from(lost));
        assert_eq!(failure.status, Status::Device);
        assert!(failure.message.contains("a card failed: the driver was reset"), "{}", failure.message);
        assert!(failure.help.is_some_and(|help| help.contains("--backend cpu")));
    }
}

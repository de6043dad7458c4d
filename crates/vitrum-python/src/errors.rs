//! Failures as Python's exceptions, whose classes are Python's own: `vitrum_render/errors.py`.

use pyo3::prelude::*;
use vitrum::Error;
use vitrum::backend::BackendError;
use vitrum::composition::CompositionError;
use vitrum::io;
use vitrum::preset::PresetError;
use vitrum::scene::SceneError;
use vitrum_annotations::AnnotationError;

/// A failure, on its way to Python.
#[derive(Debug)]
pub struct Failure {
    /// The name of the exception's class.
    class: &'static str,
    message: String,
    advice: Option<String>,
    /// The scene's key, where one is wrong.
    key: Option<String>,
}

impl Failure {
    /// Of an argument's value.
    pub fn value(message: impl Into<String>, advice: impl Into<String>) -> Self {
        Self { class: "InvalidValue", message: message.into(), advice: Some(advice.into()), key: None }
    }

    /// Of a device.
    pub fn device(message: impl Into<String>) -> Self {
        Self { class: "DeviceError", message: message.into(), advice: None, key: None }
    }

    /// Whether the caller gave the work up.
    pub fn is_cancelled(&self) -> bool {
        self.class == "Cancelled"
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        Python::attach(|py| {
            let made = py.import("vitrum_render.errors").and_then(|module| {
                module.getattr(failure.class)?.call1((failure.message, failure.advice, failure.key))
            });
            made.map_or_else(|error| error, Self::from_value)
        })
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self { class: "FileError", message: error.to_string(), advice: None, key: None }
    }
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        let key = (!error.key.is_empty()).then(|| error.key.clone());
        Self { class: "SceneError", message: error.to_string(), advice: Some(error.help()), key }
    }
}

impl From<BackendError> for Failure {
    fn from(error: BackendError) -> Self {
        let class = match &error {
            BackendError::Cancelled => "Cancelled",
            error if error.is_usage_error() => "InvalidValue",
            _ => "DeviceError",
        };
        Self { class, message: error.to_string(), advice: None, key: None }
    }
}

impl From<PresetError> for Failure {
    fn from(error: PresetError) -> Self {
        Self::value(error.to_string(), error.help())
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        match error {
            Error::Io(error) => error.into(),
            Error::SceneFile(error) => error.into(),
            Error::Backend(error) => error.into(),
            Error::Unrenderable(problem) => Self::value(problem.to_string(), problem.advice()),
        }
    }
}

impl From<CompositionError> for Failure {
    fn from(error: CompositionError) -> Self {
        match error {
            CompositionError::Preset(error) => error.into(),
            CompositionError::Scene(error) => error.into(),
            error => {
                let class = if matches!(error, CompositionError::Text { .. }) { "FileError" } else { "InvalidValue" };
                Self { class, message: error.to_string(), advice: error.advice(), key: None }
            }
        }
    }
}

impl From<AnnotationError> for Failure {
    fn from(error: AnnotationError) -> Self {
        Self::value(error.to_string(), error.advice())
    }
}

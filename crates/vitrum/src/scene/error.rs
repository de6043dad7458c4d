//! Errors of scenes: each names the key, the problem, and the way to mend it.

use std::fmt;

/// Why a scene, or a change to one, was refused.
///
/// The display names the file, the line, the key and what was expected; [`SceneError::help`] says what to do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SceneError {
    /// The origin of the scene.
    pub origin: Origin,
    /// The dotted path of the key, such as `camera.azimuth` or `clip.0.offset`; empty for the scene as a whole.
    pub key: String,
    /// The problem at the key.
    pub problem: Box<Problem>,
}

/// The origin of a refused value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Origin {
    /// A scene file.
    File {
        /// The file's name.
        name: String,
        /// The line, counted from 1, where it is known.
        line: Option<usize>,
    },
    /// A setting, with its text `KEY=VALUE`.
    Setting(String),
    /// A scene that a program made.
    Memory,
}

/// The problem of a scene.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// The text is not TOML, or a setting is not `KEY=VALUE`.
    #[error("{0}")]
    Syntax(String),

    /// An unknown key.
    #[error("unknown key")]
    UnknownKey {
        /// The key that was most likely meant, as a full path.
        nearest: Option<String>,
        /// The keys that are known in its place.
        known: Vec<String>,
    },

    /// A key's old name.
    #[error("this key is now `{new}`")]
    RenamedKey {
        /// The full path of the new key.
        new: String,
    },

    /// A key that has no default is not there.
    #[error("this key is missing")]
    MissingKey {
        /// The expected type.
        expected: String,
    },

    /// The value is of the wrong type, out of range, not finite or not one of the choices.
    #[error("found {found}, expected {expected}")]
    WrongValue {
        /// The value, as it was written.
        found: String,
        /// The valid range.
        expected: String,
        /// The choice that was most likely meant.
        nearest: Option<String>,
        /// The value that the key has where it is left out.
        default: Option<String>,
    },

    /// Valid values that contradict each other.
    #[error("{problem}")]
    Contradiction {
        /// The contradiction.
        problem: String,
        /// Advice: a sentence that says how to mend it.
        advice: String,
    },
}

impl SceneError {
    /// Advice in one sentence.
    #[must_use]
    pub fn help(&self) -> String {
        match &*self.problem {
            Problem::Syntax(_) if matches!(self.origin, Origin::Setting(_)) => {
                "write KEY=VALUE with a scene key and a TOML value, such as camera.azimuth=30".to_owned()
            }
            Problem::Syntax(_) => "correct the TOML there; docs/scene.md describes every key".to_owned(),
            Problem::UnknownKey { nearest: Some(nearest), .. } => format!("did you mean `{nearest}`?"),
            Problem::UnknownKey { known, .. } if known.is_empty() => "this value has no keys inside".to_owned(),
            Problem::UnknownKey { known, .. } => format!("the keys here are: {}", known.join(", ")),
            Problem::RenamedKey { new } => match (&self.origin, new.split_once(".0.")) {
                (Origin::File { .. }, Some((list, key))) => {
                    format!("write `{key}` in a table `[[{list}]]`, and `{new}` in key frames")
                }
                _ => format!("write `{new}`"),
            },
            Problem::MissingKey { expected } => format!("give it {expected}"),
            Problem::WrongValue { nearest: Some(nearest), .. } => format!("did you mean `{nearest}`?"),
            Problem::WrongValue { default: Some(default), .. } => {
                format!("correct the value, or leave the key out for its default, {default}")
            }
            Problem::WrongValue { .. } => "correct the value, or leave the key out".to_owned(),
            Problem::Contradiction { advice, .. } => advice.clone(),
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.origin {
            Origin::File { name, line: Some(line) } => write!(f, "{name}, line {line}: ")?,
            Origin::File { name, line: None } => write!(f, "{name}: ")?,
            Origin::Setting(setting) => write!(f, "setting {setting}: ")?,
            Origin::Memory => f.write_str("scene: ")?,
        }
        if !self.key.is_empty() {
            write!(f, "`{}`: ", self.key)?;
        }
        write!(f, "{}", self.problem)
    }
}

impl std::error::Error for SceneError {}

/// A problem and the key path it was found at, before its origin is known.
#[derive(Debug)]
pub(super) struct Fault {
    pub path: Vec<String>,
    pub problem: Problem,
}

impl Fault {
    pub fn at(path: &[String], problem: Problem) -> Self {
        Self { path: path.to_vec(), problem }
    }

    pub fn contradiction(key: &str, problem: impl Into<String>, advice: impl Into<String>) -> Self {
        Self {
            path: key.split('.').filter(|part| !part.is_empty()).map(str::to_owned).collect(),
            problem: Problem::Contradiction { problem: problem.into(), advice: advice.into() },
        }
    }

    pub fn from(self, origin: Origin) -> SceneError {
        SceneError { origin, key: self.path.join("."), problem: Box::new(self.problem) }
    }
}

//! Errors of a translation.

/// Why a module could not be translated.
#[derive(Debug, thiserror::Error)]
pub enum TranslationError {
    /// A module cannot be read.
    #[error("naga cannot read the module: {0}")]
    Read(String),
    /// A module needs more than every device has.
    #[error("naga refuses the module: {0}")]
    Invalid(String),
    /// A module cannot be written in a language.
    #[error("naga cannot write the module as {0}: {1}")]
    Write(&'static str, String),
}

//! Errors about the manifest.

use std::path::PathBuf;

/// The error of a manifest, or a file that it describes, that cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum ManifestError {
    /// A file could not be read.
    #[error("{}: cannot be read: {error}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The error of the operating system.
        error: std::io::Error,
    },
    /// A file with unexpected contents.
    #[error("{}: {reason}; `cargo xtask shaders` writes it anew", path.display())]
    Malformed {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: String,
    },
}

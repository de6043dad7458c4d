//! Folders of slices.

use std::fs;
use std::path::Path;

/// More files than this are no volume.
pub(crate) const MOST_FILES: usize = 100_000;

/// Whether a folder has a TIFF file in it, by its name.
pub(crate) fn has_tiff(path: &Path) -> bool {
    path.is_dir()
        && fs::read_dir(path)
            .is_ok_and(|entries| entries.flatten().take(MOST_FILES).any(|entry| is_tiff(&entry.path())))
}

/// Whether a path is a TIFF file's, by its name.
pub(crate) fn is_tiff(path: &Path) -> bool {
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    matches!(extension.as_str(), "tif" | "tiff") && path.is_file()
}

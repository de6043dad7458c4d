//! Volumes, meshes and environment maps that lie beside the project and not in it, so that not everyone has them.

use std::path::{Path, PathBuf};

use crate::left_out;

/// The path of a file of the shared data, `../shared/data` seen from the project's root.
///
/// Where the file is missing this says so on stdout, past the test harness's capture, and gives nothing: the test is then
/// left out.
///
/// # Panics
/// If the file is missing and `VITRUM_REQUIRE_DATA` is set, so that a machine that should have the data notices.
#[must_use]
pub fn shared(name: &str) -> Option<PathBuf> {
    match find(&crate::root().join("../shared/data"), name, left_out::is_required("VITRUM_REQUIRE_DATA")) {
        Ok(path) => Some(path),
        Err(missing) => {
            left_out::say(&missing);
            None
        }
    }
}

/// The path of `name` in `folder`, or why there is none.
fn find(folder: &Path, name: &str, required: bool) -> Result<PathBuf, String> {
    let path = folder.join(name);
    let missing = format!("{} is missing", path.display());
    assert!(path.exists() || !required, "{missing}, and VITRUM_REQUIRE_DATA is set");
    if path.exists() { Ok(path) } else { Err(missing) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_there_is_found() {
        let found = find(&crate::root(), "Cargo.toml", true).unwrap();
        assert_eq!(found, crate::root().join("Cargo.toml"));
    }

    #[test]
    fn what_is_missing_is_named() {
        let missing = find(Path::new("nowhere"), "tooth.nrrd", false).unwrap_err();
        assert_eq!(missing, format!("{} is missing", Path::new("nowhere").join("tooth.nrrd").display()));
    }

    #[test]
    #[should_panic(expected = "tooth.nrrd is missing, and VITRUM_REQUIRE_DATA is set")]
    fn what_is_required_and_missing_is_loud() {
        let _ = find(Path::new("nowhere"), "tooth.nrrd", true);
    }
}

//! Volumes, meshes and environment maps that lie beside the project and not in it, so that not everyone has them.

use std::env;
use std::io::{Write, stdout};
use std::path::{Path, PathBuf};
use std::thread;

/// What a test writes when it leaves itself out; `cargo xtask test` counts these lines.
const LEFT_OUT: &str = "[left out] ";

/// The path of a file of the shared data, `../shared/data` seen from the project's root.
///
/// Where the file is missing this says so on stdout, past the test harness's capture, and gives nothing: the test is then
/// left out.
///
/// # Panics
/// If the file is missing and `VITRUM_REQUIRE_DATA` is set, so that a machine that should have the data notices.
#[must_use]
pub fn shared(name: &str) -> Option<PathBuf> {
    let required = env::var_os("VITRUM_REQUIRE_DATA").is_some_and(|value| !value.is_empty() && value != "0");
    match find(&crate::root().join("../shared/data"), name, required) {
        Ok(path) => Some(path),
        Err(missing) => {
            let test = thread::current().name().unwrap_or("a test").to_owned();
            // Not `println!`, which the harness keeps to itself if the test passes. What cannot be written is not missed.
            let _ = writeln!(stdout(), "{LEFT_OUT}{test}: {missing}");
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

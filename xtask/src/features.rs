//! `cargo xtask features`: each feature of the crate of file formats compiles by itself, and all of them for a page.

use std::fs;

use crate::command::{cargo, root, run as run_command};
use crate::failure::Failure;
use crate::toolchain;

/// The crate with a feature for each file format.
const CRATE: &str = "vitrum-io";

/// The target of pages.
const PAGE: &str = "wasm32-unknown-unknown";

/// Check that vitrum-io compiles without features, with each of them alone, and for WebAssembly with all, and that it tells which
/// formats are left out.
#[derive(clap::Args, Default)]
pub struct Arguments {}

/// Checks one feature after the other; the first that does not compile ends it.
pub fn run(_arguments: &Arguments) -> Result<(), Failure> {
    let manifest = root().join("crates").join(CRATE).join("Cargo.toml");
    let text =
        fs::read_to_string(&manifest).map_err(|error| Failure::setup(format!("{}: {error}", manifest.display())))?;
    let alone = ["check", "--release", "--package", CRATE, "--no-default-features"];
    run_command(&mut cargo(alone))?;
    for feature in features(&text) {
        run_command(cargo(alone).args(["--features", &feature]))?;
    }
    run_command(&mut cargo(["test", "--release", "--package", CRATE, "--no-default-features", "--test", "left_out"]))?;
    require_target()?;
    run_command(&mut cargo(["check", "--release", "--package", CRATE, "--target", PAGE]))
}

/// Fails where the standard library of pages is not installed and rustup cannot fetch it.
fn require_target() -> Result<(), Failure> {
    if toolchain::has_target(PAGE) {
        return Ok(());
    }
    Err(Failure::setup(format!("the check for WebAssembly needs its standard library: rustup target add {PAGE}")))
}

/// The names of a manifest's features, without those that only name others.
fn features(manifest: &str) -> Vec<String> {
    let section = manifest.split("[features]").nth(1).and_then(|rest| rest.split("\n[").next()).unwrap_or_default();
    let entries = section.lines().filter_map(|line| line.split_once(" = ["));
    let names = entries.filter(|(name, _)| !matches!(*name, "default" | "volumes" | "meshes" | "pictures"));
    names.map(|(name, _)| name.trim().to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_format_is_found_in_the_manifest() {
        let text = fs::read_to_string(root().join("crates/vitrum-io/Cargo.toml")).expect("the manifest is there");
        let found = features(&text);
        for feature in ["nrrd", "dicom", "tiff", "gltf", "exr", "animations"] {
            assert!(found.iter().any(|found| found == feature), "{feature} not in {found:?}");
        }
        assert_eq!(features("[package]\n[features]\na = []\nmeshes = [\"a\"]\n\n[dependencies]\nb = []\n"), ["a"]);
    }
}

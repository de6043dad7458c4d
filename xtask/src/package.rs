//! `cargo xtask ci`, step `package`: every published package builds from its archive alone.

use crate::command::{self, cargo, run};
use crate::failure::Failure;

/// Packages of the workspace that are not published.
const UNPUBLISHED: [&str; 5] =
    ["vitrum-conformance", "vitrum-shader-compiler", "vitrum-shader-manifest", "vitrum-shader-translation", "xtask"];

/// Packs the published crates, and builds each package from its archive, with the other crates from theirs.
pub fn verify() -> Result<(), Failure> {
    let mut command = cargo(["package", "--workspace", "--allow-dirty"]);
    command.args(UNPUBLISHED.iter().flat_map(|package| ["--exclude", package]));
    // One folder for all, so that what they depend on is compiled once; cargo would take one for each.
    command.env("CARGO_TARGET_DIR", command::target());
    // It has to compile; nobody runs or debugs it.
    command.env("CARGO_PROFILE_DEV_OPT_LEVEL", "0").env("CARGO_PROFILE_DEV_DEBUG", "false");
    run(&mut command)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn what_is_not_published_is_known() {
        let root = command::root();
        let mut unpublished = Vec::new();
        for folder in ["", "crates", "xtask"] {
            for entry in fs::read_dir(root.join(folder)).unwrap() {
                let Ok(manifest) = fs::read_to_string(entry.unwrap().path().join("Cargo.toml")) else { continue };
                let name = manifest.lines().find_map(|line| line.strip_prefix("name = \"")?.strip_suffix('"'));
                let inherits = manifest.contains("version.workspace = true");
                if inherits && manifest.contains("\npublish = false\n") {
                    unpublished.push(name.unwrap().to_owned());
                }
            }
        }
        unpublished.sort();
        assert_eq!(unpublished, UNPUBLISHED);
    }
}

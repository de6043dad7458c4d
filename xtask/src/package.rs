//! `cargo xtask ci`, step `package`: every published package builds from its archive alone.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};
use std::{env, fs};

use crate::command::{self, cargo, run};
use crate::failure::Failure;

/// Packages of the workspace that are not published.
const UNPUBLISHED: [&str; 5] =
    ["vitrum-conformance", "vitrum-shader-compiler", "vitrum-shader-manifest", "vitrum-shader-translation", "xtask"];

/// Packs the published crates, and builds each package from its archive, with the other crates from theirs.
///
/// Cargo knows an unpacked archive by the place of its registry, its name and its version, never by its contents
/// (rust-lang/cargo, `sources/registry`): at a place that an earlier run used it would build that run's archives. Each run
/// therefore packs at a place of its own, and removes the place and the unpacked archives afterwards.
pub fn verify() -> Result<(), Failure> {
    let now = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_nanos());
    let folder = command::target().join(format!("package-{now}"));
    let unpacked_before = local_registries();
    let mut command = cargo(["package", "--workspace", "--allow-dirty"]);
    command.args(UNPUBLISHED.iter().flat_map(|package| ["--exclude", package]));
    // One folder for all packages, so that their dependencies are compiled once; cargo would take one for each.
    command.env("CARGO_TARGET_DIR", &folder);
    // It has to compile; nobody runs or debugs it.
    command.env("CARGO_PROFILE_DEV_OPT_LEVEL", "0").env("CARGO_PROFILE_DEV_DEBUG", "false");
    let result = run(&mut command);
    for leftover in local_registries().difference(&unpacked_before).chain([&folder]) {
        if let Err(error) = fs::remove_dir_all(leftover) {
            eprintln!("{} could not be removed: {error}", leftover.display());
        }
    }
    result
}

/// The folders with the unpacked archives of local registries: cargo names each `-` and a hash, without a host's name before it.
fn local_registries() -> BTreeSet<PathBuf> {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(Path::new(&env::var_os("HOME")?).join(".cargo")));
    let Some(entries) = home.and_then(|home| fs::read_dir(home.join("registry/src")).ok()) else {
        return BTreeSet::new();
    };
    let folders = entries.flatten().filter(|entry| entry.file_name().to_string_lossy().starts_with('-'));
    folders.map(|entry| entry.path()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

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

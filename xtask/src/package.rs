//! `cargo xtask ci`, step `package`: every published package compiles from its archive alone.

use std::fs;
use std::path::Path;

use crate::command::{self, cargo, run};
use crate::failure::Failure;

/// Packages of the workspace that are not published.
const UNPUBLISHED: [&str; 7] = [
    "vitrum-conformance",
    "vitrum-python",
    "vitrum-shader-compiler",
    "vitrum-shader-manifest",
    "vitrum-shader-translation",
    "vitrum-viewer",
    "xtask",
];

/// Packs the published crates, and compiles each package from its archive, with the other crates from theirs.
///
/// Cargo's own verification would generate code, too, for every dependency: that takes twice as long and finds nothing more about an archive, whose sources the
/// tests have compiled. Here compilation ends before, as `cargo check` has it.
pub fn verify() -> Result<(), Failure> {
    let folder = command::target().join("packages");
    if folder.exists() {
        let unusable = |error| Failure::setup(format!("{}: {error}", folder.display()));
        fs::remove_dir_all(&folder).map_err(unusable)?;
    }
    verify_in(&folder)
}

/// Does so in a folder of its own.
fn verify_in(folder: &Path) -> Result<(), Failure> {
    let mut command = cargo(["package", "--workspace", "--allow-dirty", "--no-verify"]);
    command.args(UNPUBLISHED.iter().flat_map(|package| ["--exclude", package]));
    run(command.env("CARGO_TARGET_DIR", folder))?;
    let unpacked = folder.join("unpacked");
    let names = unpack(&folder.join("package"), &unpacked)?;
    let write = |name: &str, text: String| {
        let path = unpacked.join(name);
        fs::write(&path, text).map_err(|error| Failure::setup(format!("{}: {error}", path.display())))
    };
    write("Cargo.toml", workspace(&names))?;
    let lock = command::root().join("Cargo.lock");
    write(
        "Cargo.lock",
        fs::read_to_string(&lock).map_err(|error| Failure::setup(format!("{}: {error}", lock.display())))?,
    )?;
    // All, with the features of the program, where the lints were: their dependencies have been looked at. Then those that others build on by themselves, with the
    // features that they ask for alone.
    let all = ["check", "--release", "--workspace"];
    let alone = ["check", "--release", "--package", "vitrum"];
    for arguments in [&all[..], &alone[..]] {
        let mut check = cargo(arguments.iter().copied());
        run(check.current_dir(&unpacked).env("CARGO_TARGET_DIR", command::target()))?;
    }
    Ok(())
}

/// Unpacks the archives in a folder, and gives the names of the folders that they make: those of the packages, and their versions.
fn unpack(archives: &Path, into: &Path) -> Result<Vec<String>, Failure> {
    let unreadable = |error| Failure::setup(format!("{}: {error}", archives.display()));
    fs::create_dir_all(into).map_err(|error| Failure::setup(format!("{}: {error}", into.display())))?;
    let mut names = Vec::new();
    for entry in fs::read_dir(archives).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.extension().is_some_and(|extension| extension == "crate") {
            run(command::program("tar").arg("-xzf").arg(&path).arg("-C").arg(into))?;
            names.extend(path.file_stem().map(|stem| stem.to_string_lossy().into_owned()));
        }
    }
    names.sort();
    if names.is_empty() {
        return Err(Failure::check(format!("{}: no archive was made", archives.display())));
    }
    Ok(names)
}

/// The package in a folder of an archive.
fn package(name: &str) -> &str {
    name.rsplit_once('-').map_or(name, |(package, _)| package)
}

/// The manifest of a workspace of unpacked archives, in which each stands for the published package.
fn workspace(names: &[String]) -> String {
    let members: Vec<String> = names.iter().map(|name| format!("{name:?}")).collect();
    let patches: Vec<String> =
        names.iter().map(|name| format!("{} = {{ path = {name:?} }}\n", package(name))).collect();
    format!(
        "[workspace]\nresolver = \"3\"\nmembers = [{}]\n\n[patch.crates-io]\n{}",
        members.join(", "),
        patches.concat()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_archive_stands_for_its_package() {
        let text = workspace(&["vitrum-0.1.0".to_owned(), "vitrum-io-0.1.0".to_owned()]);
        assert!(text.contains("members = [\"vitrum-0.1.0\", \"vitrum-io-0.1.0\"]"), "{text}");
        assert!(
            text.ends_with("\nvitrum = { path = \"vitrum-0.1.0\" }\nvitrum-io = { path = \"vitrum-io-0.1.0\" }\n"),
            "{text}"
        );
    }

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

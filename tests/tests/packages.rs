//! The files that a package includes lie in the package: with others it would compile here, and not from a registry.

use std::fs;
use std::path::{Component, Path, PathBuf};

use vitrum_conformance::root;

/// The packages' folders.
fn packages() -> Vec<PathBuf> {
    let folders = |parent: &str| {
        let entries = fs::read_dir(root().join(parent)).expect("the folder can be read");
        entries.map(|entry| entry.expect("it can be read").path()).filter(|path| path.join("Cargo.toml").exists())
    };
    folders("").chain(folders("crates")).chain(folders("xtask")).collect()
}

/// The sources below a folder that belong to its package.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("it can be read").path();
        let is_other = path.ends_with("target") || path.join("Cargo.toml").exists();
        if path.is_dir() && !is_other {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// The paths in what `include!`, `include_str!` and `include_bytes!` include, as far as they are literal: texts, one behind the other. A path
/// of the package's folder stands for that.
fn included(source: &str) -> Vec<String> {
    let places = source.match_indices("include").filter_map(|(at, _)| {
        let rest = &source[at..];
        let name = rest.split(['!', ' ']).next()?;
        let arguments = rest.strip_prefix(name)?.strip_prefix("!(")?;
        ["include", "include_str", "include_bytes"].contains(&name).then_some(arguments)
    });
    let literal = |arguments: &str| {
        let end = arguments.find(';').or(arguments.find('\n')).unwrap_or(arguments.len());
        let texts = arguments[..end].split('"').skip(1).step_by(2);
        texts.map(|text| if text == "CARGO_MANIFEST_DIR" { "\0" } else { text }).collect()
    };
    places.map(literal).collect()
}

/// Whether a path that a source includes lies in the package's folder.
fn stays_inside(package: &Path, source: &Path, path: &str) -> bool {
    let from = source.parent().expect("a file lies in a folder");
    let whole = match path.strip_prefix('\0') {
        Some(rest) => package.join(rest.trim_start_matches('/')),
        None => from.join(path),
    };
    let mut plain = PathBuf::new();
    for component in whole.components() {
        if component == Component::ParentDir {
            plain.pop();
        } else {
            plain.push(component);
        }
    }
    plain.starts_with(package)
}

#[test]
fn no_include_leaves_its_package() {
    let mut count = 0;
    for package in packages() {
        let mut files = Vec::new();
        sources(&package, &mut files);
        // This file has examples of includes that leave.
        for file in files.into_iter().filter(|file| !file.ends_with(file!())) {
            let source = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            for path in included(&source) {
                count += 1;
                assert!(stays_inside(&package, &file, &path), "{} includes {path}", file.display());
            }
        }
    }
    // The modules in SPIR-V and in WGSL are included by two places.
    assert!(count >= 2, "{count} places were found");
}

#[test]
fn what_leaves_is_found() {
    let (package, source) = (Path::new("/packages/a"), Path::new("/packages/a/src/lib.rs"));
    let leaves = |text: &str| included(text).iter().filter(|path| !stays_inside(package, source, path)).count();
    assert_eq!(
        leaves("include_str!(\"../data/a.txt\"); include_bytes!(concat!(\"../spirv/\", stringify!($name)));"),
        0
    );
    assert_eq!(leaves("const A: &str = include_str!(\"../../b/a.txt\");"), 1);
    assert_eq!(leaves("include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/../b/\", stringify!($name)));"), 1);
    assert_eq!(leaves("include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/b/a.bin\"));"), 0);
}

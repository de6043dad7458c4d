//! Hashes of the sources of the modules.

use crate::ManifestError;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The crates whose versions shape the modules: the kernels' own dependencies, the compiler's, and the translator.
const ROOTS: &[&str] = &["spirv-std", "cargo-gpu-install", "spirv-tools", "rspirv", "glam", "naga"];

/// SHA-256 in hexadecimal.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// SHA-256 over the names and contents of the sources of the crate in `folder`.
pub fn sources(folder: &Path) -> Result<String, ManifestError> {
    let mut files = vec![folder.join("Cargo.toml")];
    collect(&folder.join("src"), &mut files)?;
    files.sort();
    let mut all = Vec::new();
    for path in files {
        let contents = read(&path)?;
        let name = path.strip_prefix(folder).unwrap_or(&path);
        all.extend_from_slice(name.to_string_lossy().replace('\\', "/").as_bytes());
        all.push(0);
        // A checkout may have translated line ends.
        all.extend(contents.into_iter().filter(|&byte| byte != b'\r'));
        all.push(0);
    }
    Ok(sha256(&all))
}

/// SHA-256 over the lock file's entries (name, version, checksum) for everything the modules depend on.
pub fn locked_dependencies(lock: &Path) -> Result<String, ManifestError> {
    let malformed = |reason: String| ManifestError::Malformed { path: lock.to_path_buf(), reason };
    let text = String::from_utf8(read(lock)?).map_err(|error| malformed(error.to_string()))?;
    let parsed: toml::Table = text.parse().map_err(|error: toml::de::Error| malformed(error.to_string()))?;
    let packages =
        parsed.get("package").and_then(toml::Value::as_array).ok_or_else(|| malformed("no [[package]]".to_owned()))?;
    let mut by_name: BTreeMap<&str, Vec<&toml::Value>> = BTreeMap::new();
    for package in packages {
        if let Some(name) = package.get("name").and_then(toml::Value::as_str) {
            by_name.entry(name).or_default().push(package);
        }
    }
    let mut open: Vec<&str> = ROOTS.to_vec();
    let mut seen = BTreeSet::new();
    while let Some(name) = open.pop() {
        if !seen.insert(name) {
            continue;
        }
        for package in by_name.get(name).into_iter().flatten() {
            let dependencies = package.get("dependencies").and_then(toml::Value::as_array);
            // A dependency reads "name" or "name version".
            open.extend(
                dependencies.into_iter().flatten().filter_map(|dependency| dependency.as_str()?.split(' ').next()),
            );
        }
    }
    let field =
        |package: &toml::Value, key: &str| package.get(key).and_then(toml::Value::as_str).unwrap_or("").to_owned();
    let entries: BTreeSet<String> = seen
        .iter()
        .flat_map(|name| by_name.get(name).into_iter().flatten())
        .map(|package| {
            format!("{} {} {}\n", field(package, "name"), field(package, "version"), field(package, "checksum"))
        })
        .collect();
    Ok(sha256(entries.into_iter().collect::<String>().as_bytes()))
}

fn read(path: &Path) -> Result<Vec<u8>, ManifestError> {
    std::fs::read(path).map_err(|error| ManifestError::Unreadable { path: path.to_path_buf(), error })
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> Result<(), ManifestError> {
    let unreadable = |error| ManifestError::Unreadable { path: folder.to_path_buf(), error };
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}

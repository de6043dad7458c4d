//! The manifest of the committed modules: the sources, the lock file and the flags they were made from, and each module's hashes.
//!
//! `crates/vitrum-shaders/manifest.json` lets a test without the nightly toolchain tell whether the modules still belong to
//! the sources, the lock file and the flags.

mod error;
mod hash;

pub use error::ManifestError;
pub use hash::{locked_dependencies, sha256, sources};

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The pinned toolchain of rust-gpu 0.11.
pub const TOOLCHAIN: &str = "nightly-2026-08-15";
/// The target kernels are compiled for.
pub const TARGET: &str = "spirv-unknown-vulkan1.2";
/// The compiler's steps and flags, which shape the modules as the sources do; to be changed when they change.
pub const FLAGS: &[&str] = &[
    "rust-gpu 0.11.0",
    "--no-spirv-opt",
    "multimodule",
    "no-contraction",
    "glsl450-memory-model",
    "spirv-opt --strip-debug -O",
    "spirv-val vulkan1.2",
    "entry points named main",
    "WGSL by naga 30.0.1, compacted, shortened",
];

/// A file of a module.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct File {
    /// Path of the file from the manifest's folder, with forward slashes.
    pub path: String,
    /// SHA-256 of its contents.
    pub sha256: String,
    /// Size of the file in bytes.
    pub bytes: usize,
}

impl File {
    /// A file of these contents.
    pub fn new(path: String, contents: &[u8]) -> Self {
        Self { path, sha256: sha256(contents), bytes: contents.len() }
    }
}

/// One kernel's module.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Module {
    /// The module in SPIR-V.
    pub spirv: File,
    /// The module in WGSL, translated from SPIR-V.
    pub wgsl: File,
    /// The bindings of group 0 in order, such as `1 read voxels: u32`.
    pub bindings: Vec<String>,
}

/// The manifest of the committed modules: hashes of the sources and of each module.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Manifest {
    /// The toolchain.
    pub toolchain: String,
    /// The target.
    pub target: String,
    /// The compiler's steps.
    pub flags: Vec<String>,
    /// SHA-256 over the kernels' sources: names and contents.
    pub sources: String,
    /// SHA-256 over the lock file's entries for the kernels' dependencies and the compiler.
    pub lock: String,
    /// Modules by kernel.
    pub modules: BTreeMap<String, Module>,
}

/// The folder of the committed modules: crate `vitrum-shaders`.
pub fn folder(root: &Path) -> PathBuf {
    root.join("crates/vitrum-shaders")
}

impl Manifest {
    /// The manifest of the present tree, without modules.
    pub fn of_tree(root: &Path) -> Result<Self, ManifestError> {
        Ok(Self {
            toolchain: TOOLCHAIN.to_owned(),
            target: TARGET.to_owned(),
            flags: FLAGS.iter().map(|&flag| flag.to_owned()).collect(),
            sources: sources(&root.join("shaders-rs"))?,
            lock: locked_dependencies(&root.join("Cargo.lock"))?,
            modules: BTreeMap::new(),
        })
    }

    /// Reads the committed manifest.
    pub fn read(root: &Path) -> Result<Self, ManifestError> {
        let path = folder(root).join("manifest.json");
        let text =
            std::fs::read_to_string(&path).map_err(|error| ManifestError::Unreadable { path: path.clone(), error })?;
        serde_json::from_str(&text).map_err(|error| ManifestError::Malformed { path, reason: error.to_string() })
    }

    /// The text of the file: pretty JSON with a final newline.
    pub fn to_json(&self) -> Result<String, ManifestError> {
        serde_json::to_string_pretty(self)
            .map(|text| text + "\n")
            .map_err(|error| ManifestError::Malformed { path: "manifest.json".into(), reason: error.to_string() })
    }

    /// The differences between manifest and tree, one sentence each; empty if the committed modules are current.
    pub fn stale(&self, root: &Path) -> Result<Vec<String>, ManifestError> {
        let now = Self::of_tree(root)?;
        let mut reasons = Vec::new();
        let mut compare = |what: &str, committed: &str, current: &str| {
            if committed != current {
                reasons.push(format!("{what}: the manifest has {committed}, the tree has {current}"));
            }
        };
        compare("toolchain", &self.toolchain, &now.toolchain);
        compare("target", &self.target, &now.target);
        compare("flags", &self.flags.join(", "), &now.flags.join(", "));
        compare("sources of shaders-rs", &self.sources, &now.sources);
        compare("locked dependencies", &self.lock, &now.lock);
        for file in self.modules.values().flat_map(|module| [&module.spirv, &module.wgsl]) {
            let path = folder(root).join(&file.path);
            let bytes = std::fs::read(&path).map_err(|error| ManifestError::Unreadable { path, error })?;
            compare(&file.path, &file.sha256, &sha256(&bytes));
        }
        Ok(reasons)
    }
}

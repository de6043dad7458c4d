//! The manifest of the committed SPIR-V: what it was made from, and what is in it.
//!
//! `shaders-rs/spirv/manifest.json` lets a test without the nightly toolchain tell whether the `.spv` files still belong to
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
/// Everything that shapes the `.spv` files beside the sources: change it when the compiler's steps change.
pub const FLAGS: &[&str] = &[
    "rust-gpu 0.11.0",
    "--no-spirv-opt",
    "multimodule",
    "no-contraction",
    "glsl450-memory-model",
    "spirv-opt --strip-debug -O",
    "spirv-val vulkan1.2",
];

/// One module.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Module {
    /// File name in the manifest's folder.
    pub file: String,
    /// SHA-256 of the file.
    pub sha256: String,
    /// Bytes of the file.
    pub bytes: usize,
    /// What each binding of group 0 is, in order, e.g. `1 read voxels: u32`.
    pub bindings: Vec<String>,
}

/// What the committed SPIR-V was made from, and what is in it.
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
    /// Modules by entry point.
    pub modules: BTreeMap<String, Module>,
}

/// The folder of the committed modules.
pub fn folder(root: &Path) -> PathBuf {
    root.join("shaders-rs/spirv")
}

impl Manifest {
    /// A manifest of what is in the tree now, without modules.
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

    /// As it is written: pretty JSON with a final newline.
    pub fn to_json(&self) -> Result<String, ManifestError> {
        serde_json::to_string_pretty(self)
            .map(|text| text + "\n")
            .map_err(|error| ManifestError::Malformed { path: "manifest.json".into(), reason: error.to_string() })
    }

    /// What no longer matches the tree, one sentence each; empty if the committed modules are current.
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
        for (entry_point, module) in &self.modules {
            let path = folder(root).join(&module.file);
            let bytes = std::fs::read(&path).map_err(|error| ManifestError::Unreadable { path, error })?;
            compare(&format!("{} ({entry_point})", module.file), &module.sha256, &sha256(&bytes));
        }
        Ok(reasons)
    }
}

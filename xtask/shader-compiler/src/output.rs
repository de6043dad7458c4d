//! Step 5: the files of crate `vitrum-shaders`.

use anyhow::{Context, Result, bail};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use vitrum_shader_manifest::{Manifest, folder};

/// The folders that hold nothing but modules.
const FOLDERS: [&str; 2] = ["spirv", "wgsl"];

/// The files to write, by their paths from the crate's folder.
pub struct Output {
    folder: PathBuf,
    files: BTreeMap<String, Vec<u8>>,
}

impl Output {
    /// The modules' files, with the list of their names and the manifest.
    pub fn new(root: &Path, manifest: &Manifest, mut files: BTreeMap<String, Vec<u8>>) -> Result<Self> {
        files.insert("src/list.rs".to_owned(), list(manifest).into_bytes());
        files.insert("manifest.json".to_owned(), manifest.to_json()?.into_bytes());
        Ok(Self { folder: folder(root), files })
    }

    /// Writes all files; what else is in the modules' folders goes.
    pub fn write(&self) -> Result<()> {
        for folder in FOLDERS.map(|name| self.folder.join(name)) {
            if folder.exists() {
                std::fs::remove_dir_all(&folder).with_context(|| format!("{} cannot be emptied", folder.display()))?;
            }
            std::fs::create_dir_all(&folder).with_context(|| format!("{} cannot be made", folder.display()))?;
        }
        for (path, contents) in &self.files {
            let path = self.folder.join(path);
            std::fs::write(&path, contents).with_context(|| format!("{} cannot be written", path.display()))?;
            println!("{}: {} bytes", path.display(), contents.len());
        }
        Ok(())
    }

    /// Fails if a file differs from the committed one.
    pub fn compare(&self) -> Result<()> {
        let mut differing = Vec::new();
        for (path, contents) in &self.files {
            let committed = std::fs::read(self.folder.join(path)).unwrap_or_default();
            if committed != *contents {
                differing.push(format!("{path}: {} bytes committed, {} built", committed.len(), contents.len()));
            }
        }
        if !differing.is_empty() {
            bail!(
                "the committed modules are not what the sources give; run `cargo xtask shaders` and commit the result:\n  {}",
                differing.join("\n  ")
            );
        }
        println!("{} files are what the sources give", self.files.len());
        Ok(())
    }
}

/// `src/list.rs`: the modules' names.
fn list(manifest: &Manifest) -> String {
    let names: String = manifest.modules.keys().map(|name| format!("    {name}\n")).collect();
    format!("//! The kernels that have modules. `cargo xtask shaders` writes this file.\n\nmodules! {{\n{names}}}\n")
}

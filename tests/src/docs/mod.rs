//! Files in `docs/` that are made from the code: the scene's schema, and the tables of keys in `scene.md`.

mod keys;

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use vitrum::scene::Scene;

use crate::Failure;

/// A file that is made from the code.
pub struct Made {
    /// Path of the committed file.
    pub path: PathBuf,
    /// Text of the file, made from the code.
    pub text: String,
}

impl Made {
    /// Whether the committed file is the same. Git may have put other line ends into it.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn is_current(&self) -> Result<bool, Failure> {
        Ok(read(&self.path)?.lines().eq(self.text.lines()))
    }

    /// Writes the file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self) -> Result<(), Failure> {
        fs::write(&self.path, &self.text)
            .map_err(|error| Failure::Setup(format!("{}: cannot be written: {error}", self.path.display())))
    }
}

/// The files that are made from the code.
///
/// # Errors
/// If a page cannot be read, or marks the place of a table that there is not.
pub fn all() -> Result<Vec<Made>, Failure> {
    let folder = crate::root().join("docs");
    let schema = Scene::json_schema();
    let tree: Value = serde_json::from_str(&schema)
        .map_err(|error| Failure::Setup(format!("the scene's schema cannot be read: {error}")))?;
    let page = folder.join("scene.md");
    let text = keys::filled(&read(&page)?, &tree)
        .map_err(|problem| Failure::Setup(format!("{}: {problem}", page.display())))?;
    Ok(vec![
        Made { path: folder.join("vitrum-scene.schema.json"), text: format!("{schema}\n") },
        Made { path: page, text },
    ])
}

fn read(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|error| Failure::Setup(format!("{}: cannot be read: {error}", path.display())))
}

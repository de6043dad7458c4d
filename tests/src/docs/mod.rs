//! What is made from the code in `docs/`: the scene's schema, tables of keys, of names and of bounds.

mod keys;
mod sections;
mod tables;

use std::fs;
use std::path::{Path, PathBuf};

use vitrum::scene::Scene;

use crate::Failure;

/// The pages of `docs/` with sections that are made from the code.
const PAGES: [&str; 4] = ["scene.md", "program.md", "accuracy.md", "conformance.md"];

/// A file that is made from the code, all of it or in part.
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
    let page = |name: &str| -> Result<Made, Failure> {
        let path = folder.join(name);
        let wrong = |problem: String| Failure::Setup(format!("{}: {problem}", path.display()));
        let text = keys::filled(&read(&path)?).map_err(wrong)?;
        Ok(Made { text: tables::filled(&text).map_err(wrong)?, path })
    };
    let mut made = vec![Made { path: folder.join("vitrum-scene.schema.json"), text: format!("{schema}\n") }];
    for name in PAGES {
        made.push(page(name)?);
    }
    Ok(made)
}

fn read(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|error| Failure::Setup(format!("{}: cannot be read: {error}", path.display())))
}

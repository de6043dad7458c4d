//! The MTL files that an OBJ file names.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::mtl;
use super::statements::Statement;
use crate::detached::is_below;
use crate::error::{Error, Place, Report};
use crate::input::{Input, display_name};
use crate::mesh::Material;
use crate::mesh::build::Builder;
use crate::mesh::words::show;
use crate::tolerance::name;

/// Materials by name.
pub(super) struct Library<'a> {
    /// The folder of the mesh; `None` where its bytes alone were given.
    folder: Option<&'a Path>,
    materials: HashMap<String, Material>,
    loaded: Vec<PathBuf>,
}

impl<'a> Library<'a> {
    pub fn new(input: &'a Input) -> Self {
        Self { folder: input.folder_beside(), materials: HashMap::new(), loaded: Vec::new() }
    }

    /// Reads what a `mtllib` statement names: one file whose name may have spaces, or several.
    pub fn load(&mut self, builder: &mut Builder, statement: &Statement) -> Result<(), Error> {
        let whole = self.locate(statement.rest);
        let paths: Vec<_> = match whole {
            Some(path) => vec![path],
            None => statement.words().filter_map(|word| self.locate(word)).collect(),
        };
        if paths.is_empty() {
            let why = match self.folder {
                Some(_) if !is_below(&relative(statement.rest)) => {
                    "is not below the folder of the mesh, and was not read"
                }
                Some(_) => "is missing",
                None => "lies beside the mesh, whose bytes alone were given",
            };
            let note = format!("the file `{}` {why}: its materials have a name alone", show(statement.rest));
            // Some files name it once for each object.
            if !builder.assumptions.iter().any(|other| other.fact == note) {
                builder.assumptions.push(note);
            }
        }
        for path in paths {
            if !self.loaded.contains(&path) {
                match self.read(builder, &path) {
                    Ok(()) => {}
                    // Memory is the user's limit, and no fault of the file.
                    Err(error @ Error::TooLarge { .. }) => return Err(error),
                    Err(error) => builder.assumptions.push(format!("left out: materials, as of {error}")),
                }
                self.loaded.push(path);
            }
        }
        Ok(())
    }

    /// The path of a regular file below the folder; `None` where it is missing, or lies elsewhere.
    fn locate(&self, written: &[u8]) -> Option<PathBuf> {
        let relative = relative(written);
        let folder = self.folder.filter(|_| is_below(&relative))?;
        let path = folder.join(relative);
        path.is_file().then_some(path)
    }

    fn read(&mut self, builder: &mut Builder, path: &Path) -> Result<(), Error> {
        /// Real ones are a few kilobytes.
        const MOST_BYTES: u64 = 16 << 20;
        let file = display_name(path);
        let report = Report::new(&file);
        let length = fs::metadata(path).map_err(|error| report.unreadable(error))?.len();
        if length > MOST_BYTES {
            let problem = format!("{length} bytes of materials, and {MOST_BYTES} are the most");
            return Err(report.unsupported(Place::File, problem, "take out the materials that are not used"));
        }
        // The materials are not much larger than the text.
        builder.budget.take(2 * length)?;
        let bytes = fs::read(path).map_err(|error| report.unreadable(error))?;
        for material in mtl::read(&bytes, report, &mut builder.assumptions) {
            self.materials.entry(material.name.clone()).or_insert(material);
        }
        Ok(())
    }

    /// Puts descriptions to the names that faces use.
    pub fn describe(mut self, builder: &mut Builder) {
        let mut undescribed = Vec::new();
        for material in &mut builder.materials {
            match self.materials.remove(&material.name) {
                Some(described) => *material = described,
                None if material.name.is_empty() => {}
                None => undescribed.push(format!("`{}`", show(material.name.as_bytes()))),
            }
        }
        // Without any file that is told already.
        if !undescribed.is_empty() && !self.loaded.is_empty() {
            undescribed.truncate(16);
            builder.assumptions.push(format!("materials that no file describes: {}", undescribed.join(", ")));
        }
    }
}

/// A file's name with the separators that Windows does not have.
fn relative(written: &[u8]) -> String {
    name(written).replace('\\', "/")
}

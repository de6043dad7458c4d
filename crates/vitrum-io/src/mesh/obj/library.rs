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
use crate::mesh::words::{name, show};

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
        let whole = self.locate(builder.report, statement.place(), statement.rest)?;
        let words = || statement.words().map(|word| self.locate(builder.report, statement.place(), word));
        let paths: Vec<_> = match whole {
            Some(path) => vec![path],
            None => words().filter_map(Result::transpose).collect::<Result<_, _>>()?,
        };
        if paths.is_empty() {
            let why =
                if self.folder.is_some() { "is missing" } else { "lies beside the mesh, whose bytes alone were given" };
            let note = format!("the file `{}` {why}: its materials have a name alone", show(statement.rest));
            // Some files name it once for each object.
            if !builder.assumptions.iter().any(|other| other.fact == note) {
                builder.assumptions.push(note);
            }
        }
        for path in paths {
            if !self.loaded.contains(&path) {
                self.read(builder, &path)?;
                self.loaded.push(path);
            }
        }
        Ok(())
    }

    /// The path of a regular file below the folder; `None` where it is missing.
    fn locate(&self, report: Report, place: Place, written: &[u8]) -> Result<Option<PathBuf>, Error> {
        // As Windows writes it.
        let relative = name(report, place, written)?.replace('\\', "/");
        if !is_below(&relative) {
            let problem = format!("the file `{}` is not below the folder of the mesh", show(written));
            return Err(report.invalid(place, problem, "put it beside the mesh, and name it relative to that"));
        }
        Ok(self.folder.map(|folder| folder.join(relative)).filter(|path| path.is_file()))
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
        for material in mtl::read(&bytes, report, &mut builder.assumptions)? {
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

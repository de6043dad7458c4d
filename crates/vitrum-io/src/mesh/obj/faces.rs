//! The second pass: faces and their materials.

use std::collections::{BTreeSet, HashMap};

use super::corners::{Before, Corners};
use super::library::Library;
use super::statements::{Statement, Statements};
use super::vertices::Vertices;
use crate::error::Error;
use crate::input::Input;
use crate::mesh::Material;
use crate::mesh::build::Builder;
use crate::mesh::words::show;
use crate::tolerance::name;

/// The reader of faces, with the triangles that it has read so far.
pub(super) struct Faces<'a, 'b> {
    builder: &'a mut Builder<'b>,
    corners: Corners<'a>,
    library: Library<'a>,
    before: Before,
    /// Indices of the materials that were named.
    materials: HashMap<String, u32>,
    current: Option<u32>,
    face: Vec<u32>,
    /// Keywords of statements that were left out.
    left_out: BTreeSet<String>,
}

impl<'a, 'b> Faces<'a, 'b> {
    pub fn new(input: &'a Input, vertices: &'a Vertices, builder: &'a mut Builder<'b>) -> Result<Self, Error> {
        Ok(Self {
            corners: Corners::new(vertices, builder)?,
            builder,
            library: Library::new(input),
            before: Before::default(),
            materials: HashMap::new(),
            current: None,
            face: Vec::new(),
            left_out: BTreeSet::new(),
        })
    }

    pub fn read(mut self, bytes: &[u8]) -> Result<(), Error> {
        let mut statements = Statements::new(bytes);
        while let Some(statement) = statements.next() {
            match statement.keyword {
                b"v" => self.before.positions += 1,
                b"vn" => self.before.normals += 1,
                b"f" | b"fo" => self.add_face(&statement)?,
                b"usemtl" => self.use_material(&statement)?,
                b"mtllib" => self.library.load(self.builder, &statement)?,
                // Names and smoothing of groups change no triangle.
                b"o" | b"g" | b"s" | b"vt" => {}
                // A hostile file may have a new one in each line.
                keyword if self.left_out.len() < 16 => {
                    self.left_out.insert(format!("`{}`", show(keyword)));
                }
                _ => {}
            }
        }
        self.finish()
    }

    fn add_face(&mut self, statement: &Statement) -> Result<(), Error> {
        self.face.clear();
        for word in statement.words() {
            let corner = self.corners.vertex(self.builder, statement.place(), word, self.before)?;
            self.face.push(corner);
        }
        self.builder.polygon(statement.place(), &self.face)
    }

    /// The triangles up to here have the material before.
    fn use_material(&mut self, statement: &Statement) -> Result<(), Error> {
        self.assign()?;
        let name = name(statement.rest);
        self.current = Some(match self.materials.get(&name) {
            Some(&index) => index,
            None => self.add_material(name)?,
        });
        Ok(())
    }

    fn assign(&mut self) -> Result<(), Error> {
        if self.builder.triangle_materials.len() == self.builder.triangles.len() {
            return Ok(());
        }
        let current = match self.current {
            Some(index) => index,
            None => self.add_material(String::new())?,
        };
        self.builder.assign(current)
    }

    fn add_material(&mut self, name: String) -> Result<u32, Error> {
        let index = self.builder.materials.len() as u32;
        self.builder.budget.take(4 * name.len() as u64)?;
        self.builder
            .budget
            .push(&mut self.builder.materials, Material { name: name.clone(), ..Material::default() })?;
        self.materials.insert(name, index);
        Ok(index)
    }

    fn finish(mut self) -> Result<(), Error> {
        // A file that names no material has none.
        if !self.materials.is_empty() {
            self.assign()?;
        }
        self.library.describe(self.builder);
        self.corners.finish(self.builder);
        if !self.left_out.is_empty() {
            let names: Vec<_> = self.left_out.into_iter().collect();
            self.builder
                .assumptions
                .push(format!("statements that make no triangles were left out: {}", names.join(", ")));
        }
        Ok(())
    }
}

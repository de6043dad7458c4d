//! Wavefront OBJ files, and the MTL files beside them that describe their materials.
//!
//! The formats: <https://paulbourke.net/dataformats/obj/>, <https://paulbourke.net/dataformats/mtl/>.

mod corners;
mod faces;
mod library;
mod mtl;
mod statements;
mod vertices;

use self::faces::Faces;
use self::statements::Statements;
use self::vertices::Vertices;
use super::Mesh;
use super::build::start;
use super::reader::MeshReader;
use crate::error::Error;
use crate::formats::{self, Format};
use crate::input::Input;
use crate::options::OpenOptions;

/// The reader of `.obj` files.
pub(crate) struct Obj;

impl MeshReader for Obj {
    fn format(&self) -> &'static Format {
        &formats::OBJ
    }

    /// Recognises a file by its first statements, since OBJ has no magic number: a vertex is among them, and no statement that OBJ does
    /// not have.
    fn recognises(&self, input: &Input) -> bool {
        // The last line may be cut off.
        let Some(end) = input.head.iter().rposition(|&byte| byte == b'\n') else { return false };
        let mut statements = Statements::new(&input.head[..end]);
        let mut vertices = 0;
        while let Some(statement) = statements.next() {
            match statement.keyword {
                b"v" => vertices += 1,
                b"vt" | b"vn" | b"f" | b"o" | b"g" | b"s" | b"mtllib" | b"usemtl" => {}
                _ => return false,
            }
        }
        vertices > 0
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Mesh, Error> {
        let (bytes, mut builder) = start(input, options)?;
        // Vertices first: faces may stand anywhere.
        let vertices = Vertices::read(&bytes, &mut builder)?;
        Faces::new(input, &vertices, &mut builder)?.read(&bytes)?;
        builder.finish(self.format().name, "text", "ascii")
    }
}

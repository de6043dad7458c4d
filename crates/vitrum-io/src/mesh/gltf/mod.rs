//! glTF 2.0: JSON that describes nodes, meshes and materials, and buffers of bytes; GLB is both in one file.
//!
//! The format: <https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html>.

mod accessor;
mod buffers;
mod container;
mod document;
mod lookup;
mod materials;
mod primitive;
mod scene;
mod transform;

use self::buffers::Buffers;
use self::container::Container;
use self::document::Document;
use self::scene::Assembly;
use super::Mesh;
use super::build::start;
use super::reader::MeshReader;
use crate::error::Error;
use crate::formats::{self, Format};
use crate::input::Input;
use crate::options::OpenOptions;

/// The reader of `.gltf` and `.glb` files.
pub(crate) struct Gltf;

impl MeshReader for Gltf {
    fn format(&self) -> &'static Format {
        &formats::GLTF
    }

    fn recognises(&self, input: &Input) -> bool {
        let is_json = || input.head.trim_ascii_start().starts_with(b"{");
        let names = |word: &[u8]| input.head.windows(word.len()).any(|window| window == word);
        let words: [&[u8]; 4] = [b"\"asset\"", b"\"accessors\"", b"\"bufferViews\"", b"\"scenes\""];
        self.format().begins(&input.head) || is_json() && words.into_iter().any(names)
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Mesh, Error> {
        let (bytes, mut builder) = start(input, options)?;
        let container = Container::split(&bytes, builder.report)?;
        builder.assumptions.extend(container.surplus_note());
        let document = Document::parse(container.json, &builder)?;
        let buffers = Buffers::load(&document, container.binary, input, &mut builder)?;
        Assembly::new(&document, &buffers, &mut builder).assemble()?;
        let encoding =
            if container.binary.is_some() { "GLB, little-endian" } else { "JSON and buffers, little-endian" };
        builder.finish(self.format().name, "float", encoding)
    }
}

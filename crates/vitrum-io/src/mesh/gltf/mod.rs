//! glTF 2.0: JSON that describes nodes, meshes and materials, and buffers of bytes; GLB is both in one file.
//!
//! The format: <https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html>.

mod accessor;
mod buffers;
mod container;
mod document;
mod materials;
mod primitive;
mod scene;
mod transform;

use self::buffers::Buffers;
use self::container::Container;
use self::document::Document;
use self::scene::Assembly;
use super::open::start;
use super::{Mesh, MeshReader};
use crate::error::{Error, Place, Report};
use crate::input::Input;
use crate::open::OpenOptions;

/// The reader of `.gltf` and `.glb` files.
pub(crate) struct Gltf;

impl MeshReader for Gltf {
    fn name(&self) -> &'static str {
        "glTF"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &[".gltf", ".glb"]
    }

    fn recognises(&self, input: &Input) -> bool {
        let is_json = || input.head.trim_ascii_start().starts_with(b"{");
        let names = |word: &[u8]| input.head.windows(word.len()).any(|window| window == word);
        let words: [&[u8]; 4] = [b"\"asset\"", b"\"accessors\"", b"\"bufferViews\"", b"\"scenes\""];
        input.head.starts_with(container::MAGIC) || is_json() && words.into_iter().any(names)
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
        builder.finish(self.name(), "float", encoding)
    }
}

/// The element of a list that the file names by its index; `from` says where, such as `nodes[3].mesh`.
fn lookup<'a, T>(
    report: Report,
    list: &'a [T],
    name: &str,
    index: usize,
    from: impl FnOnce() -> String,
) -> Result<&'a T, Error> {
    list.get(index).ok_or_else(|| {
        let problem = format!("{} is {index}, and there are {} {name}, counted from 0", from(), list.len());
        report.invalid(Place::File, problem, "correct the index")
    })
}

//! STL files: triangles one by one, as text or as 50 bytes each.
//!
//! The format: <https://www.loc.gov/preservation/digital/formats/fdd/fdd000505.shtml>.

mod ascii;
mod binary;

use glam::DVec3;

use super::Mesh;
use super::build::Builder;
use super::build::start;
use super::reader::MeshReader;
use super::weld::Weld;
use crate::error::Error;
use crate::formats::{self, Format};
use crate::input::Input;
use crate::options::OpenOptions;
use crate::packing::Packing;

/// The reader of `.stl` files.
pub(crate) struct Stl;

impl MeshReader for Stl {
    fn format(&self) -> &'static Format {
        &formats::STL
    }

    fn recognises(&self, input: &Input) -> bool {
        let fits = input.packing == Packing::Plain && binary::has_size(&input.head, input.length);
        fits || ascii::is_text(&input.head) && input.head.windows(5).any(|word| word.eq_ignore_ascii_case(b"facet"))
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Mesh, Error> {
        let (bytes, builder) = start(input, options)?;
        let mut facets = Facets { builder, weld: Weld::default(), opposite: 0 };
        // Binary files may start with `solid` too, and text never has their size by chance.
        let text = ascii::is_text(&input.head) && !binary::has_size(&bytes, bytes.len() as u64);
        if text {
            ascii::read(&bytes, &mut facets)?;
        } else {
            binary::read(&bytes, &mut facets)?;
        }
        if facets.opposite > 0 {
            let note = format!(
                "{} normals point against the order of their triangles' corners, which was followed",
                facets.opposite
            );
            facets.builder.assumptions.push(note);
        }
        let encoding = if text { "ascii" } else { "binary, little-endian" };
        facets.builder.finish(self.format().name, if text { "text" } else { "float" }, encoding)
    }
}

/// Triangles in the making: corners at one position become one vertex.
struct Facets<'a> {
    builder: Builder<'a>,
    weld: Weld,
    /// Count of the normals that contradict their triangle.
    opposite: u64,
}

impl Facets<'_> {
    fn add(&mut self, normal: [f32; 3], corners: [[f32; 3]; 3]) -> Result<(), Error> {
        let mut triangle = [0; 3];
        for (vertex, position) in triangle.iter_mut().zip(corners) {
            let (number, new) = self.weld.number(position);
            if new {
                // The table of positions takes about as much again.
                self.builder.budget.take(size_of::<[u32; 4]>() as u64)?;
                self.builder.budget.push(&mut self.builder.positions, position)?;
            }
            *vertex = number;
        }
        let [a, b, c] = corners.map(|corner| DVec3::from(corner.map(f64::from)));
        let wound = (b - a).cross(c - a);
        self.opposite += u64::from(wound.dot(DVec3::from(normal.map(f64::from))) < 0.0);
        self.builder.triangle(triangle)
    }
}

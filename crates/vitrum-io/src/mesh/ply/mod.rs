//! PLY files: a header of elements and their properties, then the elements as text or bytes.
//!
//! The format: <https://paulbourke.net/dataformats/ply/>.

mod faces;
mod header;
mod source;
mod vertices;

use self::header::{Element, Header, Kind};
use self::source::Source;
use super::Mesh;
use super::build::start;
use super::reader::MeshReader;
use super::strip::joints_note;
use crate::error::{Error, Report, clip};
use crate::formats::{self, Format};
use crate::input::Input;
use crate::options::OpenOptions;

/// The reader of `.ply` files.
pub(crate) struct Ply;

impl MeshReader for Ply {
    fn format(&self) -> &'static Format {
        &formats::PLY
    }

    fn recognises(&self, input: &Input) -> bool {
        self.format().begins(&input.head)
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Mesh, Error> {
        let (bytes, mut builder) = start(input, options)?;
        let report = builder.report;
        let mut header = Header::read(&bytes, report)?;
        std::mem::take(&mut header.left_out).tell(&mut builder.assumptions);
        let mut source = Source::new(&bytes, &header);
        // Faces may stand before the vertices that they name: then they are read in the end.
        let mut early = Vec::new();
        let mut coordinates = None;
        let mut joints = 0;
        let mut faults: Vec<_> = header.elements.iter_mut().map(|element| element.fault.take()).collect();
        for (index, element) in header.elements.iter().enumerate() {
            if !element.is_needed() {
                let skipped = match faults[index].take() {
                    Some(error) => Err(error),
                    None => check_size(report, &source, element).and_then(|()| skip(report, &mut source, element)),
                };
                builder.assumptions.push(format!("the element `{}` was left out", clip(&element.name)));
                match skipped {
                    Ok(()) => continue,
                    Err(error) if header.elements[index..].iter().any(Element::is_needed) => return Err(error),
                    // Nothing behind it is needed.
                    Err(_) => break,
                }
            }
            check_size(report, &source, element)?;
            match element.name.as_str() {
                "vertex" => coordinates = Some(vertices::read(&mut source, element, &mut builder)?),
                "face" | "tristrips" if coordinates.is_none() => {
                    early.push((source.clone(), element));
                    skip(report, &mut source, element)?;
                }
                _ => joints += faces::read(&mut source, element, &mut builder)?,
            }
        }
        let Some(coordinates) = coordinates else {
            let advice = "add lines such as `element vertex 8` and `property float x`";
            return Err(report.invalid(crate::error::Place::File, "the header has no element `vertex`", advice));
        };
        for (mut source, element) in early {
            joints += faces::read(&mut source, element, &mut builder)?;
        }
        builder.assumptions.extend(joints_note(joints));
        builder.assumptions.extend(source.surplus_note());
        builder.finish(self.format().name, coordinates, header.encoding.describe())
    }
}

/// Fails where the bytes that are left cannot hold the element, so that its count can be believed.
fn check_size(report: Report, source: &Source, element: &Element) -> Result<(), Error> {
    let least = element.properties.iter().map(|property| source.least_bytes(property.kind)).sum::<u64>();
    let needed = element.count.checked_mul(least);
    if needed.is_none_or(|needed| needed > source.left()) {
        return Err(report.invalid(
            source.place(),
            format!(
                "the header promises {} of the element `{}` from here, of {least} bytes at least each, and {} bytes \
                 are there",
                element.count,
                clip(&element.name),
                source.bytes_left()
            ),
            "get the whole file, or correct the count in the header",
        ));
    }
    Ok(())
}

fn skip(report: Report, source: &mut Source, element: &Element) -> Result<(), Error> {
    if element.properties.is_empty() {
        return Ok(());
    }
    for _ in 0..element.count {
        for property in &element.properties {
            skip_property(report, source, property.kind)?;
        }
    }
    Ok(())
}

fn skip_property(report: Report, source: &mut Source, kind: Kind) -> Result<(), Error> {
    match kind {
        Kind::Scalar(scalar) => source.value(report, scalar).map(drop),
        Kind::List { count, item } => {
            let count = source.list_length(report, count, item)?;
            (0..count).try_for_each(|_| source.value(report, item).map(drop))
        }
    }
}

/// A note on properties that no one asked for.
fn left_out_note(element: &Element, is_used: impl Fn(usize) -> bool) -> Option<String> {
    let unused = element.properties.iter().enumerate().filter(|(index, _)| !is_used(*index));
    let names: Vec<_> = unused.map(|(_, property)| format!("`{}`", clip(&property.name))).collect();
    let verb = if names.len() == 1 { "property was" } else { "properties were" };
    (!names.is_empty()).then(|| format!("of the element `{}`, the {verb} left out: {}", element.name, names.join(", ")))
}

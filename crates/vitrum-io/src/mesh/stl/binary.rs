//! STL as bytes: a header of 80, the number of triangles, and 50 for each.

use super::Facets;
use crate::error::{Error, Place};
use crate::mesh::words::show;

const HEADER: u64 = 84;
const FACET: u64 = 50;

/// Whether a file has exactly the size that its count of triangles asks for.
pub(super) fn has_size(head: &[u8], length: u64) -> bool {
    count(head).is_some_and(|count| count > 0 && HEADER + FACET * count == length)
}

fn count(head: &[u8]) -> Option<u64> {
    let bytes = head.get(80..84)?.try_into().ok()?;
    Some(u64::from(u32::from_le_bytes(bytes)))
}

pub(super) fn read(bytes: &[u8], facets: &mut Facets) -> Result<(), Error> {
    let report = facets.builder.report;
    let Some(count) = count(bytes) else {
        return Err(report.invalid(
            Place::File,
            format!(
                "{} bytes are no STL file: text starts with `solid`, and binary has 84 bytes at least",
                bytes.len()
            ),
            "check that this is an STL file, and get the whole of it",
        ));
    };
    let there = bytes.len() as u64 - HEADER;
    let needed = FACET * count;
    if there < needed {
        return Err(report.invalid(
            Place::Byte(HEADER - 4),
            format!("the header promises {count} triangles, which take {needed} bytes, and {there} follow"),
            "get the whole file, or correct the count",
        ));
    }
    if there > needed {
        let note = format!("{} bytes behind the last triangle were left unread", there - needed);
        facets.builder.assumptions.push(note);
    }
    let mut attributes = 0_u64;
    for (index, facet) in bytes[HEADER as usize..].chunks_exact(FACET as usize).take(count as usize).enumerate() {
        let vector = |start: usize| -> [f32; 3] {
            std::array::from_fn(|axis| {
                let at = start + 4 * axis;
                f32::from_le_bytes([facet[at], facet[at + 1], facet[at + 2], facet[at + 3]])
            })
        };
        let corners = [vector(12), vector(24), vector(36)];
        if let Some(corner) = corners.iter().position(|corner| corner.iter().any(|value| !value.is_finite())) {
            return Err(report.invalid(
                Place::Byte(HEADER + FACET * index as u64 + 12 + 12 * corner as u64),
                format!("corner {corner} of triangle {index} is {:?}, which is not finite", corners[corner]),
                "correct the corner, or take the triangle out",
            ));
        }
        facets.add(vector(0), corners)?;
        attributes += u64::from(facet[48..50] != [0, 0]);
    }
    if attributes > 0 {
        let note = format!("the attributes of {attributes} triangles, perhaps colours, were left out");
        facets.builder.assumptions.push(note);
    }
    if bytes.starts_with(b"solid") {
        let name = show(bytes[..80].split(|byte| *byte == 0).next().unwrap_or_default());
        facets
            .builder
            .assumptions
            .push(format!("the header starts like text, `{}`, and the rest is binary", name.trim_end()));
    }
    Ok(())
}

//! A PLY file's faces, polygons or strips of triangles.

use super::header::{Element, Kind};
use super::source::Source;
use super::{left_out_note, skip_property};
use crate::error::{Error, Place, Report};
use crate::mesh::build::Builder;
use crate::mesh::strip::strip;

/// Reads all faces, whose vertices are there; how many triangles of strips were left out.
pub(super) fn read(source: &mut Source, element: &Element, builder: &mut Builder) -> Result<u64, Error> {
    let report = builder.report;
    let names = ["vertex_indices", "vertex_index"];
    let found = element.properties.iter().position(|property| names.contains(&property.name.as_str()));
    let list = found.and_then(|index| match element.properties[index].kind {
        Kind::List { count, item } => Some((index, count, item)),
        Kind::Scalar(_) => None,
    });
    let Some((list, count_type, item_type)) = list else {
        return Err(report.invalid(
            Place::Line(element.line),
            format!("the element `{}` has no list `vertex_indices`", element.name),
            "add a line such as `property list uchar int vertex_indices`",
        ));
    };
    builder.assumptions.extend(left_out_note(element, |index| index == list));
    let strips = element.name == "tristrips";
    let mut corners = Vec::new();
    let mut joints = 0;
    for _ in 0..element.count {
        let mut place = source.place();
        for (index, property) in element.properties.iter().enumerate() {
            if index != list {
                skip_property(report, source, property.kind)?;
                continue;
            }
            let length = source.list_length(report, count_type, item_type)?;
            corners.clear();
            for _ in 0..length {
                let value = source.value(report, item_type)?;
                if matches!(source, Source::Text { .. }) {
                    place = source.place();
                }
                if strips && value == -1.0 {
                    joints += strip(builder, &corners)?;
                    corners.clear();
                } else {
                    corners.push(vertex(report, place, value, builder.positions.len())?);
                }
            }
        }
        if strips {
            joints += strip(builder, &corners)?;
        } else {
            builder.polygon(place, &corners)?;
        }
    }
    Ok(joints)
}

fn vertex(report: Report, place: Place, value: f64, vertices: usize) -> Result<u32, Error> {
    // NaN is neither.
    if value >= 0.0 && value < vertices as f64 && value.fract() == 0.0 && value <= f64::from(u32::MAX) {
        return Ok(value as u32);
    }
    let problem = format!("the face names vertex {value}, counted from 0, and there are {vertices}");
    Err(report.invalid(place, problem, "correct the index, or get the whole file"))
}

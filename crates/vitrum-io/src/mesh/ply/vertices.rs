//! A PLY file's vertices.

use super::header::{Element, Kind, Scalar};
use super::source::Source;
use super::{left_out_note, skip_property};
use crate::error::{Error, Place, Report};
use crate::image::srgb_to_linear;
use crate::mesh::build::Builder;

/// Names that a property may have, for each number that a vertex can have here.
const NAMES: [&[&str]; 10] = [
    &["x"],
    &["y"],
    &["z"],
    &["nx", "normal_x"],
    &["ny", "normal_y"],
    &["nz", "normal_z"],
    &["red", "r", "diffuse_red"],
    &["green", "g", "diffuse_green"],
    &["blue", "b", "diffuse_blue"],
    &["alpha", "a", "diffuse_alpha"],
];

/// Layout of a vertex: the property of each number.
struct Layout {
    /// For each property, its index into [`NAMES`].
    slots: Vec<Option<usize>>,
    /// The type of each number that is there.
    types: [Option<Scalar>; NAMES.len()],
}

impl Layout {
    fn new(report: Report, element: &Element) -> Result<Self, Error> {
        let mut types = [None; NAMES.len()];
        let mut slots = vec![None; element.properties.len()];
        for (slot, names) in NAMES.iter().enumerate() {
            // An earlier name goes before a later one.
            let found = names.iter().find_map(|name| element.properties.iter().position(|one| one.name == *name));
            if let Some((index, Kind::Scalar(scalar))) = found.map(|index| (index, element.properties[index].kind)) {
                types[slot] = Some(scalar);
                slots[index] = Some(slot);
            }
        }
        if let Some(missing) = (0..3).find(|&slot| types[slot].is_none()) {
            let name = NAMES[missing][0];
            return Err(report.invalid(
                Place::Line(element.line),
                format!("the vertices have no property `{name}`"),
                format!("add a line such as `property float {name}`"),
            ));
        }
        let mut layout = Self { slots, types };
        if !layout.has(3..6) {
            layout.drop(3..6);
        }
        let is_color = |scalar: Scalar| matches!(scalar, Scalar::U8 | Scalar::U16 | Scalar::F32 | Scalar::F64);
        if !layout.has(6..9) || !layout.types[6..].iter().flatten().all(|&scalar| is_color(scalar)) {
            layout.drop(6..10);
        }
        Ok(layout)
    }

    fn has(&self, mut slots: std::ops::Range<usize>) -> bool {
        slots.all(|slot| self.types[slot].is_some())
    }

    fn drop(&mut self, slots: std::ops::Range<usize>) {
        self.slots
            .iter_mut()
            .filter(|slot| slot.is_some_and(|slot| slots.contains(&slot)))
            .for_each(|slot| *slot = None);
        self.types[slots].fill(None);
    }

    fn color(&self, row: &[f64; NAMES.len()]) -> [f32; 4] {
        let channel = |slot: usize| match self.types[slot] {
            None => 1.0,
            Some(Scalar::U8) => (row[slot] / 255.0) as f32,
            Some(Scalar::U16) => (row[slot] / 65535.0) as f32,
            Some(_) => row[slot] as f32,
        };
        let light = |slot: usize| match self.types[slot] {
            Some(Scalar::U8 | Scalar::U16) => srgb_to_linear(channel(slot)),
            _ => channel(slot),
        };
        [light(6), light(7), light(8), channel(9)]
    }
}

/// Reads all vertices; the type of their coordinates.
pub(super) fn read(source: &mut Source, element: &Element, builder: &mut Builder) -> Result<&'static str, Error> {
    let report = builder.report;
    let layout = Layout::new(report, element)?;
    builder.assumptions.extend(left_out_note(element, |index| layout.slots[index].is_some()));
    builder.positions = builder.budget.reserve(element.count)?;
    if layout.has(3..6) {
        builder.normals = builder.budget.reserve(element.count)?;
    }
    if layout.has(6..9) {
        builder.colors = builder.budget.reserve(element.count)?;
    }
    let mut row = [0.0; NAMES.len()];
    for _ in 0..element.count {
        for (property, slot) in element.properties.iter().zip(&layout.slots) {
            match (property.kind, slot) {
                (Kind::Scalar(scalar), Some(slot)) => row[*slot] = source.value(report, scalar)?,
                (kind, _) => skip_property(report, source, kind)?,
            }
        }
        let vector = |first: usize| -> [f32; 3] { std::array::from_fn(|axis| row[first + axis] as f32) };
        builder.positions.push(vector(0));
        if layout.has(3..6) {
            builder.normals.push(vector(3));
        }
        if layout.has(6..9) {
            builder.colors.push(layout.color(&row));
        }
    }
    note_assumptions(&layout, builder);
    Ok(layout.types[0].map_or("", Scalar::name))
}

fn note_assumptions(layout: &Layout, builder: &mut Builder) {
    let mut note = |text: &str| builder.assumptions.push(text.to_owned());
    if layout.types[..3].contains(&Some(Scalar::F64)) {
        note("the coordinates were rounded from float64 to float32");
    }
    match layout.types[6] {
        Some(Scalar::U8 | Scalar::U16) => note("the colours were taken for sRGB, and decoded"),
        Some(_) => note("the colours were taken for linear RGB, as they are floats"),
        None => {}
    }
}

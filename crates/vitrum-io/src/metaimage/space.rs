//! Placement of a MetaImage grid in the world: spacings, a matrix of directions and an offset.

use crate::error::{Error, Place, Report, clip};
use crate::fields::{Field, Fields};
use crate::options::OpenOptions;
use crate::orientation::Orientation;
use crate::placement::{Placement, millimetres};
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};
use crate::tolerance;
use crate::volume::IDENTITY;

/// The format's world is LPS+: x to the patient's left, y to posterior, z to superior. Ours is RAS+.
const SIGNS: [f64; 3] = [-1.0, -1.0, 1.0];

/// The placement of the grid. `rank` is the number of axes in the file; axes behind the third have no extent.
pub(super) fn placement(
    fields: &Fields,
    report: Report,
    rank: usize,
    options: &OpenOptions,
    assumptions: &mut Assumptions,
) -> Result<Placement, Error> {
    let scale = unit_scale(fields, assumptions);
    let spacing = spacing(fields, report, rank, scale, options, assumptions)?;
    let to_world = |vector: [f64; 3]| -> [f64; 3] { std::array::from_fn(|axis| vector[axis] * SIGNS[axis]) };
    // Newer files say `Offset` and `TransformMatrix`, older ones one of the other names.
    let any_of = |names: [&str; 3]| names.into_iter().find_map(|name| fields.get(name));
    let origin = any_of(["Offset", "Position", "Origin"]);
    if fields.get("ElementSpacing").or(fields.get("ElementSize")).is_some() {
        assumptions.note_origin("spacing", "`ElementSpacing`, or else `ElementSize`");
    }
    let origin_place = origin.map(Field::place);
    let origin = origin.map(|field| field.numbers::<f64>(report, rank)).transpose()?;
    let origin = origin.map(|origin| to_world([0, 1, 2].map(|axis| origin[axis] * scale)));
    let matrix = any_of(["TransformMatrix", "Orientation", "Rotation"]);
    let (directions, orientation): ([[f64; 3]; 3], _) = match matrix {
        Some(field) => {
            assumptions.note_origin("orientation", "`TransformMatrix`");
            // Each row is an axis of the grid.
            let numbers: Vec<f64> = field.numbers(report, rank * rank)?;
            let row = |axis: usize| std::array::from_fn(|component| numbers[rank * axis + component]);
            (std::array::from_fn(row), Orientation::Patient)
        }
        None => unstated(fields, assumptions),
    };
    let columns = [0, 1, 2].map(|axis| to_world(directions[axis].map(|component| component * spacing[axis])));
    let placement = Placement::mended(columns, origin, orientation, options, assumptions).map_err(|problem| {
        let place = matrix.map(Field::place).or(origin_place).unwrap_or(Place::File);
        report.invalid(place, problem, "correct the directions or the offset")
    })?;
    assumptions.extend(placement.shear_note());
    Ok(placement)
}

/// The directions of a file without a matrix of them, and whether anything says them.
fn unstated(fields: &Fields, assumptions: &mut Assumptions) -> ([[f64; 3]; 3], Orientation) {
    // ITK writes question marks where it does not know.
    let Some(field) = fields.get("AnatomicalOrientation").filter(|field| !field.text.contains('?')) else {
        let fact = "the file has no TransformMatrix: its axes were taken to point to the patient's left, posterior and \
                    superior, the format's default";
        assumptions.push(Assumption::replaceable(fact, Setting::Up, ""));
        return (IDENTITY.map(|axis| axis.map(f64::from)), Orientation::Unknown);
    };
    let Some(directions) = anatomical(&field.text) else {
        let fact = format!(
            "`{}` does not name a side for each axis: they were taken to point to the patient's left, posterior and superior",
            clip(&field.text)
        );
        assumptions.push(Assumption::replaceable(fact, Setting::Up, ""));
        return (IDENTITY.map(|axis| axis.map(f64::from)), Orientation::Unknown);
    };
    let fact = format!(
        "the file has no TransformMatrix: its axes were taken to run from {}, as ITK means `AnatomicalOrientation`",
        clip(&field.text)
    );
    assumptions.push(Assumption::replaceable(fact, Setting::Up, ""));
    (directions, Orientation::Patient)
}

/// The directions of axes that begin at the sides that these letters name, such as `RAI`, which is the format's world.
fn anatomical(letters: &str) -> Option<[[f64; 3]; 3]> {
    let axis = |letter: char| {
        Some(match letter.to_ascii_uppercase() {
            'R' => (0, 1.0),
            'L' => (0, -1.0),
            'A' => (1, 1.0),
            'P' => (1, -1.0),
            'I' => (2, 1.0),
            'S' => (2, -1.0),
            _ => return None,
        })
    };
    let axes: Vec<(usize, f64)> = letters.chars().map(axis).collect::<Option<_>>()?;
    let mut directions = [[0.0; 3]; 3];
    for (direction, &(component, sign)) in directions.iter_mut().zip(&axes) {
        direction[component] = sign;
    }
    // Each of the three once.
    let each = (0..3).all(|component| axes.iter().any(|axis| axis.0 == component));
    (axes.len() == 3 && each).then_some(directions)
}

/// Distances in millimetres between voxel centres.
fn spacing(
    fields: &Fields,
    report: Report,
    rank: usize,
    scale: f64,
    options: &OpenOptions,
    assumptions: &mut Assumptions,
) -> Result<[f64; 3], Error> {
    // `ElementSize` is the size of a voxel itself, and stands in where no distance is given.
    let Some(field) = fields.get("ElementSpacing").or_else(|| fields.get("ElementSize")) else {
        tolerance::note_unspaced(options, assumptions);
        return Ok([scale; 3]);
    };
    let mut stated = field.numbers(report, rank);
    if stated.is_err()
        && let Some(Ok(sizes)) = fields.get("ElementSize").map(|field| field.numbers(report, rank))
    {
        assumptions.push(format!("`{}` are no spacings: `ElementSize` stood in for them", clip(&field.text)));
        stated = Ok(sizes);
    }
    let numbers: Vec<f64> = tolerance::replaceable(stated, vec![1.0; rank], options)?;
    Ok(tolerance::steps([0, 1, 2].map(|axis| numbers[axis] * scale), scale, options, assumptions))
}

/// Millimetres per unit of the file, where it names one; otherwise 1.
fn unit_scale(fields: &Fields, assumptions: &mut Assumptions) -> f64 {
    let Some(field) = fields.get("DistanceUnits").filter(|field| field.text != "?") else {
        assumptions.push("the file names no unit of length: its own was kept".to_owned());
        return 1.0;
    };
    let unit = clip(&field.text);
    match millimetres(&field.text) {
        Some(1.0) => 1.0,
        Some(scale) => {
            assumptions.push(format!("lengths in {unit} were turned into mm"));
            scale
        }
        None => {
            assumptions.push(format!("`{unit}` is no known unit of length: it was kept"));
            1.0
        }
    }
}

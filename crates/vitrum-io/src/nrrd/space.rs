//! Placement of a NRRD grid in the world: `space`, its directions and origin, spacings and units.

use super::header::Header;
use crate::error::{Error, Place, Report, clip};
use crate::fields::Field;
use crate::orientation::Orientation;
use crate::placement::{Placement, millimetres, unoriented};
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};
use crate::volume::{IDENTITY, check_spacing};

/// `rank` is the number of axes in the file: 3, or 4 with time.
pub(super) fn placement(
    header: &Header,
    rank: usize,
    report: Report,
    assumptions: &mut Assumptions,
) -> Result<Placement, Error> {
    refuse_components(header, report)?;
    let Space { signs, orientation, note } = space(header, report)?;
    let scale = unit_scale(header, assumptions);
    let to_world = |vector: [f64; 3]| -> [f64; 3] { std::array::from_fn(|axis| vector[axis] * signs[axis] * scale) };
    let origin = header.get("spaceorigin").map(|field| vectors::<1>(report, field)).transpose()?;
    let origin = origin.map(|[origin]| to_world(origin));
    if let Some(field) = header.get("spacedirections") {
        let columns = directions(report, field, rank)?.map(to_world);
        let placement = Placement::from_columns(columns, origin, orientation)
            .map_err(|problem| report.invalid(field.place(), problem, "correct the directions or the origin"))?;
        assumptions.extend(note);
        assumptions.extend(placement.shear_note());
        return Ok(placement);
    }
    let spacing: [f64; 3] = match header.get("spacings") {
        Some(field) => {
            let spacing: Vec<f64> = field.numbers(report, rank)?;
            let spacing = [0, 1, 2].map(|axis| spacing[axis] * scale);
            check_spacing(report, spacing.map(|spacing| spacing as f32)).map_err(|error| error.at(field.place()))?;
            spacing
        }
        None => {
            assumptions.push("the file says no spacings: 1 was taken along each axis".to_owned());
            [1.0; 3]
        }
    };
    let component =
        |axis: usize, component: usize| f64::from(IDENTITY[axis][component]) * signs[component] * spacing[axis];
    let columns = [0, 1, 2].map(|axis| [0, 1, 2].map(|along| component(axis, along)));
    if header.get("space").is_some() {
        assumptions.push(
            "the file names a space but no `space directions`: its axes were taken to run along the space's".to_owned(),
        );
    }
    assumptions.extend(note);
    Placement::from_columns(columns, origin, orientation).map_err(|problem| {
        let place = header.get("spaceorigin").map_or(Place::File, Field::place);
        report.invalid(place, problem, "correct the origin")
    })
}

/// The space in which a file's directions and origin are given.
struct Space {
    /// Turn it into RAS+: x to the right, y to anterior, z to superior.
    signs: [f64; 3],
    orientation: Orientation,
    /// The assumption about a world that is no patient's.
    note: Option<Assumption>,
}

fn space(header: &Header, report: Report) -> Result<Space, Error> {
    if let Some(field) = header.get("spacedimension") {
        let dimension: u32 = field.numbers(report, 1)?[0];
        if dimension != 3 {
            return Err(report.unsupported(
                field.place(),
                format!("a space of {dimension} dimensions, not 3"),
                "write the volume in a space of 3 dimensions",
            ));
        }
    }
    let Some(field) = header.get("space") else {
        return Ok(Space { signs: [1.0; 3], orientation: Orientation::Unknown, note: Some(unoriented()) });
    };
    let patient = |signs| Ok(Space { signs, orientation: Orientation::Patient, note: None });
    let world = |signs, fact: &str| {
        let note = Some(Assumption::replaceable(fact, Setting::Up, ""));
        Ok(Space { signs, orientation: Orientation::World, note })
    };
    match field.text.to_ascii_lowercase().as_str() {
        "right-anterior-superior" | "ras" => patient([1.0, 1.0, 1.0]),
        "left-anterior-superior" | "las" => patient([-1.0, 1.0, 1.0]),
        "left-posterior-superior" | "lps" => patient([-1.0, -1.0, 1.0]),
        "scanner-xyz" | "3d-right-handed" => {
            world([1.0; 3], "the file's space is no patient's: its x, y, z were taken for the world's")
        }
        // Most often it is, because rows of pictures run downwards: what they begin with faces the front then.
        "3d-left-handed" => {
            world([1.0, -1.0, 1.0], "the file's space is left-handed: its y was turned round to make the world's")
        }
        name if name.ends_with("-time") || matches!(name, "rast" | "last" | "lpst") => Err(report.unsupported(
            field.place(),
            format!("`{}` is a space with time", clip(name)),
            "pick out one point in time first",
        )),
        other => Err(report.invalid(
            field.place(),
            format!("`{}` is not a space", clip(other)),
            "use one of right-anterior-superior, left-anterior-superior, left-posterior-superior, \
             scanner-xyz, 3D-right-handed, 3D-left-handed",
        )),
    }
}

/// An axis of colours or vector components is none of a scalar volume's.
fn refuse_components(header: &Header, report: Report) -> Result<(), Error> {
    let spatial = |kind: &str| matches!(kind, "domain" | "space" | "???" | "none");
    for name in ["kinds", "spacedirections"] {
        let Some(field) = header.get(name) else { continue };
        let lower = field.text.to_ascii_lowercase();
        // A fourth axis is time.
        let other = lower.split_whitespace().take(3).find(|word| match name {
            "kinds" => !spatial(word),
            _ => *word == "none",
        });
        if let Some(word) = other {
            return Err(report.unsupported(
                field.place(),
                format!("`{}` is an axis without extent in space", clip(word)),
                "pick out one component first, for example by `unu slice -a AXIS -p INDEX`",
            ));
        }
    }
    Ok(())
}

/// Millimetres per unit of the file, where it names one and the same for all axes; otherwise 1.
fn unit_scale(header: &Header, assumptions: &mut Assumptions) -> f64 {
    let Some(field) = header.get("spaceunits").or_else(|| header.get("units")) else {
        assumptions.push("the file names no unit of length: its own was kept".to_owned());
        return 1.0;
    };
    // A fourth would be of time.
    let names: Vec<_> = field.text.split('"').skip(1).step_by(2).take(3).map(str::trim).collect();
    let scales: Option<Vec<_>> = names.iter().map(|name| millimetres(name)).collect();
    match scales.as_deref() {
        Some(&[x, y, z]) if x == y && y == z => {
            if x != 1.0 {
                assumptions.push(format!("lengths in {} were turned into mm", names[0]));
            }
            x
        }
        _ => {
            let text = clip(&field.text);
            assumptions.push(format!("`{text}` is no known unit of length: it was kept"));
            1.0
        }
    }
}

/// The world step along x, y and z; a fourth axis, of time, has `none`.
fn directions(report: Report, field: &Field, rank: usize) -> Result<[[f64; 3]; 3], Error> {
    match field.text.trim_end().strip_suffix("none") {
        Some(text) if rank == 4 => vectors(report, &Field { text: text.to_owned(), ..field.clone() }),
        _ => vectors(report, field),
    }
}

/// `(1,0,0) (0, 1, 0)`: exactly `COUNT` vectors of 3, spaces allowed anywhere.
fn vectors<const COUNT: usize>(report: Report, field: &Field) -> Result<[[f64; 3]; COUNT], Error> {
    let parse = || {
        let mut vectors = [[0.0; 3]; COUNT];
        let mut rest = field.text.trim();
        for vector in &mut vectors {
            let (inside, after) = rest.strip_prefix('(')?.split_once(')')?;
            let mut components = inside.split(',');
            for component in vector {
                *component = components.next()?.trim().parse().ok()?;
            }
            if components.next().is_some() {
                return None;
            }
            rest = after.trim_start();
        }
        rest.is_empty().then_some(vectors)
    };
    parse().ok_or_else(|| {
        report.invalid(
            field.place(),
            format!("`{}` is not {COUNT} vector(s) of 3 numbers", clip(&field.text)),
            "write each vector as (x,y,z)",
        )
    })
}

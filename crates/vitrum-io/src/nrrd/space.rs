//! Placement of a NRRD grid in the world: `space`, its directions and origin, spacings and units.

use super::header::Header;
use crate::error::{Error, Place, Report, clip};
use crate::fields::Field;
use crate::options::OpenOptions;
use crate::orientation::Orientation;
use crate::placement::{Placement, millimetres, unoriented};
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};
use crate::tolerance;
use crate::volume::IDENTITY;

/// `rank` is the number of axes in the file: 3, or 4 with time.
pub(super) fn placement(
    header: &Header,
    rank: usize,
    report: Report,
    options: &OpenOptions,
    assumptions: &mut Assumptions,
) -> Result<Placement, Error> {
    refuse_components(header, report)?;
    let Space { signs, orientation, note } = space(header, report)?;
    let scale = unit_scale(header, assumptions);
    let to_world = |vector: [f64; 3]| -> [f64; 3] { std::array::from_fn(|axis| vector[axis] * signs[axis] * scale) };
    let origin = header.get("spaceorigin").map(|field| vectors(report, field, 1)).transpose()?;
    let origin = origin.and_then(|origins| origins.first().map(|origin| to_world(*origin)));
    if let Some(field) = header.get("spacedirections") {
        let columns = directions(report, field, rank)?.map(to_world);
        let placement = Placement::mended(columns, origin, orientation, options, assumptions)
            .map_err(|problem| report.invalid(field.place(), problem, "correct the directions or the origin"))?;
        if options.up.is_none() {
            assumptions.extend(note);
        }
        assumptions.extend(placement.shear_note());
        assumptions.note_origin("spacing", "`space directions`");
        assumptions.note_origin("orientation", "`space` and `space directions`");
        return Ok(placement);
    }
    let spacing: [f64; 3] = match header.get("spacings") {
        Some(field) => {
            let spacing: Vec<f64> = tolerance::replaceable(field.numbers(report, rank), vec![1.0; rank], options)?;
            assumptions.note_origin("spacing", "`spacings`");
            tolerance::steps([0, 1, 2].map(|axis| spacing[axis] * scale), scale, options, assumptions)
        }
        None => {
            tolerance::note_unspaced(options, assumptions);
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
    Placement::mended(columns, origin, orientation, options, assumptions).map_err(|problem| {
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
        // A fourth dimension is time, along which nothing in space lies.
        if !(3..=4).contains(&dimension) {
            return Err(report.unsupported(
                field.place(),
                format!("a space of {dimension} dimensions, not 3, or 4 with time"),
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
    // A space with time is the space, and time.
    let lower = field.text.to_ascii_lowercase();
    let space = match lower.as_str() {
        "rast" => "ras",
        "last" => "las",
        "lpst" => "lps",
        name => name.strip_suffix("-time").unwrap_or(name),
    };
    match space {
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
        other => {
            let name = clip(other);
            let fact = format!("`{name}` is no known space: its x, y, z were taken for the world's");
            Ok(Space {
                signs: [1.0; 3],
                orientation: Orientation::Unknown,
                note: Some(Assumption::replaceable(fact, Setting::Up, "")),
            })
        }
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
    // A fourth would be of time. An axis that names none takes the others'.
    let names: Vec<_> = field.text.split('"').skip(1).step_by(2).take(3).map(str::trim).collect();
    let unnamed = |name: &str| matches!(name.to_ascii_lowercase().as_str(), "" | "?" | "???" | "none");
    let named: Vec<&str> = names.iter().copied().filter(|name| !unnamed(name)).collect();
    let scales: Option<Vec<_>> = named.iter().map(|name| millimetres(name)).collect();
    match scales.as_deref() {
        Some([first, rest @ ..]) if rest.iter().all(|other| other == first) => {
            if *first != 1.0 {
                assumptions.push(format!("lengths in {} were turned into mm", clip(named[0])));
            }
            if named.len() < names.len() {
                assumptions
                    .push(format!("an axis names no unit of length: {} was taken, as of the others", clip(named[0])));
            }
            *first
        }
        _ => {
            let text = clip(&field.text);
            assumptions.push(format!("`{text}` is no known unit of length: it was kept"));
            1.0
        }
    }
}

/// The world step along x, y and z; a fourth axis, of time, has `none`, or a vector along the fourth dimension alone.
fn directions(report: Report, field: &Field, rank: usize) -> Result<[[f64; 3]; 3], Error> {
    let text = field.text.trim_end();
    let vectors = match text.strip_suffix("none") {
        Some(text) if rank == 4 => vectors(report, &Field { text: text.to_owned(), ..field.clone() }, 3)?,
        _ => vectors(report, field, rank)?,
    };
    Ok([0, 1, 2].map(|axis| vectors[axis]))
}

/// `(1,0,0) (0, 1, 0)`: exactly `count` vectors of 3, spaces allowed anywhere. A fourth component, of time, is left out.
fn vectors(report: Report, field: &Field, count: usize) -> Result<Vec<[f64; 3]>, Error> {
    let parse = || {
        let mut vectors = Vec::new();
        let mut rest = field.text.trim();
        while vectors.len() < count {
            let (inside, after) = rest.strip_prefix('(')?.split_once(')')?;
            let mut components = inside.split(',');
            let mut vector = [0.0; 3];
            for component in &mut vector {
                *component = components.next()?.trim().parse().ok()?;
            }
            if let Some(time) = components.next() {
                time.trim().parse::<f64>().ok()?;
            }
            if components.next().is_some() {
                return None;
            }
            vectors.push(vector);
            rest = after.trim_start();
        }
        rest.is_empty().then_some(vectors)
    };
    parse().ok_or_else(|| {
        report.invalid(
            field.place(),
            format!("`{}` is not {count} vector(s) of 3 numbers", clip(&field.text)),
            "write each vector as (x,y,z)",
        )
    })
}

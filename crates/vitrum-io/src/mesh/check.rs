//! The invariants of meshes, whatever file they come from.

use crate::error::{Error, Place, Report};

/// Far below the end of float32, so that no sum or square of positions overflows.
const LARGEST: f32 = 1e18;

pub(super) fn check(name: &str, positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Result<(), Error> {
    let report = Report::new(name);
    if triangles.is_empty() {
        let problem = match positions.len() {
            0 => "there are no triangles".to_owned(),
            count => format!("there are {count} vertices and no triangles"),
        };
        return Err(report.invalid(Place::File, problem, "give at least one triangle; points and lines are no mesh"));
    }
    check_count(report, positions.len())?;
    check_positions(report, positions)?;
    check_triangles(report, positions.len(), triangles)
}

/// Fails where 32-bit indices cannot tell so many vertices apart.
pub(super) fn check_count(report: Report, vertices: usize) -> Result<(), Error> {
    if vertices as u64 > u64::from(u32::MAX) {
        let problem = format!("{vertices} vertices, and {} is the most", u32::MAX);
        return Err(report.unsupported(Place::File, problem, "split the mesh, or decimate it"));
    }
    Ok(())
}

fn check_positions(report: Report, positions: &[[f32; 3]]) -> Result<(), Error> {
    let is_fit = |position: &[f32; 3]| position.iter().all(|coordinate| coordinate.abs() <= LARGEST);
    let Some(first) = positions.iter().position(|position| !is_fit(position)) else {
        return Ok(());
    };
    let [x, y, z] = positions[first];
    let place = Place::Vertex(first as u32);
    if [x, y, z].iter().all(|coordinate| coordinate.is_finite()) {
        let problem = format!("({x:e}, {y:e}, {z:e}) is beyond ±{LARGEST:e}");
        return Err(report.invalid(place, problem, "correct the coordinates or their unit"));
    }
    let count = positions.iter().flatten().filter(|coordinate| !coordinate.is_finite()).count();
    Err(report.invalid(
        place,
        format!("({x}, {y}, {z}) is the first of the positions that are not finite; {count} coordinates are not"),
        "correct the coordinates, or take the vertices out",
    ))
}

fn check_triangles(report: Report, vertices: usize, triangles: &[[u32; 3]]) -> Result<(), Error> {
    let is_fit = |triangle: &[u32; 3]| triangle.iter().all(|&vertex| (vertex as usize) < vertices);
    match triangles.iter().position(|triangle| !is_fit(triangle)) {
        None => Ok(()),
        Some(first) => {
            let [a, b, c] = triangles[first];
            Err(report.invalid(
                // The place is for people: a number beyond 32 bits may wrap.
                Place::Triangle(first as u32),
                format!("the triangle ({a}, {b}, {c}) names a vertex beyond the last of {vertices}, counted from 0"),
                "correct the index, or get the whole file",
            ))
        }
    }
}

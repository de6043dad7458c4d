//! MTL files: descriptions of materials.

use std::path::Path;

use super::statements::{Statement, Statements};
use crate::error::{Error, Report};
use crate::input::file_name;
use crate::mesh::Material;
use crate::mesh::words::{name, number, show};
use crate::source::Assumptions;

/// The materials in the order of the file.
pub(super) fn read(bytes: &[u8], report: Report, assumptions: &mut Assumptions) -> Result<Vec<Material>, Error> {
    let mut materials: Vec<Material> = Vec::new();
    let mut textures = false;
    let mut statements = Statements::new(bytes);
    while let Some(statement) = statements.next() {
        if statement.keyword == b"newmtl" {
            let name = name(report, statement.place(), statement.rest)?;
            materials.push(Material { name, ..Material::default() });
            continue;
        }
        let Some(material) = materials.last_mut() else {
            let problem = format!("`{}` stands before the first `newmtl`", show(statement.keyword));
            return Err(report.invalid(statement.place(), problem, "check that this is an MTL file"));
        };
        let mut unit = || scalar(report, &statement, assumptions, |value| (0.0..=1.0).contains(&value));
        match statement.keyword {
            b"Kd" => material.base_color = color(report, &statement, assumptions)?,
            b"Tf" => material.attenuation_color = color(report, &statement, assumptions)?,
            b"d" => material.opacity = unit()?,
            // The reverse of `d`, which wins.
            b"Tr" if material.opacity.is_none() => material.opacity = unit()?.map(|value| 1.0 - value),
            b"Pr" => material.roughness = unit()?,
            b"Ni" => {
                let is_index = |value| (0.1..=10.0).contains(&value);
                material.index_of_refraction = scalar(report, &statement, assumptions, is_index)?;
            }
            keyword => textures |= keyword.starts_with(b"map_"),
        }
    }
    if textures {
        assumptions.push(format!("the textures of {} were left out", short_name(report)));
    }
    Ok(materials)
}

/// A number, perhaps behind an option; `None`, and a note, where it is out of range.
fn scalar(
    report: Report,
    statement: &Statement,
    assumptions: &mut Assumptions,
    is_fit: impl Fn(f32) -> bool,
) -> Result<Option<f32>, Error> {
    let mut words = statement.words().filter(|word| *word != b"-halo");
    let (Some(word), None) = (words.next(), words.next()) else {
        let problem = format!("`{}` is not followed by one number", show(statement.keyword));
        return Err(report.invalid(statement.place(), problem, "correct the line"));
    };
    let value = number(report, statement.place(), word)?;
    if !is_fit(value) {
        note(report, statement, assumptions, "is out of range");
    }
    Ok(is_fit(value).then_some(value))
}

/// Linear RGB; one number is a grey.
fn color(report: Report, statement: &Statement, assumptions: &mut Assumptions) -> Result<Option<[f32; 3]>, Error> {
    if statement.words().next().is_some_and(|word| matches!(word, b"spectral" | b"xyz")) {
        note(report, statement, assumptions, "is no RGB");
        return Ok(None);
    }
    let ([red, green, blue, ..], count) = statement.numbers(report, 1, 3)?;
    let color = match count {
        3 => [red, green, blue],
        1 => [red; 3],
        _ => {
            let problem = format!("`{}` has 2 numbers, not 1 or 3", show(statement.keyword));
            return Err(report.invalid(statement.place(), problem, "correct the line"));
        }
    };
    let is_fit = color.iter().all(|channel| (0.0..=1.0).contains(channel));
    if !is_fit {
        note(report, statement, assumptions, "is out of range");
    }
    Ok(is_fit.then_some(color))
}

/// Name of the file without its folder, which is the mesh's folder or one below.
fn short_name(report: Report) -> String {
    file_name(Path::new(report.file))
}

/// Tells that a statement was left out; a hostile file may have many.
fn note(report: Report, statement: &Statement, assumptions: &mut Assumptions, why: &str) {
    const MOST: usize = 64;
    if assumptions.len() < MOST {
        let (keyword, value) = (show(statement.keyword), show(statement.rest));
        let place = format!("{}, line {}", short_name(report), statement.line);
        assumptions.push(format!("{place}: `{keyword} {value}` {why}, and was left out"));
    }
}

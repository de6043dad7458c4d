//! MTL files: descriptions of materials.

use std::path::Path;

use super::statements::{Statement, Statements};
use crate::error::Report;
use crate::input::file_name;
use crate::mesh::Material;
use crate::mesh::words::{any_number, show};
use crate::source::Assumptions;
use crate::tolerance::name;

/// The materials in the order of the file. What cannot be read of them is left out and told: no material decides a triangle.
pub(super) fn read(bytes: &[u8], report: Report, assumptions: &mut Assumptions) -> Vec<Material> {
    let mut materials: Vec<Material> = Vec::new();
    let mut textures = false;
    let mut statements = Statements::new(bytes);
    while let Some(statement) = statements.next() {
        if statement.keyword == b"newmtl" {
            materials.push(Material { name: name(statement.rest), ..Material::default() });
            continue;
        }
        let Some(material) = materials.last_mut() else {
            note(report, &statement, assumptions, "stands before the first `newmtl`");
            continue;
        };
        let mut unit = || scalar(report, &statement, assumptions, |value| (0.0..=1.0).contains(&value));
        match statement.keyword {
            b"Kd" => material.base_color = color(report, &statement, assumptions),
            b"Tf" => material.attenuation_color = color(report, &statement, assumptions),
            b"d" => material.opacity = unit(),
            // The reverse of `d`, which wins.
            b"Tr" if material.opacity.is_none() => material.opacity = unit().map(|value| 1.0 - value),
            b"Pr" => material.roughness = unit(),
            b"Ni" => {
                let is_index = |value| (0.1..=10.0).contains(&value);
                material.index_of_refraction = scalar(report, &statement, assumptions, is_index);
            }
            keyword => textures |= keyword.starts_with(b"map_"),
        }
    }
    if textures {
        assumptions.push(format!("the textures of {} were left out", short_name(report)));
    }
    materials
}

/// A number, perhaps behind an option; `None`, and a note, where it is none or out of range.
fn scalar(
    report: Report,
    statement: &Statement,
    assumptions: &mut Assumptions,
    is_fit: impl Fn(f32) -> bool,
) -> Option<f32> {
    let mut words = statement.words().filter(|word| *word != b"-halo");
    let value = match (words.next(), words.next()) {
        (Some(word), None) => any_number(word),
        _ => None,
    };
    let fit = value.filter(|&value| is_fit(value));
    if fit.is_none() {
        note(report, statement, assumptions, if value.is_some() { "is out of range" } else { "is not one number" });
    }
    fit
}

/// Linear RGB; one number is a grey.
fn color(report: Report, statement: &Statement, assumptions: &mut Assumptions) -> Option<[f32; 3]> {
    if statement.words().next().is_some_and(|word| matches!(word, b"spectral" | b"xyz")) {
        note(report, statement, assumptions, "is no RGB");
        return None;
    }
    let numbers: Option<Vec<f32>> = statement.words().take(4).map(any_number).collect();
    let color = match numbers.as_deref() {
        Some(&[red, green, blue]) => [red, green, blue],
        Some(&[gray]) => [gray; 3],
        _ => {
            note(report, statement, assumptions, "is not 1 or 3 numbers");
            return None;
        }
    };
    let is_fit = color.iter().all(|channel| (0.0..=1.0).contains(channel));
    if !is_fit {
        note(report, statement, assumptions, "is out of range");
    }
    is_fit.then_some(color)
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

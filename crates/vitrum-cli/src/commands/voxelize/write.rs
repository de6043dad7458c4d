//! The files that a voxelization leaves.

use super::Arguments;
use crate::failure::{Failure, Status};
use crate::output;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use vitrum::io::{Lattice, Samples, check_nrrd_writable, write_nrrd};
use vitrum::method::voxelize::{Attributes, Mask, Voxelization};

/// The attributes by name, with the contents of their files.
const FIELDS: [(&str, &str); 4] = [
    ("count", "how many triangles meet the voxel"),
    ("normal", "sum of the triangles' unit normals, a vector"),
    ("color", "mean of the triangles' linear colours"),
    ("material", "the largest number of a material, counted from 1; 0 for none"),
];

pub fn long_help() -> String {
    let fields: String = FIELDS.iter().map(|(name, meaning)| format!("\n{name}: {meaning}")).collect();
    format!("Also write what triangles bring to the voxels, 0 where there is none; repeatable. The names:{fields}")
}

/// `--field NAME=FILE.nrrd`.
#[derive(Debug, Clone)]
pub struct FieldRequest {
    name: &'static str,
    file: PathBuf,
}

impl FromStr for FieldRequest {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (name, file) = text.split_once('=').ok_or("expected NAME=FILE.nrrd, such as normal=normal.nrrd")?;
        let known = FIELDS.iter().find(|(known, _)| *known == name).ok_or_else(|| {
            let names = FIELDS.map(|(name, _)| name).join(", ");
            format!("there is no field `{name}`; the fields are: {names}")
        })?;
        if file.is_empty() {
            return Err(format!("`{name}` has no file"));
        }
        Ok(Self { name: known.0, file: file.into() })
    }
}

/// Whether every output could be written now, and each to a file of its own.
pub fn check_outputs(arguments: &Arguments) -> Result<(), Failure> {
    let voxels = || std::iter::once(&arguments.output).chain(arguments.field.iter().map(|field| &field.file));
    let mut seen: Vec<&Path> = Vec::new();
    for file in voxels().chain(&arguments.stats) {
        if seen.contains(&file.as_path()) {
            let message = format!("{}: two outputs go to this file", file.display());
            return Err(Failure::new(Status::WrongUse, message, "give each output a file of its own"));
        }
        seen.push(file);
    }
    for file in voxels() {
        output::check(file, check_nrrd_writable)?;
    }
    arguments.stats.as_deref().map_or(Ok(()), output::check_writable)
}

/// Writes the voxels, the fields and the statistics.
pub fn write_outputs(arguments: &Arguments, voxels: &Voxelization) -> Result<(), Failure> {
    let grid = voxels.grid;
    let origin = grid.origin.map(|low| low + 0.5 * grid.voxel_size);
    let lattice = Lattice::of_cubes(grid.dimensions, grid.voxel_size, origin);
    let write = |file: &Path, samples: Samples<'_>, content: &str| {
        let fields = [("content", content.to_owned()), ("software", format!("vitrum {}", env!("CARGO_PKG_VERSION")))];
        write_nrrd(file, &lattice, samples, &fields).map_err(|error| Failure::output(&error))
    };
    if let (Some(mask), Some(attributes)) = (&voxels.surface, &voxels.attributes) {
        for (name, content) in FIELDS {
            for field in arguments.field.iter().filter(|field| field.name == name) {
                write_field(name, mask, attributes, &|samples| write(&field.file, samples, content))?;
            }
        }
    }
    match (&voxels.solid, &voxels.surface) {
        (Some(solid), _) => write(&arguments.output, Samples::U8(&solid.coverage), "how much of a voxel is inside")?,
        (None, Some(mask)) => {
            write(&arguments.output, Samples::U8(&mask.dense(255, 0)), "whether triangles meet the voxel")?;
        }
        (None, None) => {}
    }
    match &arguments.stats {
        Some(file) => {
            output::write_text(file, &output::json(&serde_json::to_value(&voxels.statistics).unwrap_or_default()))
        }
        None => Ok(()),
    }
}

fn write_field(
    name: &str,
    mask: &Mask,
    attributes: &Attributes,
    write: &dyn Fn(Samples<'_>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let Attributes { counts, normals, colors, materials } = attributes;
    match name {
        "count" => {
            let counts: Vec<f32> = counts.iter().map(|&count| count as f32).collect();
            write(Samples::F32(&mask.spread(&counts, 0.0)))
        }
        "normal" => write(Samples::Vectors(&mask.spread(normals, [0.0; 3]))),
        "color" => {
            let mean = |(sum, &count): (&[f32; 3], &u32)| sum.map(|channel| channel / count as f32);
            let colors: Vec<[f32; 3]> = colors.iter().zip(counts).map(mean).collect();
            write(Samples::Colors(&mask.spread(&colors, [0.0; 3])))
        }
        _ => {
            let numbers: Vec<f32> = materials.iter().map(|number| number.map_or(0.0, |n| (n + 1) as f32)).collect();
            write(Samples::F32(&mask.spread(&numbers, 0.0)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::FieldRequest;

    #[test]
    fn fields_have_a_name_and_a_file() {
        assert_eq!("normal=a=b.nrrd".parse::<FieldRequest>().unwrap().file.to_str(), Some("a=b.nrrd"));
        for wrong in ["", "normal", "normal=", "depth=a.nrrd"] {
            assert!(wrong.parse::<FieldRequest>().is_err(), "{wrong}");
        }
    }
}

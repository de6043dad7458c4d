//! `vitrum scene`: the scene that a render with the same flags would show, as a scene file.

use crate::failure::{Failure, Status};
use crate::input::SceneArguments;
use crate::output;
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use vitrum::composition::{Composed, is_scene_file};
use vitrum::io::{STANDARD_INPUT, transfer};
use vitrum::preset;
use vitrum::scene::Scene;

/// Write the scene file of what would be rendered: the keys that differ from their defaults, with comments
///
/// A volume file gives a scene to start from: its preset's thresholds are written out, ready to be changed.
#[derive(Debug, Args)]
pub struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,

    /// The scene file; standard output if absent
    #[arg(short, long, value_name = "FILE.toml")]
    output: Option<PathBuf>,

    /// Write every key with its value
    #[arg(long)]
    all: bool,

    /// Write the transfer function as a colour map of ParaView with opacities, in place of the scene if there is no --output
    #[arg(long, value_name = "FILE.json")]
    write_transfer: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    arguments.output.as_deref().map_or(Ok(()), check_output)?;
    arguments.write_transfer.as_deref().map_or(Ok(()), output::check_writable)?;
    let composed = arguments.scene.compose()?;
    output::tell(&arguments.scene.input, &composed.notes, false);
    vitrum::check(&composed.scene, &composed.assets)?;
    if let Some(file) = &arguments.write_transfer {
        write_transfer(file, &arguments.scene.input, &composed)?;
        if arguments.output.is_none() {
            return Ok(ExitCode::SUCCESS);
        }
    }
    let mut scene = composed.scene;
    let folder = arguments.output.as_deref().and_then(Path::parent).unwrap_or(Path::new(""));
    if !same_folder(&composed.base, folder) {
        make_absolute(&mut scene, &composed.base);
    }
    let text = scene.to_annotated_toml(arguments.all)?;
    match &arguments.output {
        Some(file) => output::write_text(file, &text)?,
        None => output::print(&text)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// Whether the scene file could be written now, and would be read as one.
fn check_output(file: &Path) -> Result<(), Failure> {
    if !is_scene_file(file) {
        let message = format!("{}: scene files are TOML, and others are not read as scenes", file.display());
        return Err(Failure::new(Status::WrongUse, message, "name it .toml"));
    }
    output::check_writable(file)
}

/// Writes the transfer function of a volume's scene for ParaView, and says what ParaView has not.
fn write_transfer(file: &Path, input: &str, composed: &Composed) -> Result<(), Failure> {
    let Some(volume) = composed.assets.subject.volume() else {
        let message = format!("{input}: a mesh has no transfer function");
        return Err(Failure::new(Status::WrongUse, message, "leave out --write-transfer"));
    };
    let (function, left_out) = preset::transfer_file(&composed.scene, volume);
    output::tell(input, &left_out, false);
    output::write_text(file, &transfer::paraview_json(&function))
}

/// A scene that moves to another folder must name its files by absolute paths.
fn make_absolute(scene: &mut Scene, base: &Path) {
    let sources = std::iter::once(&mut scene.volume).chain(&mut scene.ior_volume);
    let mesh = scene.mesh.iter_mut().filter_map(|mesh| mesh.file.as_mut());
    let textures = scene.light.iter_mut().filter_map(|light| light.texture.as_mut());
    let density = scene.medium.iter_mut().filter_map(|medium| medium.density.as_mut());
    let files = sources
        .chain(density)
        .filter_map(|source| source.file.as_mut())
        .chain(mesh)
        .chain(&mut scene.environment.file)
        .chain(textures);
    let absolute = |file: &mut PathBuf| {
        if let Ok(absolute) = std::path::absolute(base.join(&*file)) {
            *file = absolute;
        }
    };
    files.filter(|file| file.as_path() != Path::new(STANDARD_INPUT)).for_each(absolute);
    scene.volume.mask.iter_mut().for_each(|mask| absolute(&mut mask.file));
}

fn same_folder(one: &Path, other: &Path) -> bool {
    let real = |folder: &Path| fs::canonicalize(if folder == Path::new("") { Path::new(".") } else { folder }).ok();
    real(one) == real(other)
}

//! The files that a render leaves.

use super::Arguments;
use crate::failure::{Failure, Status};
use crate::figure::Figure;
use crate::output;
use std::path::Path;
use vitrum::io::{
    Picture, Staged, check_holds_lengths, check_holds_vectors, check_writable, stage_picture_with, stage_text,
};
use vitrum::scene::Scene;
use vitrum::{Frame, method};

/// Whether every output could be written now, and each to a file of its own.
pub fn check_outputs(arguments: &Arguments) -> Result<(), Failure> {
    let pictures = std::iter::once(&arguments.output).chain(arguments.aov.iter().map(|aov| &aov.file));
    let mut seen: Vec<&Path> = Vec::new();
    for file in pictures.clone().chain(&arguments.stats).chain(&arguments.annotations) {
        if seen.contains(&file.as_path()) {
            let message = format!("{}: two outputs go to this file", file.display());
            return Err(Failure::new(Status::WrongUse, message, "give each output a file of its own"));
        }
        seen.push(file);
    }
    arguments.bits.check(pictures.clone().map(|file| file.as_path()))?;
    for file in pictures {
        output::check(file, check_writable)?;
    }
    for aov in arguments.aov.iter().filter(|aov| aov.is_vector) {
        check_holds_vectors(&aov.file, aov.name).map_err(|error| Failure::output(&error))?;
    }
    for aov in arguments.aov.iter().filter(|aov| aov.is_measure) {
        check_holds_lengths(&aov.file, aov.name).map_err(|error| Failure::output(&error))?;
    }
    arguments.annotations.as_deref().map_or(Ok(()), output::check_writable)?;
    arguments.stats.as_deref().map_or(Ok(()), output::check_writable)
}

/// Whether there are annotations, if they are to be written apart.
pub fn check_annotations(arguments: &Arguments, figure: &Figure) -> Result<(), Failure> {
    match &arguments.annotations {
        Some(file) if !figure.is_annotated() => figure.stage_svg(file).map(drop),
        _ => Ok(()),
    }
}

/// Whether a frame of the scene has every output that is asked for.
pub fn check_names(arguments: &Arguments, scene: &Scene) -> Result<(), Failure> {
    let names: Vec<&str> = method::of(scene.method).outputs().iter().map(|output| output.name).collect();
    let Some(missing) = arguments.aov.iter().map(|aov| aov.name).find(|name| !names.contains(name)) else {
        return Ok(());
    };
    let message = format!("the method `{}` has no output `{missing}`", scene.method.as_str());
    Err(Failure::new(Status::WrongUse, message, format!("it has {}", names.join(", "))))
}

/// Writes the picture, the named outputs and the statistics: all of them, or none.
pub fn write_outputs(arguments: &Arguments, scene: &Scene, mut frame: Frame, figure: &Figure) -> Result<(), Failure> {
    let metadata = frame.metadata(scene)?;
    let options = arguments.bits.options();
    let stage = |file: &Path, picture: &Picture| {
        stage_picture_with(file, picture, &metadata, &options).map_err(|error| Failure::output(&error))
    };
    let mut staged = Vec::new();
    if let Some(file) = &arguments.annotations {
        staged.push(figure.stage_svg(file)?);
    }
    for aov in &arguments.aov {
        let missing = || {
            let message = format!("the frame has no output `{}`", aov.name);
            Failure::new(Status::WrongUse, message, "leave it out")
        };
        staged.push(frame.lend_aov(aov.name, |picture| stage(&aov.file, picture)).ok_or_else(missing)??);
    }
    if let Some(file) = &arguments.stats {
        let text = output::json(&serde_json::to_value(&frame.statistics).unwrap_or_default());
        staged.push(stage_text(file, &text).map_err(|error| Failure::output(&error))?);
    }
    // Formats without layers write the first one, the color. Large pictures are in memory once.
    staged.push(stage(&arguments.output, &figure.picture(frame, &arguments.output)?)?);
    staged.into_iter().try_for_each(Staged::put).map_err(|error| Failure::output(&error))
}

//! `vitrum presets`: the looks that fit any volume or mesh, and media.

use super::presets_sheet::{self, SheetArguments};
use crate::failure::Failure;
use crate::output;
use clap::Args;
use serde_json::json;
use std::process::ExitCode;
use vitrum::preset;

/// List the presets: looks of volumes, materials of meshes, media around them (--medium), and maps of colours (--colormap); of an input, show them all
///
/// With an input, a contact sheet: a small picture of the input in each preset, with the presets' names.
#[derive(Debug, Args)]
pub struct Arguments {
    #[command(flatten)]
    pub sheet: SheetArguments,

    /// Print JSON
    #[arg(long, conflicts_with = "input")]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    if let Some(input) = &arguments.sheet.input {
        return presets_sheet::run(input, &arguments.sheet);
    }
    print_names(
        &[preset::names(), preset::mesh_names(), preset::medium_names(), preset::colormap_names()].concat(),
        arguments.json,
    )
}

/// Prints names and descriptions, as a table or as JSON.
pub fn print_names(names: &[(&str, &str)], as_json: bool) -> Result<ExitCode, Failure> {
    if as_json {
        let entries = names.iter().map(|(name, description)| json!({ "name": name, "description": description }));
        output::print_json(&entries.collect())?;
    } else {
        output::print_table(names.iter().copied())?;
    }
    Ok(ExitCode::SUCCESS)
}

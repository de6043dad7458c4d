//! The command line as a whole; each command's own arguments stand beside it.

use crate::commands::{
    completions, convert, devices, diff, info, keys, man, presets, render, scene, scenes, schema, turntable, view,
    voxelize,
};
use crate::{examples, topics};
use clap::{Parser, Subcommand};

/// Renders volumes with refraction, coloured transmission, soft shadows and caustics
#[derive(Debug, Parser)]
#[command(name = "vitrum", version, propagate_version = true, arg_required_else_help = true)]
#[command(long_about = topics::about(), after_help = format!("{}\n\n{}", examples::PROGRAM, topics::names().trim_end()))]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    #[command(after_help = examples::RENDER)]
    Render(Box<render::Arguments>),
    #[command(after_help = examples::TURNTABLE)]
    Turntable(Box<turntable::Arguments>),
    #[command(after_help = examples::VIEW)]
    View(view::Arguments),
    #[command(after_help = examples::VOXELIZE)]
    Voxelize(voxelize::Arguments),
    #[command(after_help = examples::INFO)]
    Info(info::Arguments),
    #[command(after_help = examples::CONVERT)]
    Convert(convert::Arguments),
    #[command(after_help = examples::DIFF)]
    Diff(diff::Arguments),
    #[command(after_help = examples::SCENE)]
    Scene(scene::Arguments),
    #[command(after_help = examples::DEVICES)]
    Devices(devices::Arguments),
    #[command(after_help = examples::PRESETS)]
    Presets(Box<presets::Arguments>),
    #[command(after_help = examples::SCENES)]
    Scenes(scenes::Arguments),
    #[command(after_help = examples::KEYS)]
    Keys(keys::Arguments),
    #[command(after_help = examples::SCHEMA)]
    Schema(schema::Arguments),
    #[command(after_help = examples::COMPLETIONS)]
    Completions(completions::Arguments),
    #[command(after_help = examples::MAN)]
    Man(man::Arguments),
}

#[cfg(test)]
mod tests {
    use super::Arguments;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }
}

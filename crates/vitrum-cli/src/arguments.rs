//! The command line as a whole; each command's own arguments stand beside it.

use crate::commands::{
    completions, convert, devices, diff, info, man, presets, render, scene, scenes, schema, turntable, voxelize,
};
use clap::{Parser, Subcommand};

/// Renders volumes with refraction, coloured transmission, soft shadows and caustics.
///
/// Exit codes: 0 done, 1 a check said no, 2 wrong use, 3 an input could not be read or is invalid, 4 the device failed
/// or is missing, 124 out of time, 130 interrupted.
#[derive(Debug, Parser)]
#[command(name = "vitrum", version, propagate_version = true, arg_required_else_help = true)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    Render(Box<render::Arguments>),
    Turntable(Box<turntable::Arguments>),
    Voxelize(voxelize::Arguments),
    Info(info::Arguments),
    Convert(convert::Arguments),
    Diff(diff::Arguments),
    Scene(scene::Arguments),
    Devices(devices::Arguments),
    Presets(Box<presets::Arguments>),
    Scenes(scenes::Arguments),
    Schema(schema::Arguments),
    Completions(completions::Arguments),
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

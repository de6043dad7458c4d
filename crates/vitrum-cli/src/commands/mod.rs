//! The commands, a file each: the arguments, and the work.

pub mod completions;
pub mod convert;
pub mod devices;
pub mod diff;
pub mod info;
pub mod keys;
pub mod man;
pub mod presets;
mod presets_sheet;
pub mod render;
pub mod scene;
pub mod scenes;
pub mod schema;
pub mod turntable;
pub mod view;
pub mod voxelize;

use crate::arguments::Command;
use crate::failure::Failure;
use crate::interrupt;
use std::process::ExitCode;

/// Runs a command; its exit code, or why it failed.
pub fn run(command: Command) -> Result<ExitCode, Failure> {
    interrupt::handle_signals();
    match command {
        Command::Render(arguments) => render::run(&arguments),
        Command::Turntable(arguments) => turntable::run(&arguments),
        Command::View(arguments) => view::run(&arguments),
        Command::Voxelize(arguments) => voxelize::run(&arguments),
        Command::Info(arguments) => info::run(&arguments),
        Command::Convert(arguments) => convert::run(&arguments),
        Command::Diff(arguments) => diff::run(&arguments),
        Command::Scene(arguments) => scene::run(&arguments),
        Command::Devices(arguments) => devices::run(&arguments),
        Command::Presets(arguments) => presets::run(&arguments),
        Command::Scenes(arguments) => scenes::run(&arguments),
        Command::Keys(arguments) => keys::run(&arguments),
        Command::Schema(arguments) => schema::run(&arguments),
        Command::Completions(arguments) => completions::run(&arguments),
        Command::Man(arguments) => man::run(&arguments),
    }
}

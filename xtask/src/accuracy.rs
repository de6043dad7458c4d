//! `cargo xtask accuracy`: measures how far the sweep is from physics.

use crate::diff;
use crate::failure::Failure;

/// Measure how far the sweep is from physics; write the tables and plots of `docs/accuracy.md`. Needs no graphics adapter.
#[derive(clap::Args)]
#[command(disable_help_flag = true)]
pub struct Arguments {
    /// Passed on to the program; --help lists them.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<String>,
}

/// Runs the `accuracy` program.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    diff::run_program("accuracy", &arguments.arguments)
}

//! `cargo xtask bench`: measures frame times.

use crate::diff;
use crate::failure::Failure;
use crate::vulkan;

/// Measure frame times on both backends, interleaved; print a table for `docs/benchmarks.md`.
#[derive(clap::Args)]
#[command(disable_help_flag = true)]
pub struct Arguments {
    /// Passed on to the program; --help lists them.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<String>,
}

/// Runs the `bench` program.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    vulkan::require_driver()?;
    diff::run_program("bench", &arguments.arguments)
}

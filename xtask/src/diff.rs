//! `cargo xtask diff`: compares the backends.

use crate::command::{self, cargo};
use crate::failure::Failure;
use crate::vulkan;

/// Compare the backends with each other and with the golden pictures; print a table.
#[derive(clap::Args, Default)]
#[command(disable_help_flag = true)]
pub struct Arguments {
    /// Passed on to the program; --help lists them.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<String>,
}

/// Runs the `conformance` program.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    vulkan::require_driver()?;
    run_program("conformance", &arguments.arguments)
}

/// Runs a program of the conformance package, built for release.
pub fn run_program(name: &str, arguments: &[String]) -> Result<(), Failure> {
    let mut command = cargo(["run", "--release", "--package", "vitrum-conformance", "--bin", name, "--"]);
    command::run(command.args(arguments))
}

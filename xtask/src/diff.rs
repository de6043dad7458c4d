//! `cargo xtask diff`: compares the backends.

use std::env;
use std::path::PathBuf;

use crate::command::{self, cargo};
use crate::failure::Failure;
use crate::shaders::COMPILER;
use crate::vulkan;

/// Compare the backends with each other and with the golden pictures, on larger frames than the tests do; print a table.
#[derive(clap::Args)]
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
///
/// It is built with the workspace, as the tests are: by itself, cargo would choose other features of the dependencies and compile
/// them anew.
pub fn run_program(name: &str, arguments: &[String]) -> Result<(), Failure> {
    command::run(&mut cargo(["build", "--release", "--workspace", "--exclude", COMPILER, "--bin", name]))?;
    command::run(command::program(&program_path(name).to_string_lossy()).args(arguments))
}

/// Path of a program that cargo builds for release.
pub fn program_path(name: &str) -> PathBuf {
    command::target().join("release").join(format!("{name}{}", env::consts::EXE_SUFFIX))
}

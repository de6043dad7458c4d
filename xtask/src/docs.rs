//! `cargo xtask docs`: what is made from the code in `docs/`.

use crate::diff;
use crate::failure::Failure;

/// Write what is made from the code in `docs/`: the scene's schema, and tables of keys, of names and of bounds.
#[derive(clap::Args)]
#[command(disable_help_flag = true)]
pub struct Arguments {
    /// Passed on to the program; --help lists them.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<String>,
}

/// Runs the `docs` program.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    diff::run_program("docs", &arguments.arguments)
}

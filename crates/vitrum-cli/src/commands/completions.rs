//! `vitrum completions`: the command line, for shells.

use crate::complete;
use crate::failure::Failure;
use crate::output;
use clap::Args;
use clap_complete::Shell;
use std::process::ExitCode;

/// Print the completion script of a shell
#[derive(Debug, Args)]
pub struct Arguments {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    output::print(&complete::script(&arguments.shell.to_string()))?;
    Ok(ExitCode::SUCCESS)
}

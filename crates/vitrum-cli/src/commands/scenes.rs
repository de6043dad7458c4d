//! `vitrum scenes`: what can be rendered with nothing at hand.

use super::presets::print_names;
use crate::failure::Failure;
use clap::Args;
use std::process::ExitCode;
use vitrum::builtin;

/// List the built-in scenes; render one as builtin:NAME
#[derive(Debug, Args)]
pub struct Arguments {
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    print_names(builtin::names(), arguments.json)
}

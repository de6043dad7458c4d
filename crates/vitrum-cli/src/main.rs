//! The `vitrum` program: `docs/program.md` describes every command and flag.
//!
//! Standard output carries results, standard error messages and a progress bar. Exit codes: 0 done, 1 a check said no,
//! 2 wrong use, 3 an input could not be read or is invalid, 4 the device failed or is missing, 124 out of
//! time, 130 interrupted.

mod arguments;
mod commands;
mod device;
mod failure;
mod input;
mod interrupt;
mod output;
mod progress;
mod size;
mod volume;

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = arguments::Arguments::parse();
    commands::run(arguments.command).unwrap_or_else(|failure| failure.report())
}

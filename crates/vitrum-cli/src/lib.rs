//! The `vitrum` program as a function: `docs/program.md` describes every command and flag.
//!
//! Standard output carries results, standard error messages and a progress bar. `topics` has the exit codes.

mod advice;
mod arguments;
mod bash;
mod commands;
mod complete;
mod device;
mod examples;
mod failure;
mod faster;
mod figure;
mod input;
mod interrupt;
mod output;
mod progress;
mod size;
mod topics;
mod transfer;
mod volume;

use clap::Parser;
use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the program with these words, the program's name first, and returns its exit code. Signals, exit codes and the two outputs are the process's, which
/// should do nothing else.
#[must_use]
pub fn run(words: &[OsString]) -> u8 {
    let code = outcome(words);
    // Exit codes tell nobody their number.
    (0..=u8::MAX).find(|&number| ExitCode::from(number) == code).unwrap_or(u8::MAX)
}

fn outcome(words: &[OsString]) -> ExitCode {
    if complete::answer_shell(words) {
        return ExitCode::SUCCESS;
    }
    interrupt::ignore_file_size_signal();
    let texts: Vec<String> = words.iter().map(|word| word.to_string_lossy().into_owned()).collect();
    if let Some(answered) = topics::answer(&texts) {
        return answered.unwrap_or_else(|failure| failure.report());
    }
    let arguments = match arguments::Arguments::try_parse_from(words) {
        Ok(arguments) => arguments,
        // Help and versions are results: that they cannot be printed is a failure.
        Err(told) if !told.use_stderr() => {
            let printed = output::print_styled(&told.render());
            return printed.map_or_else(|failure| failure.report(), |()| ExitCode::SUCCESS);
        }
        Err(wrong) => {
            // As clap does, which would end the process itself.
            let _ = wrong.print();
            return u8::try_from(wrong.exit_code()).map_or(ExitCode::FAILURE, ExitCode::from);
        }
    };
    commands::run(arguments.command).unwrap_or_else(|failure| failure.report())
}

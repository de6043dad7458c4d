//! The `vitrum` program: `docs/program.md` describes every command and flag.
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
use std::process::ExitCode;

fn main() -> ExitCode {
    // First of all: no other thread is there yet.
    silence_device_select();
    complete::answer_shell();
    interrupt::ignore_file_size_signal();
    let words: Vec<String> = std::env::args_os().map(|word| word.to_string_lossy().into_owned()).collect();
    if let Some(answered) = topics::answer(&words) {
        return answered.unwrap_or_else(|failure| failure.report());
    }
    let arguments = match arguments::Arguments::try_parse() {
        Ok(arguments) => arguments,
        // Help and versions are results: that they cannot be printed is a failure.
        Err(told) if !told.use_stderr() => {
            let printed = output::print_styled(&told.render());
            return printed.map_or_else(|failure| failure.report(), |()| ExitCode::SUCCESS);
        }
        Err(wrong) => wrong.exit(),
    };
    commands::run(arguments.command).unwrap_or_else(|failure| failure.report())
}

/// Silences Mesa's Vulkan layer that orders adapters: without a desktop session it complains on standard error at every run. It stays
/// on where the user names an order.
fn silence_device_select() {
    const SESSION_OR_WISH: [&str; 4] = ["XDG_RUNTIME_DIR", "NODEVICE_SELECT", "MESA_VK_DEVICE_SELECT", "DRI_PRIME"];
    if cfg!(target_os = "linux") && SESSION_OR_WISH.iter().all(|name| std::env::var_os(name).is_none()) {
        // SAFETY: the environment must not be read or changed by another thread meanwhile. This is the first thing that `main`
        // does, and nothing before it starts a thread.
        unsafe { std::env::set_var("NODEVICE_SELECT", "1") };
    }
}

//! `vitrum view`: the live window, which is a program of its own.

use crate::complete;
use crate::failure::{Failure, Status};
use clap::Args;
use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::PathBuf;
use std::process::{self, ExitCode};

/// Name of the window's program.
const PROGRAM: &str = "vitrum-viewer";

/// Open a window in which a volume or a mesh is turned, lit and shaped
#[derive(Debug, Args)]
pub struct Arguments {
    /// A scene file (.toml), a volume file, a mesh, a folder of DICOM files, or builtin:NAME; a page to choose from without it
    #[arg(add = complete::inputs())]
    input: Option<OsString>,

    /// Flags of the window's program
    #[arg(last = true, value_name = "FLAG")]
    flags: Vec<OsString>,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let program = beside_this_program().unwrap_or_else(|| PathBuf::from(PROGRAM));
    let words = arguments.flags.iter().chain(&arguments.input);
    let status = process::Command::new(&program).args(words).status().map_err(|error| {
        let message = match error.kind() {
            ErrorKind::NotFound => format!("the program `{PROGRAM}` is neither beside `vitrum` nor on the PATH"),
            _ => format!("{}: {error}", program.display()),
        };
        let help = format!(
            "build it by `cargo build --release -p {PROGRAM}`; `vitrum render` makes pictures without a window"
        );
        Failure::new(Status::Device, message, help)
    })?;
    // Ended by a signal, it has no code: as shells have it, 128 and more.
    Ok(status.code().and_then(|code| u8::try_from(code).ok()).map_or(ExitCode::from(128), ExitCode::from))
}

/// The window's program in the folder of this one.
fn beside_this_program() -> Option<PathBuf> {
    let name = format!("{PROGRAM}{}", std::env::consts::EXE_SUFFIX);
    let path = std::env::current_exe().ok()?.parent()?.join(name);
    path.is_file().then_some(path)
}

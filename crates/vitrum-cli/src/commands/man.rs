//! `vitrum man`: the manual pages.

use crate::arguments;
use crate::failure::{Failure, Status};
use crate::output;
use clap::{Args, CommandFactory};
use std::fs;
use std::io::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use vitrum::suggest::nearest;

/// Print a manual page, as man reads it
#[derive(Debug, Args)]
pub struct Arguments {
    /// The command; the page of the program itself if absent
    pub command: Option<String>,

    /// Write the pages of all commands to a folder instead, which is made if it is missing
    #[arg(short, long, value_name = "FOLDER", conflicts_with = "command")]
    pub output: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let mut program = arguments::Arguments::command();
    // Subcommands then know their whole names, and the flags that they inherit.
    program.build();
    if let Some(folder) = &arguments.output {
        let pages = fs::create_dir_all(folder).and_then(|()| clap_mangen::generate_to(program, folder));
        pages.map_err(|error| unwritable(folder, &error))?;
        return Ok(ExitCode::SUCCESS);
    }
    let command = match &arguments.command {
        Some(name) => program.find_subcommand(name).cloned().ok_or_else(|| unknown(name, &program))?,
        None => program,
    };
    let mut page = Vec::new();
    // Writing to memory does not fail.
    clap_mangen::Man::new(command).render(&mut page).map_err(|error| unwritable(Path::new("-"), &error))?;
    output::print(&String::from_utf8_lossy(&page))?;
    Ok(ExitCode::SUCCESS)
}

fn unwritable(path: &Path, error: &Error) -> Failure {
    let message = format!("{}: the pages cannot be written: {error}", path.display());
    Failure::new(Status::WrongUse, message, "choose another folder")
}

fn unknown(name: &str, program: &clap::Command) -> Failure {
    let names = || program.get_subcommands().map(clap::Command::get_name);
    let help = match nearest(name, names()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("the commands are: {}", names().collect::<Vec<_>>().join(", ")),
    };
    Failure::new(Status::WrongUse, format!("there is no command `{name}`"), help)
}

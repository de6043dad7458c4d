//! `vitrum convert`: a volume as another file.

use crate::failure::Failure;
use crate::input;
use crate::volume::VolumeArguments;
use clap::Args;
use std::path::PathBuf;
use std::process::ExitCode;
use vitrum::io::{check_volume_writable, write_volume};

/// Write a volume as NRRD or NumPy: its physical values, and in NRRD its place in the world
#[derive(Debug, Args)]
pub struct Arguments {
    /// A volume file, a folder of DICOM files, `-` for standard input, a scene file (.toml; its volume is taken), or
    /// builtin:NAME
    input: String,

    #[command(flatten)]
    volume: VolumeArguments,

    /// The file: .nrrd or .npy
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    check_volume_writable(&arguments.output).map_err(|error| Failure::output(&error))?;
    let volume = input::open_volume(&arguments.input, &arguments.volume)?;
    write_volume(&arguments.output, &volume).map_err(|error| Failure::output(&error))?;
    Ok(ExitCode::SUCCESS)
}

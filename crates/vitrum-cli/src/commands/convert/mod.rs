//! `vitrum convert`: a volume as another file, or a part or another form of it.

mod edits;

use crate::failure::Failure;
use crate::input;
use crate::output;
use crate::volume::{Spacing, VolumeArguments};
use clap::Args;
use edits::{Crop, Labels, Threshold, Voxels};
use std::path::PathBuf;
use std::process::ExitCode;
use vitrum::io::{check_volume_writable, write_volume};

/// Write a volume as NRRD or NumPy: its physical values, and in NRRD its place in the world
///
/// Changes are made in the order of the flags below: a part is cut out, labels are picked, then the volume is resampled, blurred and
/// thresholded.
#[derive(Debug, Args)]
pub struct Arguments {
    /// A volume file, a folder of DICOM files, `-` for standard input, a scene file (.toml; its volume is taken), or
    /// builtin:NAME
    #[arg(add = crate::complete::inputs())]
    input: String,

    #[command(flatten)]
    volume: VolumeArguments,

    /// The file: .nrrd or .npy
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,

    /// Keep the voxels with these indices alone, counted from 0, ends not included; a number may be left out, as in 10:50,:,20:
    #[arg(long, value_name = "X0:X1,Y0:Y1,Z0:Z1")]
    pub crop: Option<Crop>,

    /// Keep these values, such as labels of a segmentation, and put 0 in place of all others
    #[arg(long, value_name = "LABEL,…", allow_hyphen_values = true)]
    pub labels: Option<Labels>,

    /// Resample to these distances of voxels: linear, averaged where they grow; of picked labels the nearest
    #[arg(long, value_name = "X,Y,Z", conflicts_with = "size")]
    pub resample: Option<Spacing>,

    /// Resample to so many voxels
    #[arg(long, value_name = "X,Y,Z")]
    pub size: Option<Voxels>,

    /// Blur by a Gaussian of this standard deviation, in voxels
    #[arg(long, value_name = "SIGMA")]
    pub blur: Option<f32>,

    /// Write 1 where the value is at least LOW, and at most HIGH, and 0 elsewhere
    #[arg(long, value_name = "LOW[,HIGH]", allow_hyphen_values = true)]
    pub threshold: Option<Threshold>,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    output::check(&arguments.output, check_volume_writable)?;
    let volume = input::open_volume(&arguments.input, &arguments.volume)?;
    let volume = edits::apply(arguments, volume)?;
    write_volume(&arguments.output, &volume).map_err(|error| Failure::output(&error))?;
    Ok(ExitCode::SUCCESS)
}

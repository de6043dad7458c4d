//! `vitrum render`: a picture of a scene, a volume file or a built-in scene.

mod aov;
mod run;
mod write;

pub use run::run;

use crate::device::{DeviceArguments, MemoryArguments};
use crate::input::SceneArguments;
use crate::interrupt::Timeout;
use crate::output::Bits;
use aov::AovRequest;
use clap::Args;
use std::path::PathBuf;

/// Render a picture
#[derive(Debug, Args)]
pub struct Arguments {
    #[command(flatten)]
    pub scene: SceneArguments,

    /// The picture: .png, .exr (all named outputs and metadata), .hdr, .jpg or .tif
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,

    #[command(flatten)]
    pub device: DeviceArguments,

    #[command(flatten)]
    pub memory: MemoryArguments,

    /// Also write a named output, such as depth=depth.exr; repeatable
    #[arg(long, value_name = "NAME=FILE", add = crate::complete::outputs(), long_help = aov::long_help())]
    pub aov: Vec<AovRequest>,

    /// Also write the scene's annotations apart, as an SVG of the picture's size
    #[arg(long, value_name = "FILE.svg")]
    pub annotations: Option<PathBuf>,

    /// Write statistics as JSON: method, backend, adapter, sizes, camera, times, memory; null where not known
    #[arg(long, value_name = "FILE.json")]
    pub stats: Option<PathBuf>,

    /// Render the same picture so many times, to time it; the last one is written
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub frames: u32,

    /// Bits per channel of PNG pictures
    #[arg(long, value_enum, value_name = "8|16", hide_possible_values = true, default_value_t = Bits::Eight)]
    pub bits: Bits,

    /// End with exit code 124 and without output when it takes longer
    #[arg(long, value_name = "SECONDS")]
    pub timeout: Option<Timeout>,

    /// No messages and no progress bar
    #[arg(short, long)]
    pub quiet: bool,

    /// Print the statistics as JSON to standard output
    #[arg(long)]
    pub json: bool,
}

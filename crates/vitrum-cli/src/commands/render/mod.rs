//! `vitrum render`: a picture of a scene, a volume file or a built-in scene.

mod aov;
mod run;
mod write;

pub use run::run;

use crate::input::SceneArguments;
use aov::AovRequest;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use vitrum::backend::Choice;

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

    /// Also write a named output, such as depth=depth.exr; repeatable
    #[arg(long, value_name = "NAME=FILE", long_help = aov::long_help())]
    pub aov: Vec<AovRequest>,

    /// Write statistics as JSON: method, backend, adapter, sizes, times, memory; null where not known
    #[arg(long, value_name = "FILE.json")]
    pub stats: Option<PathBuf>,

    /// Render the same picture so many times, to time it; the last one is written
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub frames: u32,

    /// No messages and no progress bar
    #[arg(short, long)]
    pub quiet: bool,

    /// Print the statistics as JSON to standard output
    #[arg(long)]
    pub json: bool,
}

/// Where the work is done.
#[derive(Debug, Args)]
pub struct DeviceArguments {
    /// Where to render; auto takes a hardware GPU if there is one, else the CPU
    #[arg(long, value_enum, default_value_t = BackendName::Auto)]
    pub backend: BackendName,

    /// Take the GPU whose name has this text in it (`vitrum devices` lists them), software or not
    #[arg(long, value_name = "SUBSTRING")]
    pub adapter: Option<String>,

    /// CPU threads; all cores if absent
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum BackendName {
    Auto,
    Cpu,
    Gpu,
}

impl From<BackendName> for Choice {
    fn from(name: BackendName) -> Self {
        match name {
            BackendName::Auto => Self::Auto,
            BackendName::Cpu => Self::Cpu,
            BackendName::Gpu => Self::Gpu,
        }
    }
}

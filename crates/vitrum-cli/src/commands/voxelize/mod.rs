//! `vitrum voxelize`: a mesh as voxels.

mod write;

use crate::device::DeviceArguments;
use crate::failure::{Failure, Status};
use crate::interrupt::Timeout;
use crate::progress::Bar;
use crate::{input, interrupt, output};
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use std::process::ExitCode;
use vitrum::backend::Backend;
use vitrum::io::Mesh;
use vitrum::method::Tools;
use vitrum::method::voxelize::{FillRule, Settings, Statistics, Voxelization, voxelize};
use write::FieldRequest;

/// Turn a mesh into voxels: those that its triangles meet, or how much of each is inside
#[derive(Debug, Args)]
pub struct Arguments {
    /// A mesh (.obj, .ply, .stl, .gltf or .glb), a scene file that shows one, or builtin:NAME
    #[arg(add = crate::complete::inputs())]
    pub mesh: String,

    /// Voxels along the mesh's longest edge
    #[arg(short, long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=8192))]
    pub resolution: u32,

    /// The voxels, .nrrd: 255 where a triangle meets the voxel, else 0; with --solid how much of it is inside, 0 to 255
    #[arg(short, long, value_name = "FILE.nrrd")]
    pub output: PathBuf,

    /// Fill the inside, where a surface that crosses itself by this rule: nonzero if absent
    #[arg(long, value_enum, value_name = "RULE", num_args = 0..=1, require_equals = true, default_missing_value = "nonzero")]
    pub solid: Option<Rule>,

    /// Empty voxels around the mesh
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(0..=1024))]
    pub padding: u32,

    /// By how much a voxel reaches over its neighbours for the surface, 0 to 1 of its edge
    #[arg(long, value_name = "X", default_value_t = 0.0)]
    pub overlap: f32,

    /// Also write what triangles bring to the voxels: count, normal, color or material; repeatable
    #[arg(long, value_name = "NAME=FILE.nrrd", long_help = write::long_help())]
    pub field: Vec<FieldRequest>,

    #[command(flatten)]
    pub device: DeviceArguments,

    /// Write statistics as JSON: sizes, counts, volume, time
    #[arg(long, value_name = "FILE.json")]
    pub stats: Option<PathBuf>,

    /// Do the same so many times, to time it
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub runs: u32,

    /// No messages and no progress bar
    #[arg(short, long)]
    pub quiet: bool,

    /// Print the statistics as JSON to standard output
    #[arg(long)]
    pub json: bool,

    /// End with exit code 124 and without output when it takes longer
    #[arg(long, value_name = "SECONDS")]
    pub timeout: Option<Timeout>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Rule {
    /// Inside is where the surface winds about at all
    Nonzero,
    /// Inside is where it takes an odd number of crossings to get out
    EvenOdd,
}

impl From<Rule> for FillRule {
    fn from(rule: Rule) -> Self {
        match rule {
            Rule::Nonzero => Self::Nonzero,
            Rule::EvenOdd => Self::EvenOdd,
        }
    }
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    interrupt::listen(arguments.timeout);
    arguments.device.limit_threads()?;
    // Refusals that need no work come before any work.
    write::check_outputs(arguments)?;
    if !(0.0..=1.0).contains(&arguments.overlap) {
        let message = format!("--overlap is {}, expected 0 to 1", arguments.overlap);
        return Err(Failure::new(Status::WrongUse, message, "0 is exact, 0.5 doubles a voxel's edge"));
    }
    let mesh = input::open_mesh(&arguments.mesh, None)?;
    let device = &arguments.device;
    let mut backend = device.open()?;
    if !arguments.quiet {
        eprintln!("voxelizing on {} ({})", backend.name(), backend.adapter());
    }
    let settings = Settings {
        resolution: arguments.resolution,
        padding: arguments.padding,
        overlap: arguments.overlap,
        surface: arguments.solid.is_none(),
        attributes: !arguments.field.is_empty(),
        solid: arguments.solid.map(FillRule::from),
    };
    let voxels = run_all(arguments.runs, &mesh, &settings, backend.as_mut(), arguments.quiet)?;
    write::write_outputs(arguments, &voxels)?;
    let statistics = &voxels.statistics;
    if !arguments.quiet {
        eprintln!("{}: {}", arguments.output.display(), summary(statistics));
        if arguments.solid.is_some() {
            output::warn_of_holes(&mesh.name, mesh.topology().unpaired_edges, statistics.open_rows);
        }
    }
    if arguments.json {
        output::print_json(&serde_json::to_value(statistics).unwrap_or_default())?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The last of several runs, with the times of all.
fn run_all(
    runs: u32,
    mesh: &Mesh,
    settings: &Settings,
    backend: &mut dyn Backend,
    quiet: bool,
) -> Result<Voxelization, Failure> {
    let bar = Bar::of_work(quiet);
    let mut times = Vec::new();
    loop {
        let mut progress = |progress| {
            bar.set(&progress);
            !interrupt::requested()
        };
        let mut tools = Tools { backend: &mut *backend, progress: &mut progress };
        let mut voxels = voxelize(mesh, settings, &mut tools).map_err(failure)?;
        times.append(&mut voxels.statistics.voxelize_ms);
        if times.len() >= runs as usize {
            voxels.statistics.voxelize_ms = times;
            return Ok(voxels);
        }
    }
}

/// The failure of a voxelization, with advice of its own: the resolution alone determines the memory, and no picture can be made
/// smaller.
fn failure(error: vitrum::Error) -> Failure {
    use vitrum::backend::BackendError::{OutOfMemory, TooLarge};
    let too_many = matches!(error, vitrum::Error::Backend(OutOfMemory { .. } | TooLarge { .. }));
    let failure = Failure::from(error);
    if too_many {
        failure.with_help("take fewer voxels (--resolution), or another --backend where that allows more")
    } else {
        failure
    }
}

fn summary(statistics: &Statistics) -> String {
    let [x, y, z] = statistics.dimensions;
    let surface = statistics.surface_voxels.map_or(String::new(), |count| format!(", {count} on the surface"));
    let volume = statistics.volume.map_or(String::new(), |volume| format!(", volume {volume:.6}"));
    let Statistics { triangles, items, .. } = statistics;
    let mut times = statistics.voxelize_ms.clone();
    times.sort_by(f64::total_cmp);
    let time = match times.get(times.len() / 2) {
        Some(median) if times.len() > 1 => format!("{} runs, median {median:.1} ms", times.len()),
        Some(time) => format!("{time:.1} ms"),
        None => String::new(),
    };
    format!("{x} x {y} x {z} voxels{surface}{volume}; {triangles} triangles, {items} items, {time}")
}

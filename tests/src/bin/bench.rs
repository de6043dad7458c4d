//! `bench` (`cargo xtask bench`): frame times on both backends, interleaved.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, ValueEnum};
use vitrum::backend::{Backend, CpuBackend, GpuOptions};
use vitrum::preset;
use vitrum_conformance::accuracy::{rewrite, write};
use vitrum_conformance::bench::{self, Contender};
use vitrum_conformance::case::Case;
use vitrum_conformance::paper::beams::{self, SUBJECTS, Sizes, Subject as OfBeams};
use vitrum_conformance::paper::sweep::{self, DATA_SETS, DataSet};
use vitrum_conformance::roofline::{Ceilings, markdown};
use vitrum_conformance::{Failure, adapter, failure, golden, machine, root, scaling};
use vitrum_kernels::kernel::InstructionSet;

/// Measure frame times on both backends, interleaved; print a table for docs/benchmarks.md.
///
/// A frame's time leaves out tables and uploads, which are `upload ms`. `peak MiB` is the most memory that the process had
/// while the backend rendered, `relative` the frame time over that of the first backend. Each picture is checked before it
/// is timed.
///
/// Exit codes: 0 done; 1 a picture was wrong; 2 wrong use, or no graphics adapter; 3 an input could not be read; 4 the
/// device failed.
#[derive(Parser)]
#[command(name = "bench")]
struct Arguments {
    /// Volume files; the built-in scenes if there are none
    #[arg(value_name = "VOLUME")]
    volumes: Vec<PathBuf>,

    /// The look of the volumes (`vitrum presets` lists them)
    #[arg(long, value_name = "NAME", default_value = "amber")]
    preset: String,

    /// Only built-in scenes whose name has this text in it; repeatable
    #[arg(long, value_name = "SUBSTRING")]
    scene: Vec<String>,

    /// Pixels along each side of the picture; 512 and 1024 if absent
    #[arg(long, value_name = "PIXELS", value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..=16384))]
    sizes: Vec<u32>,

    /// Frames that are timed, after one that is not
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..))]
    frames: u16,

    /// CPU threads; all if absent. Several times are compared, such as 1,2,4
    #[arg(long, value_name = "N", value_delimiter = ',', value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Vec<u16>,

    /// Instead of a graphics adapter, the CPU's builds for each instruction set that the machine has
    #[arg(long, conflicts_with_all = ["adapter", "roofline", "scaling"])]
    builds: bool,

    /// Instead, for each kernel on the CPU: bytes and operations, and its time over what the machine can do at best
    #[arg(long)]
    roofline: bool,

    /// Instead, how frame times on the CPU grow with pixels, planes, voxels, light and threads: writes the table of
    /// docs/benchmarks.md and docs/benchmarks/scaling.svg
    #[arg(long, conflicts_with = "roofline")]
    scaling: bool,

    /// Instead, the tables of a method's paper, on the graphics adapter, or on the CPU where --threads is given; of `sweep` if absent. --scene picks
    /// rows. The sweep's has stand-ins of the same dimensions, and `--sizes 512,768,1024` are its columns; `--sizes 256,512,1024` are those of beams
    #[arg(long, value_name = "METHOD", num_args = 0..=1, default_missing_value = "sweep", value_enum,
          conflicts_with_all = ["roofline", "scaling", "builds", "volumes"])]
    paper: Option<Paper>,

    /// Rays of light along each edge of the caustics buffer, with `--paper beams`; 64 to 1024 if absent
    #[arg(long, value_name = "RAYS", value_delimiter = ',', requires = "paper",
          value_parser = clap::value_parser!(u32).range(4..=1024))]
    rays: Vec<u32>,

    /// With `--paper beams`, pictures of 256 x 256 pixels and buffers up to 256 x 256 rays where none are given: some minutes on two cores
    #[arg(long, requires = "paper")]
    quick: bool,

    /// Take the adapter whose name has this text in it (`vitrum devices` lists them)
    #[arg(long, value_name = "SUBSTRING")]
    adapter: Option<String>,
}

/// The papers whose tables are taken anew, by their methods.
#[derive(Clone, Copy, ValueEnum)]
enum Paper {
    Sweep,
    Beams,
}

impl Arguments {
    /// Pixels along each side of the picture.
    fn sizes(&self) -> &[u32] {
        match (&self.sizes[..], self.paper) {
            ([], Some(Paper::Beams)) if self.quick => &[256],
            ([], Some(Paper::Beams)) => &[256, 512, 1024],
            ([], _) => &[512, 1024],
            (given, _) => given,
        }
    }

    /// Rays along each edge of the caustics buffer.
    fn rays(&self) -> &[u32] {
        match &self.rays[..] {
            [] if self.quick => &[64, 128, 256],
            [] => &[64, 128, 256, 512, 1024],
            given => given,
        }
    }
}

fn main() -> ExitCode {
    failure::exit(run(&Arguments::parse()))
}

fn run(arguments: &Arguments) -> Result<bool, Failure> {
    if arguments.scaling {
        return scaling(arguments);
    }
    if let Some(paper) = arguments.paper {
        return of_paper(paper, arguments);
    }
    let subjects = subjects(arguments)?;
    if arguments.roofline {
        return roofline(arguments, subjects);
    }
    let mut contenders = contenders(arguments)?;
    println!("{}", machine::description());
    for contender in &contenders {
        println!("- {}: {}", contender.backend.name(), contender.backend.adapter());
    }
    println!("- medians of {} interleaved frames after one that is not counted\n", arguments.frames);
    let mut timings = Vec::new();
    for subject in subjects {
        let mut case = subject.open(arguments)?;
        for &edge in arguments.sizes() {
            case.resize(edge);
            eprintln!("{} at {edge} x {edge}", case.name);
            timings.extend(bench::measure(&case, &mut contenders, arguments.frames.into())?);
        }
    }
    println!("{}", bench::markdown(&timings));
    Ok(timings.iter().all(bench::Timing::passed))
}

/// Prints a paper's tables, taken anew.
fn of_paper(paper: Paper, arguments: &Arguments) -> Result<bool, Failure> {
    let mut backend: Box<dyn Backend> = match arguments.threads.first() {
        Some(&threads) => Box::new(CpuBackend::new(Some(threads.into()))?),
        None => Box::new(adapter::open(&GpuOptions::new(arguments.adapter.as_deref()))?),
    };
    println!("{}\n- {}: {}\n", machine::description(), backend.name(), backend.adapter());
    match paper {
        Paper::Sweep => of_sweep(arguments, backend.as_mut())?,
        Paper::Beams => of_beams(arguments, backend.as_mut())?,
    }
    Ok(true)
}

/// Whether a row of that name is wanted.
fn wants(arguments: &Arguments, name: &str) -> bool {
    arguments.scene.is_empty() || arguments.scene.iter().any(|wanted| name.contains(wanted))
}

const NO_ROW: &str = "the paper's table has no row of such a name";

/// The table of the plane sweep's paper.
fn of_sweep(arguments: &Arguments, backend: &mut dyn Backend) -> Result<(), Failure> {
    let mut rows = Vec::new();
    for set in DATA_SETS.iter().filter(|set: &&DataSet| wants(arguments, set.name)) {
        let mut case = set.case(arguments.sizes()[0])?;
        for &edge in arguments.sizes() {
            case.resize(edge);
            eprintln!("{} at {edge} x {edge}", case.name);
            rows.push(sweep::measure(set, &case, backend, arguments.frames.into())?);
        }
    }
    if rows.is_empty() {
        return Err(Failure::Setup(NO_ROW.to_owned()));
    }
    println!("{}", sweep::markdown(&rows));
    Ok(())
}

/// The tables of the beams' paper, each as soon as it is there.
fn of_beams(arguments: &Arguments, backend: &mut dyn Backend) -> Result<(), Failure> {
    let subjects: Vec<&OfBeams> = SUBJECTS.iter().filter(|subject| wants(arguments, subject.scene)).collect();
    if subjects.is_empty() {
        return Err(Failure::Setup(NO_ROW.to_owned()));
    }
    let sizes =
        Sizes { edges: arguments.sizes().to_vec(), rays: arguments.rays().to_vec(), frames: arguments.frames.into() };
    println!("Table 1\n\n{}\n", beams::stages(&subjects, &sizes, backend)?);
    println!("Table 2\n\n{}\n", beams::sizes(&sizes, backend)?);
    println!("One to four lights\n\n{}", beams::lights(&subjects, &sizes, backend)?);
    Ok(())
}

/// Writes the section of docs/benchmarks.md.
fn scaling(arguments: &Arguments) -> Result<bool, Failure> {
    let (table, plot) = scaling::measure(machine::threads(), arguments.frames.into())?;
    let text = format!("{}\n\n{table}\n\n![{}](benchmarks/scaling.svg)", machine::description(), plot.title);
    println!("{text}");
    let svg = plot.svg().map_err(Failure::Setup)?;
    write(&root().join("docs/benchmarks/scaling.svg"), &svg)?;
    rewrite(&root().join("docs/benchmarks.md"), "scaling", &text)?;
    Ok(true)
}

/// Prints a table for each subject, at the first size.
fn roofline(arguments: &Arguments, subjects: Vec<Subject>) -> Result<bool, Failure> {
    let threads = arguments.threads.first().map_or_else(machine::threads, |&threads| threads.into());
    println!("{}", machine::description());
    let ceilings = Ceilings::measure(threads);
    println!(
        "- {threads} threads copy {:.1} GB/s and compute {:.0} Gflop/s",
        ceilings.bytes * 1e-9,
        ceilings.operations * 1e-9
    );
    for subject in subjects {
        let case = subject.open(arguments)?;
        let mut backend = CpuBackend::new(Some(threads))?;
        println!("\n{} at {} x {}\n", case.name, arguments.sizes()[0], arguments.sizes()[0]);
        println!("{}", markdown(&case, &mut backend, ceilings)?);
    }
    Ok(true)
}

/// The CPU with each number of threads, then the graphics adapter; or the CPU's builds.
fn contenders(arguments: &Arguments) -> Result<Vec<Contender>, Failure> {
    let all = [machine::threads()];
    let threads: Vec<usize> = arguments.threads.iter().map(|&threads| threads.into()).collect();
    let threads = if threads.is_empty() { all.as_slice() } else { &threads };
    if arguments.builds {
        let sets = InstructionSet::ALL.into_iter().rev().filter(|set| set.is_available());
        let of_set = |set| threads.iter().map(move |&threads| Contender::build(threads, set));
        return sets.flat_map(of_set).collect();
    }
    let gpu = adapter::open(&GpuOptions::new(arguments.adapter.as_deref()))?;
    let mut contenders = threads.iter().map(|&threads| Contender::cpu(threads)).collect::<Result<Vec<_>, _>>()?;
    contenders.push(Contender { backend: Box::new(gpu), threads: None, build: None });
    Ok(contenders)
}

/// The subject of a measurement. Volumes are read one after the other, so that memory holds one at a time.
enum Subject {
    Scene(&'static str),
    File(PathBuf),
}

impl Subject {
    fn open(&self, arguments: &Arguments) -> Result<Case, Failure> {
        let edge = arguments.sizes()[0];
        match self {
            Self::Scene(name) => Case::builtin(name, edge, None, &[]).map(Case::without_light),
            Self::File(path) => Case::file(path, &arguments.preset, edge).map(Case::without_light),
        }
    }
}

/// The volumes; or the built-in scenes, variants only where they are asked for.
fn subjects(arguments: &Arguments) -> Result<Vec<Subject>, Failure> {
    preset::check(&arguments.preset)?;
    if let Some(missing) = arguments.volumes.iter().find(|path| !path.exists()) {
        return Err(Failure::Setup(format!("{} does not exist", missing.display())));
    }
    if !arguments.volumes.is_empty() {
        return Ok(arguments.volumes.iter().cloned().map(Subject::File).collect());
    }
    let wants = |scene: &&str| arguments.scene.iter().any(|wanted| scene.contains(wanted));
    let scenes: Vec<&str> = if arguments.scene.is_empty() {
        golden::scenes()
    } else {
        vitrum::builtin::names().iter().map(|&(name, _)| name).filter(wants).collect()
    };
    if scenes.is_empty() {
        return Err(Failure::Setup("no built-in scene has such a name; `vitrum scenes` lists them".to_owned()));
    }
    Ok(scenes.into_iter().map(Subject::Scene).collect())
}

//! `conformance` (`cargo xtask diff`): both backends against each other, and against golden pictures.

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, ValueEnum};
use serde_json::json;
use vitrum::backend::{Backend, CpuBackend};
use vitrum::builtin;
use vitrum_conformance::case::Case;
use vitrum_conformance::run::Run;
use vitrum_conformance::{Failure, adapter, evidence, failure, frames, functions, golden, kernels, report, table};

/// Compare the backends with each other and with the golden pictures; print a table.
///
/// Exit codes: 0 every bound holds; 1 one does not, and the evidence lies in target/conformance; 2 wrong use, or no
/// graphics adapter; 3 an input is invalid; 4 the device failed.
#[derive(Parser)]
#[command(name = "conformance")]
struct Arguments {
    /// Only scenes whose name has this text in it; repeatable
    #[arg(long, value_name = "SUBSTRING")]
    scene: Vec<String>,

    /// Only this tier; repeatable
    #[arg(long, value_enum)]
    tier: Vec<Tier>,

    /// Compare with the adapter whose name has this text in it (`vitrum devices` lists them)
    #[arg(long, value_name = "SUBSTRING")]
    adapter: Option<String>,

    /// Also write everything that was measured as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    /// Also write a page with all numbers and pictures, which needs nothing else
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,

    /// Write the golden pictures anew instead of comparing; look at them before they are committed
    #[arg(long)]
    bless: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Tier {
    /// Building blocks by themselves, over millions of inputs
    T0,
    /// What each kernel wrote, in the midst of small frames
    T1,
    /// Every output of every built-in scene
    T2,
    /// Golden pictures, on the CPU; needs no graphics adapter
    T3,
}

/// T0's inputs, in units of 1024.
const FUNCTIONS: u32 = 1024;
/// Pixels along each side of T1's frames, and voxels along its volumes' longest edge.
const KERNELS: (u32, u32) = (48, 32);
/// The same of T2.
const FRAMES: (u32, u32) = (96, 64);

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    failure::exit(if arguments.bless { bless(&arguments) } else { compare(&arguments) })
}

impl Arguments {
    fn wants(&self, scene: &str) -> bool {
        self.scene.is_empty() || self.scene.iter().any(|wanted| scene.contains(wanted))
    }

    fn has(&self, tier: Tier) -> bool {
        self.tier.is_empty() || self.tier.contains(&tier)
    }

    fn golden_scenes(&self) -> impl Iterator<Item = &'static str> {
        golden::scenes().into_iter().filter(|scene| self.wants(scene))
    }
}

fn compare(arguments: &Arguments) -> Result<bool, Failure> {
    let mut run = Run::new(evidence::folder());
    if arguments.html.is_some() {
        run.keep_pictures();
    }
    let mut backends = "CPU against golden pictures".to_owned();
    if [Tier::T0, Tier::T1, Tier::T2].into_iter().any(|tier| arguments.has(tier)) {
        let mut cpu = CpuBackend::new(None)?;
        let mut gpu = adapter::open(arguments.adapter.as_deref())?;
        backends = format!("CPU ({}) against {}", cpu.adapter(), gpu.adapter());
        eprintln!("{backends}");
        compare_backends(arguments, &mut cpu, &mut gpu, &mut run)?;
    }
    if arguments.has(Tier::T3) {
        for scene in arguments.golden_scenes() {
            eprintln!("T3 {scene}");
            golden::compare(&golden::folder(), scene, &mut run)?;
        }
    }
    if run.rows().is_empty() {
        let message = "no scene of these tiers has such a name; `vitrum scenes` lists them";
        return Err(Failure::Setup(message.to_owned()));
    }
    println!("{backends}\n\n{}\n\n{}", table::markdown(run.rows()), run.summary());
    if let Some(path) = &arguments.json {
        let mut text = run.json();
        text["backends"] = json!(backends);
        fs::write(path, format!("{text:#}\n")).map_err(|error| Failure::Output { path: path.clone(), error })?;
    }
    if let Some(path) = &arguments.html {
        report::write(path, &backends, &run).map_err(|error| Failure::Output { path: path.clone(), error })?;
    }
    Ok(run.passed())
}

fn compare_backends(
    arguments: &Arguments,
    cpu: &mut dyn Backend,
    gpu: &mut dyn Backend,
    run: &mut Run,
) -> Result<(), Failure> {
    if arguments.has(Tier::T0) && arguments.wants("functions") {
        eprintln!("T0 functions");
        functions::compare(FUNCTIONS, cpu, gpu, run)?;
    }
    if arguments.has(Tier::T1) {
        for case in kernels::cases(KERNELS.0, KERNELS.1)?.iter().filter(|case| arguments.wants(&case.name)) {
            eprintln!("T1 {}", case.name);
            kernels::compare(case, cpu, gpu, run)?;
        }
    }
    if arguments.has(Tier::T2) {
        for &(name, _) in builtin::names().iter().filter(|(name, _)| arguments.wants(name)) {
            eprintln!("T2 {name}");
            frames::compare(&Case::builtin(name, FRAMES.0, Some(FRAMES.1), &[])?, cpu, gpu, run)?;
        }
    }
    Ok(())
}

fn bless(arguments: &Arguments) -> Result<bool, Failure> {
    for scene in arguments.golden_scenes() {
        let changed = golden::bless(&golden::folder(), scene)?;
        println!("{scene}: {}", if changed { "written" } else { "unchanged" });
    }
    Ok(true)
}

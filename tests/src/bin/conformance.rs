//! `conformance` (`cargo xtask diff`): both backends against each other, and against golden pictures.

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::{Parser, ValueEnum};
use serde_json::json;
use vitrum::backend::{Backend, CpuBackend, GpuBackend, GpuOptions};
use vitrum::builtin;
use vitrum::scene::MethodName;
use vitrum_conformance::bounds::{self, Family};
use vitrum_conformance::case::Case;
use vitrum_conformance::run::{Run, methods};
use vitrum_conformance::{Failure, adapter, evidence, failure, frames, functions, golden, kernels, report, table};

/// Compare the backends with each other and with the golden pictures; print a table.
///
/// Options that select can be combined and repeated: `--tier t1 --tier t2 --scene glass`.
///
/// Exit codes: 0 every bound holds; 1 one does not, and the evidence lies in target/conformance; 2 wrong use, or no
/// graphics adapter; 3 an input is invalid; 4 the device failed.
#[derive(Parser)]
#[command(name = "conformance")]
struct Arguments {
    /// Only this tier; repeatable
    #[arg(long, value_enum)]
    tier: Vec<Tier>,

    /// Only scenes whose name has this text in it; T0's is called `functions`; repeatable
    #[arg(long, value_name = "SUBSTRING")]
    scene: Vec<String>,

    /// Only this method; repeatable
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(methods()))]
    method: Vec<String>,

    /// Compare with the adapter whose name has this text in it (`vitrum devices` lists them); repeatable
    #[arg(long, value_name = "SUBSTRING")]
    adapter: Vec<String>,

    /// Only with shaders that reach the driver so; both if absent, where the driver can do both. Repeatable
    #[arg(long, value_enum)]
    shaders: Vec<Shaders>,

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

/// How shaders reach the driver.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Shaders {
    /// SPIR-V as it is, where the driver takes it
    PassedThrough,
    /// Translated by naga, as Metal and Direct3D 12 need them
    Translated,
}

/// T0's inputs, in units of 1024.
const FUNCTIONS: u32 = 1024;
/// Pixels along each side of T1's frames, and voxels along its volumes' longest edge.
const KERNELS: (u32, u32) = (48, 32);
/// Edge and resolution of the frames of T2.
const FRAMES: (u32, u32) = (96, 64);

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    failure::exit(if arguments.bless { bless(&arguments) } else { compare(&arguments) })
}

/// The selected cases, by tier.
struct Selection {
    functions: bool,
    kernels: Vec<Case>,
    frames: Vec<&'static str>,
    /// Frames of meshes.
    meshes: Vec<Case>,
    golden: Vec<&'static str>,
}

impl Arguments {
    fn has(&self, tier: Tier) -> bool {
        self.tier.is_empty() || self.tier.contains(&tier)
    }

    /// # Errors
    /// If a name selects nothing.
    fn selection(&self) -> Result<Selection, Failure> {
        let of_tier = |tier: Tier, names: Vec<&'static str>| if self.has(tier) { names } else { Vec::new() };
        let mut kernels = if self.has(Tier::T1) { kernels::cases(KERNELS.0, KERNELS.1)? } else { Vec::new() };
        let mut frames = of_tier(Tier::T2, builtin::names().iter().map(|&(name, _)| name).collect());
        let mut golden = of_tier(Tier::T3, golden::scenes());
        let functions = of_tier(Tier::T0, vec!["functions"]);
        let mut meshes = if self.has(Tier::T2) { kernels::meshes(FRAMES.0, FRAMES.1)? } else { Vec::new() };
        let names = kernels.iter().chain(&meshes).map(|case| case.name.as_str());
        let mut names: Vec<&str> = names.chain([&functions, &frames, &golden].into_iter().flatten().copied()).collect();
        names.sort_unstable();
        names.dedup();
        if let Some(unknown) = self.scene.iter().find(|wanted| !names.iter().any(|name| name.contains(wanted.as_str())))
        {
            let names = names.join(", ");
            return Err(Failure::Setup(format!(
                "no scene of these tiers has `{unknown}` in its name; there are {names}"
            )));
        }
        let wants = |scene: &str| self.scene.is_empty() || self.scene.iter().any(|wanted| scene.contains(wanted));
        let of_method =
            |method: MethodName| self.method.is_empty() || self.method.iter().any(|wanted| wanted == method.as_str());
        kernels.retain(|case| wants(&case.name) && of_method(case.scene.method));
        meshes.retain(|case| wants(&case.name) && of_method(case.scene.method));
        let of_scene = |name: &str| builtin::scene(name).is_some_and(|scene| of_method(scene.method));
        frames.retain(|name| wants(name) && of_scene(name));
        golden.retain(|name| wants(name) && of_scene(name));
        Ok(Selection { functions: functions.into_iter().any(wants), kernels, frames, meshes, golden })
    }

    /// The adapters, each once with its shaders passed through and once translated: the best adapter if none is named.
    fn adapters(&self) -> Result<Vec<GpuBackend>, Failure> {
        let named = self.adapter.iter().map(|name| Some(name.as_str()));
        let wanted: Vec<Option<&str>> = if self.adapter.is_empty() { vec![None] } else { named.collect() };
        let courses =
            Shaders::value_variants().iter().filter(|course| self.shaders.is_empty() || self.shaders.contains(course));
        let mut adapters: Vec<GpuBackend> = Vec::new();
        for (name, course) in wanted.iter().flat_map(|name| courses.clone().map(move |course| (name, course))) {
            let translate_shaders = *course == Shaders::Translated;
            let found = adapter::open(&GpuOptions { translate_shaders, ..GpuOptions::new(*name) })?;
            // Where nothing is passed through, both are the same.
            if adapters.iter().all(|adapter| adapter.adapter() != found.adapter()) {
                adapters.push(found);
            }
        }
        Ok(adapters)
    }
}

impl Selection {
    fn needs_adapter(&self) -> bool {
        self.functions || !self.kernels.is_empty() || !self.frames.is_empty() || !self.meshes.is_empty()
    }
}

fn compare(arguments: &Arguments) -> Result<bool, Failure> {
    let selection = arguments.selection()?;
    let mut run = Run::new(evidence::folder());
    if arguments.html.is_some() {
        run.keep_pictures();
    }
    let mut families: Vec<Family> = Vec::new();
    if selection.needs_adapter() {
        let mut cpu = CpuBackend::new(None)?;
        for mut gpu in arguments.adapters()? {
            run.against(&format!("CPU ({}) against {}", cpu.adapter(), gpu.adapter()));
            families.push(*Family::of(&gpu.adapter()));
            compare_backends(&selection, &mut cpu, &mut gpu, &mut run)?;
        }
    }
    run.against("CPU against golden pictures");
    for scene in &selection.golden {
        eprintln!("T3 {scene}");
        golden::compare(&golden::folder(), scene, &mut run)?;
    }
    for rows in run.groups() {
        println!("{}\n\n{}\n", rows[0].against, table::markdown(rows));
    }
    if !families.is_empty() {
        families.dedup_by_key(|family| family.name);
        println!("What such adapters are held to:\n\n{}\n", bounds::markdown(&families));
    }
    println!("{}", run.summary());
    let compared: Vec<&str> = run.groups().map(|rows| rows[0].against.as_str()).collect();
    if let Some(path) = &arguments.json {
        let mut text = run.json();
        text["backends"] = json!(compared);
        fs::write(path, format!("{text:#}\n")).map_err(|error| Failure::Output { path: path.clone(), error })?;
    }
    if let Some(path) = &arguments.html {
        let written = report::write(path, &compared.join("; "), &run);
        written.map_err(|error| Failure::Output { path: path.clone(), error })?;
    }
    Ok(run.passed())
}

fn compare_backends(
    selection: &Selection,
    cpu: &mut dyn Backend,
    gpu: &mut dyn Backend,
    run: &mut Run,
) -> Result<(), Failure> {
    eprintln!("{}", gpu.adapter());
    if selection.functions {
        eprintln!("T0 functions");
        functions::compare(FUNCTIONS, cpu, gpu, run)?;
    }
    for case in &selection.kernels {
        eprintln!("T1 {}", case.name);
        kernels::compare(case, cpu, gpu, run)?;
    }
    for case in &selection.meshes {
        eprintln!("T2 {}", case.name);
        frames::compare(case, cpu, gpu, run)?;
    }
    for name in &selection.frames {
        eprintln!("T2 {name}");
        frames::compare(&Case::builtin(name, FRAMES.0, Some(FRAMES.1), &[])?, cpu, gpu, run)?;
    }
    Ok(())
}

fn bless(arguments: &Arguments) -> Result<bool, Failure> {
    for scene in arguments.selection()?.golden {
        let changed = golden::bless(&golden::folder(), scene)?;
        println!("{scene}: {}", if changed { "written" } else { "unchanged" });
    }
    Ok(true)
}

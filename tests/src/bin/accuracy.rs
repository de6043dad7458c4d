//! `accuracy` (`cargo xtask accuracy`): the tables and plots of `docs/accuracy.md`.

use std::process::ExitCode;

use clap::Parser;
use clap::builder::PossibleValuesParser;
use vitrum::backend::CpuBackend;
use vitrum_conformance::accuracy::{ALL, rewrite, write};
use vitrum_conformance::{Failure, failure, root};

/// Measure how far the sweep is from physics, on the CPU; write docs/accuracy.md's tables and docs/accuracy/*.svg.
///
/// All of it takes some minutes, most of them for photons.
///
/// Exit codes: 0 done; 2 wrong use, or the page cannot be written; 4 the backend failed.
#[derive(Parser)]
#[command(name = "accuracy")]
struct Arguments {
    /// Only this section; repeatable
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(ALL.map(|(name, _)| name)))]
    only: Vec<String>,

    /// Print the tables instead of writing them, and draw nothing
    #[arg(long)]
    print: bool,
}

fn main() -> ExitCode {
    failure::exit(run(&Arguments::parse()))
}

fn run(arguments: &Arguments) -> Result<bool, Failure> {
    let mut backend = CpuBackend::new(None)?;
    let wanted = |name: &str| arguments.only.is_empty() || arguments.only.iter().any(|only| only == name);
    for (name, measure) in ALL.into_iter().filter(|(name, _)| wanted(name)) {
        eprintln!("{name}");
        let section = measure(&mut backend)?;
        println!("{name}\n\n{}\n", section.text);
        if !arguments.print {
            let plot = root().join("docs/accuracy").join(format!("{name}.svg"));
            let svg = section.plot.svg().map_err(Failure::Setup)?;
            write(&plot, &svg)?;
            let shown = format!("{}\n\n![{}](accuracy/{name}.svg)", section.text, section.plot.title);
            rewrite(&root().join("docs/accuracy.md"), name, &shown)?;
        }
    }
    Ok(true)
}

//! `accuracy` (`cargo xtask accuracy`): the tables and plots of `docs/accuracy.md`.

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use clap::builder::PossibleValuesParser;
use vitrum::backend::CpuBackend;
use vitrum_conformance::accuracy::{ALL, replace};
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
            write(plot, &svg)?;
            let page = root().join("docs/accuracy.md");
            let text = fs::read_to_string(&page).map_err(|error| Failure::Output { path: page.clone(), error })?;
            let missing = || Failure::Setup(format!("{} has no line `<!-- measured: {name} -->`", page.display()));
            let shown = format!("{}\n\n![{}](accuracy/{name}.svg)", section.text, section.plot.title);
            write(page.clone(), &replace(&text, name, &shown).ok_or_else(missing)?)?;
        }
    }
    Ok(true)
}

fn write(path: PathBuf, text: &str) -> Result<(), Failure> {
    path.parent()
        .map_or(Ok(()), fs::create_dir_all)
        .and_then(|()| fs::write(&path, text))
        .map_err(|error| Failure::Output { path, error })
}

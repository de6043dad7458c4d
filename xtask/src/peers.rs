//! `cargo xtask peers`: what Vitrum reads next to what independent programs read.

use std::process::Command;

use crate::command::{cargo, root, run as run_command, target};
use crate::environment;
use crate::failure::Failure;
use crate::steps::Completion;

/// The requirements of the virtual environment.
const REQUIREMENTS: &str = "tests/peers/requirements.txt";

/// Hold the readers against independent ones from PyPI; needs python3 with venv.
#[derive(clap::Args, Default)]
pub struct Arguments {
    /// Also write the table of the shared volumes into docs/peers.md.
    #[arg(long)]
    bless: bool,
}

/// Runs the comparison for itself; what leaves it out is an error here.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    match compare(arguments)? {
        Completion::Whole => Ok(()),
        Completion::LeftOut(reason) => Err(Failure::setup(reason)),
    }
}

/// Prepares the environment, and compares volumes and meshes that the independent programs write, and the shared ones
/// where they are there.
pub fn compare(arguments: &Arguments) -> Result<Completion, Failure> {
    let folder = target().join("peers");
    if let Some(reason) = environment::prepare(&folder, REQUIREMENTS)? {
        return Ok(Completion::LeftOut(reason));
    }
    run_command(&mut cargo(["build", "--release", "--package", "vitrum-cli"]))?;
    let vitrum = target().join("release").join(format!("vitrum{}", std::env::consts::EXE_SUFFIX));
    let shared = root().join("../shared/data");
    let mut outcome = Ok(());
    for kind in ["volumes", "meshes"] {
        let mut compare = Command::new(environment::python(&folder));
        compare.current_dir(root()).arg(format!("tests/peers/{kind}.py")).arg("--vitrum").arg(&vitrum);
        if shared.join(kind).is_dir() {
            compare.arg(shared.join(kind));
        }
        if arguments.bless && kind == "volumes" {
            compare.args(["--page", "docs/peers.md"]);
        }
        // Both, so that one run shows everything that differs.
        outcome = outcome.and(run_command(&mut compare));
    }
    outcome.map(|()| Completion::Whole)
}

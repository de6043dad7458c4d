//! `cargo xtask peers`: what Vitrum reads next to what independent programs read.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::command::{announce, cargo, not_started, program, require_success, root, run as run_command, target};
use crate::failure::Failure;
use crate::steps::Completion;

/// The requirements of the virtual environment.
const REQUIREMENTS: &str = "tests/peers/requirements.txt";

/// Phrases by which pip reports that the package index does not answer.
const UNREACHABLE: [&str; 3] = ["Retrying (", "Network is unreachable", "Temporary failure in name resolution"];

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
    if let Some(reason) = prepare(&folder)? {
        return Ok(Completion::LeftOut(reason));
    }
    run_command(&mut cargo(["build", "--release", "--package", "vitrum-cli"]))?;
    let vitrum = target().join("release").join(format!("vitrum{}", std::env::consts::EXE_SUFFIX));
    let shared = root().join("../shared/data");
    let mut outcome = Ok(());
    for kind in ["volumes", "meshes"] {
        let mut compare = Command::new(python(&folder));
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

/// Makes the virtual environment, unless it is complete already. The result is the reason if it cannot be made.
fn prepare(folder: &Path) -> Result<Option<String>, Failure> {
    let unreadable = |error| Failure::setup(format!("{REQUIREMENTS}: {error}"));
    let required = fs::read_to_string(root().join(REQUIREMENTS)).map_err(unreadable)?;
    let installed = folder.join("installed.txt");
    if fs::read_to_string(&installed).is_ok_and(|installed| installed == required) {
        return Ok(None);
    }
    let mut make = program("python3");
    make.args(["-m", "venv"]).arg(folder);
    announce(&make);
    match make.status() {
        Err(error) => return Ok(Some(format!("python3 could not be started: {error}"))),
        Ok(status) if !status.success() => {
            return Ok(Some("python3 makes no virtual environment; some systems have that in python3-venv".to_owned()));
        }
        Ok(_) => {}
    }
    let mut install = Command::new(python(folder));
    install.current_dir(root()).args(["-m", "pip", "install", "--quiet", "--retries", "1", "--timeout", "20"]);
    install.args(["--disable-pip-version-check", "--requirement", REQUIREMENTS]).stderr(Stdio::piped());
    announce(&install);
    let output = install.output().map_err(|error| not_started(&install, &error))?;
    let said = String::from_utf8_lossy(&output.stderr);
    eprint!("{said}");
    if !output.status.success() && is_unreachable(&said) {
        return Ok(Some("the package index does not answer".to_owned()));
    }
    require_success(&install, output.status)?;
    let unwritable = |error| Failure::setup(format!("{}: {error}", installed.display()));
    fs::write(&installed, required).map_err(unwritable)?;
    Ok(None)
}

/// Whether pip failed because of the network, and not because of the requirements.
fn is_unreachable(said: &str) -> bool {
    UNREACHABLE.iter().any(|words| said.contains(words))
}

/// The interpreter of a virtual environment.
fn python(folder: &Path) -> PathBuf {
    if cfg!(windows) { folder.join("Scripts/python.exe") } else { folder.join("bin/python") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_network_that_is_missing_is_told_from_a_package_that_is() {
        let missing = "ERROR: Could not find a version that satisfies the requirement nosuch==1 (from versions: none)\n\
                       ERROR: No matching distribution found for nosuch==1\n";
        assert!(!is_unreachable(missing));
        let warning = "WARNING: Retrying (Retry(total=0, connect=None)) after connection broken by \
                       'NewConnectionError(...)': /simple/numpy/\n";
        assert!(is_unreachable(&[warning, missing].concat()));
    }
}

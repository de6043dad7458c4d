//! Virtual environments of Python.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::command::{announce, not_started, program, require_success, root};
use crate::failure::Failure;

/// Phrases by which pip reports that the package index does not answer.
const UNREACHABLE: [&str; 3] = ["Retrying (", "Network is unreachable", "Temporary failure in name resolution"];

/// Makes a virtual environment with the packages that a file requires, unless it is complete already. The result is the reason if it cannot be made.
pub fn prepare(folder: &Path, requirements: &str) -> Result<Option<String>, Failure> {
    let unreadable = |error| Failure::setup(format!("{requirements}: {error}"));
    let required = fs::read_to_string(root().join(requirements)).map_err(unreadable)?;
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
    install.args(["--disable-pip-version-check", "--requirement", requirements]).stderr(Stdio::piped());
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
pub fn python(folder: &Path) -> PathBuf {
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

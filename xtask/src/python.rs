//! `cargo xtask python`: the wheel is built, installed and tested as users have it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{root, run as run_command, target};
use crate::environment;
use crate::failure::Failure;
use crate::steps::Completion;

/// The package.
const PACKAGE: &str = "crates/vitrum-python";

/// The requirements of the virtual environment: what builds the wheel, and what its tests use.
const REQUIREMENTS: &str = "crates/vitrum-python/tests/requirements.txt";

/// Build the wheel of the Python package, install it into a virtual environment and run its tests there; needs python3 with venv.
#[derive(clap::Args, Default)]
pub struct Arguments {
    /// Build and install the wheel without running its tests.
    #[arg(long)]
    no_tests: bool,

    /// Build a wheel for another machine, such as `aarch64-unknown-linux-gnu` (`rustup target add` it first), and neither install nor test it.
    #[arg(long)]
    target: Option<String>,
}

/// Builds and tests the wheel for itself; what leaves that out is an error here.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    match check(arguments)? {
        Completion::Whole => Ok(()),
        Completion::LeftOut(reason) => Err(Failure::setup(reason)),
    }
}

/// Builds the wheel, installs it, and runs its tests, its documentation's examples, and the checks of its types.
pub fn check(arguments: &Arguments) -> Result<Completion, Failure> {
    let folder = target().join("python");
    if let Some(reason) = environment::prepare(&folder, REQUIREMENTS)? {
        return Ok(Completion::LeftOut(reason));
    }
    let python = environment::python(&folder);
    if let Some(target) = &arguments.target {
        // Zig links for machines whose linker and C library are not here.
        let mut install = module(&python, &root(), "pip");
        run_command(install.args(["install", "--quiet", "--disable-pip-version-check", "ziglang"]))?;
        println!("{}", build(&python, &["--zig", "--target", target])?.display());
        return Ok(Completion::Whole);
    }
    let wheel = build(&python, &[])?;
    // As it is: its dependency is there.
    let mut install = Command::new(&python);
    install.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--force-reinstall", "--no-deps"]);
    run_command(install.arg(&wheel))?;
    if arguments.no_tests {
        println!("{}", wheel.display());
        return Ok(Completion::Whole);
    }
    let package = root().join(PACKAGE);
    let mut tests = module(&python, &folder, "pytest");
    tests.args(["-q", "-rs", "-c"]).arg(package.join("pyproject.toml")).arg(package.join("tests"));
    // Not those of the source tree: these have no native module.
    tests.args(["--doctest-modules", "--pyargs", "vitrum_render"]);
    let outcome = run_command(&mut tests);
    let mut types = module(&python, &package, "mypy");
    let outcome = outcome.and(run_command(&mut types));
    let mut stubs = module(&python, &folder, "mypy.stubtest");
    outcome.and(run_command(stubs.arg("vitrum_render._native"))).map(|()| Completion::Whole)
}

/// A module of Python, run in a folder.
fn module(python: &Path, folder: &Path, name: &str) -> Command {
    let mut command = Command::new(python);
    command.current_dir(folder).args(["-m", name]);
    command
}

/// Builds the wheel with the packages that cargo has compiled for the tests, if it is for this machine.
fn build(python: &Path, more: &[&str]) -> Result<PathBuf, Failure> {
    let wheels = target().join("wheels");
    let unusable = |error| Failure::setup(format!("{}: {error}", wheels.display()));
    if wheels.exists() {
        fs::remove_dir_all(&wheels).map_err(unusable)?;
    }
    let mut maturin = module(python, &root().join(PACKAGE), "maturin");
    maturin.args(["build", "--release", "--locked", "--out"]).arg(&wheels).args(more).env("CARGO_TARGET_DIR", target());
    run_command(&mut maturin)?;
    let mut found = fs::read_dir(&wheels).map_err(unusable)?.filter_map(|entry| Some(entry.ok()?.path()));
    let wheel = found.find(|path| path.extension().is_some_and(|extension| extension == "whl"));
    wheel.ok_or_else(|| Failure::check(format!("{}: no wheel was made", wheels.display())))
}

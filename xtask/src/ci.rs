//! `cargo xtask ci`: everything that has to hold before a change is merged.

use clap::ValueEnum;

use crate::circles;
use crate::command::{cargo, run as run_command, this_program};
use crate::failure::Failure;
use crate::features;
use crate::package;
use crate::peers;
use crate::python;
use crate::shaders::{self, COMPILER};
use crate::steps::{Completion, Steps};
use crate::test;
use crate::wasm;

/// Run every check: format, circles of files, lints, documentation, features, WebAssembly, tests, committed modules,
/// packages, readers against independent ones, the Python package.
#[derive(clap::Args)]
pub struct Arguments {
    /// Leave a step out; repeatable.
    #[arg(long, value_enum)]
    skip: Vec<Step>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Step {
    Fmt,
    Circles,
    Test,
    Shaders,
    Clippy,
    Doc,
    Features,
    Wasm,
    Package,
    Peers,
    Python,
}

impl Step {
    fn name(self) -> &'static str {
        match self {
            Self::Fmt => "fmt",
            Self::Circles => "circles",
            Self::Clippy => "clippy",
            Self::Doc => "doc",
            Self::Features => "features",
            Self::Wasm => "wasm",
            Self::Test => "test",
            Self::Shaders => "shaders",
            Self::Package => "package",
            Self::Peers => "peers",
            Self::Python => "python",
        }
    }

    fn run(self) -> Result<Completion, Failure> {
        let whole = match self {
            Self::Fmt => run_command(&mut cargo(["fmt", "--all", "--check"])),
            Self::Circles => circles::run(&circles::Arguments::default()),
            Self::Clippy => for_all_packages(|selection| {
                let mut command = cargo(["clippy", "--release", "--all-targets"]);
                command.args(selection).args(["--", "-D", "warnings"]);
                run_command(&mut command)
            }),
            Self::Doc => for_all_packages(|selection| {
                let mut command = cargo(["doc", "--release", "--no-deps"]);
                run_command(command.args(selection).env("RUSTDOCFLAGS", "-D warnings"))
            }),
            Self::Features => features::run(&features::Arguments::default()),
            Self::Wasm => return wasm::check(),
            Self::Test => test::run(&test::Arguments::default()),
            Self::Shaders => shaders::check(),
            Self::Package => package::verify(),
            Self::Peers => return peers::compare(&peers::Arguments::default()),
            Self::Python => return python::check(&python::Arguments::default()),
        };
        whole.map(|()| Completion::Whole)
    }
}

/// Applies a cargo command to the workspace, and to the shader compiler the way [`shaders`] builds it: by itself. The
/// commands are of the release profile, which shares build scripts and their C++ with the tests.
fn for_all_packages(command: impl Fn(&[&str]) -> Result<(), Failure>) -> Result<(), Failure> {
    command(&["--workspace", "--exclude", COMPILER])?;
    command(&["--package", COMPILER])
}

/// Runs all steps, also after one has failed.
///
/// The shaders are compiled beside the steps that follow: most of that is one compiler run of minutes on a single core, in a folder of its own.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut steps = Steps::default();
    for &step in Step::value_variants().iter().filter(|step| !arguments.skip.contains(step)) {
        if step == Step::Shaders {
            steps.start(step.name(), this_program(["shaders", "--check"])?);
        } else {
            steps.run(step.name(), || step.run());
        }
    }
    steps.finish()
}

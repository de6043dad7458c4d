//! `cargo xtask man`: manual pages and completion scripts, for packages.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use crate::command::{self, cargo};
use crate::diff::program_path;
use crate::failure::Failure;

/// The shells, and where their completion scripts go, as distributions have it below /usr/share.
const COMPLETIONS: [(&str, &str); 5] = [
    ("bash", "bash-completion/completions/vitrum"),
    ("zsh", "zsh/site-functions/_vitrum"),
    ("fish", "fish/vendor_completions.d/vitrum.fish"),
    ("elvish", "elvish/lib/vitrum.elv"),
    ("powershell", "powershell/vitrum.ps1"),
];

/// Write manual pages and completion scripts to `target/share`, laid out as below /usr/share.
#[derive(clap::Args)]
pub struct Arguments {
    /// Another folder to write to.
    #[arg(short, long, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

/// Builds the program and lets it write them: it alone knows its flags.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    command::run(&mut cargo(["build", "--release", "--package", "vitrum-cli"]))?;
    let program = program_path("vitrum");
    let share = arguments.output.clone().unwrap_or_else(|| command::target().join("share"));
    command::run(Command::new(&program).args(["man", "--output"]).arg(share.join("man/man1")))?;
    for (shell, path) in COMPLETIONS {
        let path = share.join(path);
        let output = Command::new(&program).args(["completions", shell]).output();
        let script = output.map_err(|error| Failure::setup(format!("{}: {error}", program.display())))?;
        command::require_success(Command::new(&program).args(["completions", shell]), script.status)?;
        path.parent()
            .map_or(Ok(()), fs::create_dir_all)
            .and_then(|()| fs::write(&path, script.stdout))
            .map_err(|error| Failure::setup(format!("{} cannot be written: {error}", path.display())))?;
    }
    println!("{}", share.display());
    Ok(())
}

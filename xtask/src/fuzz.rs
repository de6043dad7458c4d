//! `cargo xtask fuzz`: coverage-guided fuzzing of the readers.

use std::path::Path;
use std::process::{self, Command, Stdio};
use std::{env, fs};

use crate::command::{self, cargo, program};
use crate::failure::Failure;

/// Fuzz the readers of volumes, meshes and pictures, guided by coverage; needs a nightly compiler and cargo-fuzz.
#[derive(clap::Args)]
pub struct Arguments {
    /// Readers to fuzz, such as `nrrd`; all, one after the other, if there is none.
    targets: Vec<String>,
    /// How long each is fuzzed.
    #[arg(long, value_name = "N", default_value_t = 60)]
    seconds: u32,
    /// Only write the files to start from, to `fuzz/corpus` and `fuzz/dictionaries`.
    #[arg(long)]
    seeds: bool,
}

/// Writes the seeds, then runs each target. What one finds ends it, and lies in `fuzz/artifacts` then.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let root = command::root();
    let known = targets(&root.join("fuzz/fuzz_targets"))?;
    if let Some(unknown) = arguments.targets.iter().find(|target| !known.contains(target)) {
        return Err(Failure::setup(format!("there is no reader `{unknown}`; the readers are: {}", known.join(", "))));
    }
    command::run(&mut cargo(["run", "--release", "--package", "vitrum-io", "--example", "fuzz-seeds", "--", "fuzz"]))?;
    if arguments.seeds {
        return Ok(());
    }
    require_tools()?;
    // In memory where the system has such a folder: every input is a file.
    let memory = Path::new("/dev/shm");
    let base = if memory.is_dir() { memory.to_owned() } else { env::temp_dir() };
    let folder = base.join(format!("vitrum-fuzz-{}", process::id()));
    let unwritable = |error| Failure::setup(format!("{}: {error}", folder.display()));
    fs::create_dir_all(&folder).map_err(unwritable)?;
    let chosen = if arguments.targets.is_empty() { &known } else { &arguments.targets };
    let mut found = Vec::new();
    for target in chosen {
        let mut fuzz = nightly();
        fuzz.env("TMPDIR", &folder);
        fuzz.args(["fuzz", "run", target, "--", "-timeout=10", "-rss_limit_mb=2048", "-max_len=8192"]);
        fuzz.args(["-print_final_stats=1".to_owned(), format!("-max_total_time={}", arguments.seconds)]);
        let dictionary = format!("fuzz/dictionaries/{target}");
        if fs::metadata(root.join(&dictionary)).is_ok_and(|metadata| metadata.len() > 0) {
            fuzz.arg(format!("-dict={dictionary}"));
        }
        if command::run(&mut fuzz).is_err() {
            found.push(target.as_str());
        }
    }
    fs::remove_dir_all(&folder).map_err(unwritable)?;
    match &found[..] {
        [] => Ok(()),
        found => Err(Failure::check(format!("fuzzing failed: {}; see fuzz/artifacts", found.join(", ")))),
    }
}

/// The names of the programs in the folder.
fn targets(folder: &Path) -> Result<Vec<String>, Failure> {
    let unreadable = |error| Failure::setup(format!("{}: {error}", folder.display()));
    let entries = fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>).map_err(unreadable)?;
    let stem = |entry: fs::DirEntry| entry.path().file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let mut names: Vec<_> = entries.into_iter().filter_map(stem).collect();
    names.sort();
    Ok(names)
}

/// The nightly compiler's cargo, by way of rustup: the variable `CARGO` names the cargo of this task.
fn nightly() -> Command {
    let mut command = program("cargo");
    command.arg("+nightly").env_remove("RUSTUP_TOOLCHAIN");
    command
}

fn require_tools() -> Result<(), Failure> {
    let works = |arguments: &[&str]| {
        let status = nightly().args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).status();
        status.is_ok_and(|status| status.success())
    };
    if !works(&["--version"]) {
        return Err(Failure::setup("fuzzing needs a nightly compiler: rustup toolchain install nightly"));
    }
    if !works(&["fuzz", "--version"]) {
        return Err(Failure::setup("fuzzing needs cargo-fuzz: cargo install cargo-fuzz"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_the_programs_by_name() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        for name in ["vtk.rs", "nrrd.rs"] {
            fs::write(folder.path().join(name), "").expect("a written file");
        }
        assert_eq!(targets(folder.path()).expect("the folder is there"), ["nrrd", "vtk"]);
        assert_eq!(targets(&folder.path().join("missing")).unwrap_err().code, 2);
    }

    #[test]
    fn an_unknown_target_is_refused_before_anything_is_built() {
        let arguments = Arguments { targets: vec!["nrdd".to_owned()], seconds: 1, seeds: false };
        let failure = run(&arguments).unwrap_err();
        assert_eq!(failure.code, 2);
        assert!(
            failure.message.contains("no reader `nrdd`") && failure.message.contains("nrrd"),
            "{}",
            failure.message
        );
    }
}

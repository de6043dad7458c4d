//! The examples run, and stay short enough to read at a glance.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const NAMES: [&str; 6] = ["volume", "in_memory", "mesh", "aov", "custom_kernel", "two_backends"];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples")
}

#[test]
fn every_example_runs() {
    let tests = std::env::current_exe().expect("the test knows its program");
    let built = tests.ancestors().nth(2).expect("tests lie in deps").join("examples");
    for name in NAMES {
        let written = tempfile::tempdir().expect("a folder");
        let program = built.join(name).with_extension(std::env::consts::EXE_EXTENSION);
        let output = Command::new(&program).current_dir(written.path()).output();
        let output = output.unwrap_or_else(|error| panic!("{}: {error}", program.display()));
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn every_example_is_in_the_list_and_short() {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder()).expect("the folder is there") {
        let path = entry.expect("it can be listed").path();
        let lines = fs::read_to_string(&path).expect("an example is text").lines().count();
        assert!(lines < 40, "{} has {lines} lines", path.display());
        names.push(path.file_stem().expect("it has a name").to_string_lossy().into_owned());
    }
    names.sort_unstable();
    let mut listed = NAMES.map(str::to_owned);
    listed.sort_unstable();
    assert_eq!(names, listed);
}

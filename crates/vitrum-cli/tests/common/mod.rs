//! Running the program in a folder of its own.
#![allow(dead_code, reason = "each test program uses a part of this")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// The outcome of a run of the program.
#[derive(Debug)]
pub struct Outcome {
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

/// A folder that is removed in the end.
pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a temporary folder can be made"))
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    pub fn file(&self, name: &str) -> PathBuf {
        self.path().join(name)
    }

    pub fn write(&self, name: &str, contents: impl AsRef<[u8]>) {
        fs::write(self.file(name), contents).expect("the folder is writable");
    }

    /// The names of the folder's entries, hidden ones included, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.path()).expect("the folder is readable");
        let mut names: Vec<_> =
            entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    /// Runs the program in the folder.
    pub fn vitrum(&self, arguments: &[&str]) -> Outcome {
        let output = Command::new(env!("CARGO_BIN_EXE_vitrum"))
            .args(arguments)
            .current_dir(self.path())
            .output()
            .expect("the program starts");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the program writes UTF-8");
        Outcome { code: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
    }

    /// Runs a command that must succeed; its standard output.
    pub fn succeed(&self, arguments: &[&str]) -> String {
        let outcome = self.vitrum(arguments);
        assert_eq!(outcome.code, Some(0), "{arguments:?}\n{}", outcome.stderr);
        outcome.stdout
    }

    /// Runs a command that must fail with `code`, say each of `words` in its error message, say what to do, and leave
    /// no file behind.
    pub fn refuse(&self, arguments: &[&str], code: i32, words: &[&str]) {
        let before = self.names();
        let outcome = self.vitrum(arguments);
        let message = &outcome.stderr;
        assert_eq!(outcome.code, Some(code), "{arguments:?}\n{message}");
        assert!(message.starts_with("error: "), "{message}");
        for word in words {
            assert!(message.contains(word), "{arguments:?} does not say `{word}`:\n{message}");
        }
        assert!(message.contains("help") && !message.contains("panicked"), "{message}");
        assert_eq!(outcome.stdout, "", "results go to standard output, errors do not");
        assert_eq!(self.names(), before, "{arguments:?} left something behind");
    }
}

/// An attached NRRD file of unsigned bytes.
pub fn nrrd(sizes: &str, fields: &str, data: &[u8]) -> Vec<u8> {
    let header = format!("NRRD0004\ntype: uint8\ndimension: 3\nsizes: {sizes}\nencoding: raw\n{fields}\n");
    [header.as_bytes(), data].concat()
}

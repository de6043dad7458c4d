//! Results on standard output, and small text files.

use crate::failure::{Failure, Status};
use clap::ValueEnum;
use clap::builder::StyledStr;
use std::io::{ErrorKind, IsTerminal, Write, stdout};
use std::path::Path;
use vitrum::io::{self, WriteOptions};

/// Bits per channel of PNG pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Bits {
    #[value(name = "8")]
    Eight,
    #[value(name = "16")]
    Sixteen,
}

impl Bits {
    /// The options with which pictures are written.
    pub fn options(self) -> WriteOptions {
        let png_bits = match self {
            Self::Eight => 8,
            Self::Sixteen => 16,
        };
        WriteOptions { png_bits, ..WriteOptions::default() }
    }

    /// Fails if more than 8 bits are asked for, and none of `files` is a PNG.
    pub fn check<'a>(self, mut files: impl Iterator<Item = &'a Path>) -> Result<(), Failure> {
        let is_png = |file: &Path| file.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("png"));
        if self == Self::Eight || files.any(is_png) {
            return Ok(());
        }
        let help = "write a .png, or leave it out: .exr and .tif keep float32";
        Err(Failure::new(Status::WrongUse, "--bits 16 is for PNG pictures, and there is none", help))
    }
}

/// Prints a result to standard output. A reader that has seen enough, such as `head`, is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::new(
            Status::WrongUse,
            format!("standard output cannot be written: {error}"),
            "check where it is redirected to",
        )),
        _ => Ok(()),
    }
}

/// Prints a text, with its styles on a terminal.
pub fn print_styled(text: &StyledStr) -> Result<(), Failure> {
    if stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none() {
        print(&text.ansi().to_string())
    } else {
        print(&text.to_string())
    }
}

/// Prints a JSON value to standard output.
pub fn print_json(value: &serde_json::Value) -> Result<(), Failure> {
    print(&json(value))
}

/// The text of a JSON value, indented, as it is printed and written.
pub fn json(value: &serde_json::Value) -> String {
    format!("{value:#}\n")
}

/// Prints names and their descriptions in two columns.
pub fn print_table<'a>(rows: impl Iterator<Item = (&'a str, &'a str)> + Clone) -> Result<(), Failure> {
    let width = rows.clone().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    print(&rows.map(|(name, description)| format!("{name:width$}  {description}\n")).collect::<String>())
}

/// Says what a preset or a transfer function took for granted about an input, on standard error.
pub fn tell(input: &str, notes: &[String], quiet: bool) {
    for note in notes.iter().filter(|_| !quiet) {
        eprintln!("note: {input}: {note}");
    }
}

/// Whether [`write_text`] could write to `path` now; worth asking before long work.
pub fn check_writable(path: &Path) -> Result<(), Failure> {
    check(path, io::check_text_writable)
}

/// Whether an output could be written to `path` now, by its format's `check`. Other names of a file that is there, which keep it as it is, are told.
pub fn check(path: &Path, check: impl Fn(&Path) -> Result<(), io::Error>) -> Result<(), Failure> {
    check(path).map_err(|error| Failure::output(&error))?;
    let others = other_names(path);
    if others > 0 {
        let path = path.display();
        eprintln!(
            "note: {path}: the file has {others} more {} (hard links): {path} gets a new file, and they keep the old one",
            if others == 1 { "name" } else { "names" }
        );
    }
    Ok(())
}

/// How many names a file has besides this one.
#[cfg(unix)]
fn other_names(path: &Path) -> u64 {
    use std::os::unix::fs::MetadataExt;
    std::fs::metadata(path).map_or(0, |file| if file.is_file() { file.nlink().saturating_sub(1) } else { 0 })
}

/// Other systems do not say it.
#[cfg(not(unix))]
fn other_names(_: &Path) -> u64 {
    0
}

/// Writes `text` to `path`, whole or not at all.
pub fn write_text(path: &Path, text: &str) -> Result<(), Failure> {
    io::write_text(path, text).map_err(|error| Failure::output(&error))
}

/// Says that a mesh's surface is not closed, which its owner may not expect, by its edges and by the rows of voxels that are empty for that.
pub fn warn_of_holes(mesh: &str, unpaired_edges: usize, open_rows: Option<u64>) {
    let rows = open_rows.unwrap_or(0);
    let left_empty = format!("; {rows} rows of voxels go through holes of the surface and were left empty");
    let rows = if rows > 0 { left_empty.as_str() } else { "" };
    if unpaired_edges > 0 || !rows.is_empty() {
        eprintln!(
            "warning: {mesh}: the surface is not closed, {unpaired_edges} edges are open or between triangles that face opposite ways, \
             so what is inside is a guess{rows}; `vitrum info` tells more"
        );
    }
}

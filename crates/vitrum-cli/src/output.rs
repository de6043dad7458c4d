//! Results on standard output, and small text files written whole or not at all.

use crate::failure::{Failure, Status};
use clap::ValueEnum;
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use tempfile::NamedTempFile;
use vitrum::io::WriteOptions;

/// Bits per channel of PNG pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Bits {
    #[value(name = "8")]
    Eight,
    #[value(name = "16")]
    Sixteen,
}

impl Bits {
    /// What pictures are written with.
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
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::new(
            Status::WrongUse,
            format!("standard output cannot be written: {error}"),
            "check where it is redirected to",
        )),
        _ => Ok(()),
    }
}

/// Prints a JSON value to standard output.
pub fn print_json(value: &serde_json::Value) -> Result<(), Failure> {
    print(&format!("{value:#}\n"))
}

/// Prints names and their descriptions in two columns.
pub fn print_table<'a>(rows: impl Iterator<Item = (&'a str, &'a str)> + Clone) -> Result<(), Failure> {
    let width = rows.clone().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    print(&rows.map(|(name, description)| format!("{name:width$}  {description}\n")).collect::<String>())
}

/// Whether [`write_text`] could write to `path` now; worth asking before long work.
pub fn check_writable(path: &Path) -> Result<(), Failure> {
    if path.is_dir() {
        return Err(unwritable(path, "there is a folder of this name", "choose another name"));
    }
    if path.exists() && !path.is_file() {
        return Err(unwritable(path, "this is a device or a pipe", "name a file; --json prints to standard output"));
    }
    create_beside(path).map(drop)
}

/// Writes `text` beside `path`, then renames it, so that `path` never holds half of it.
pub fn write_text(path: &Path, text: &str) -> Result<(), Failure> {
    let mut beside = create_beside(path)?;
    let failed = |error: io::Error| unwritable(path, &error.to_string(), "check the free space and the permissions");
    beside.write_all(text.as_bytes()).and_then(|()| beside.as_file().sync_all()).map_err(failed)?;
    beside.persist(path).map(drop).map_err(|error| failed(error.error))
}

fn create_beside(path: &Path) -> Result<NamedTempFile, Failure> {
    let folder = match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".vitrum-").suffix(".part");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // What any new file gets, less the umask; the default is private to its owner.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder).map_err(|error| {
        let problem = format!("no file can be created in {}: {error}", folder.display());
        unwritable(path, &problem, "create the folder, check its permissions, or write elsewhere")
    })
}

fn unwritable(path: &Path, problem: &str, help: &str) -> Failure {
    Failure::new(Status::WrongUse, format!("{}: cannot be written: {problem}", path.display()), help)
}

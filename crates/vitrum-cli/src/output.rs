//! Results on standard output, and small text files written whole or not at all.

use crate::failure::{Failure, Status};
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use tempfile::NamedTempFile;

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

//! Atomic writing: a file is written beside its path and renamed onto it, so that a path never holds half of one.

use std::fs;
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};

use crate::error::{Error, Report};
use crate::input::display_name;
use crate::temporary::Temporary;

/// The destination of an encoder: a file, or memory.
pub(crate) trait Sink: Write + Seek {}

impl<T: Write + Seek> Sink for T {}

/// Writes a text to `path`, whole or not at all.
///
/// # Errors
///
/// [`Error::Write`] where no file can be written there.
pub fn write_text(path: &Path, text: &str) -> Result<(), Error> {
    let name = display_name(path);
    write_whole(Report::new(&name), path, |sink| sink.write_all(text.as_bytes()))
}

/// As [`write_text`], up to the moment when the file appears at `path`.
///
/// # Errors
///
/// [`Error::Write`] where no file can be written there.
pub fn stage_text(path: &Path, text: &str) -> Result<Staged, Error> {
    let name = display_name(path);
    stage_whole(Report::new(&name), path, |sink| sink.write_all(text.as_bytes()))
}

/// A file that is whole and beside its path, so that several can appear together; it is removed where it is never put in its place.
#[derive(Debug)]
pub struct Staged {
    beside: Temporary,
    path: PathBuf,
}

impl Staged {
    #[cfg(all(feature = "animations", not(target_family = "wasm")))]
    pub(crate) fn of(beside: Temporary, path: PathBuf) -> Self {
        Self { beside, path }
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    ///
    /// [`Error::Write`] where the operating system fails.
    pub fn put(self) -> Result<(), Error> {
        let name = display_name(&self.path);
        self.beside.persist(&link_target(&self.path)).map_err(|error| failed(Report::new(&name), error))
    }
}

/// What an output fails with when the operating system does.
pub(crate) fn failed(report: Report, error: io::Error) -> Error {
    report.write(
        error.to_string(),
        "check the free space on the disk, and the limit of file sizes (ulimit -f)",
        Some(error),
    )
}

/// The file that a path stands for, where it is a link: outputs are written through links, and these stay.
fn link_target(path: &Path) -> PathBuf {
    const LONGEST_CHAIN: usize = 40;
    let mut target = path.to_owned();
    for _ in 0..LONGEST_CHAIN {
        let Ok(next) = fs::read_link(&target) else { break };
        target = target.parent().unwrap_or(Path::new("")).join(next);
    }
    target
}

/// Whether [`write_text`] could write to `path` now; worth asking before long work.
///
/// # Errors
///
/// [`Error::Write`] where the folder is not there or not writable, or where `path` is a folder, a device or a pipe.
pub fn check_text_writable(path: &Path) -> Result<(), Error> {
    let name = display_name(path);
    create_beside(Report::new(&name), path).map(drop)
}

/// Has `encode` write a file beside `path`, and renames it onto that; where anything fails, `path` stays as it was.
pub(crate) fn write_whole(
    report: Report,
    path: &Path,
    encode: impl FnOnce(&mut dyn Sink) -> io::Result<()>,
) -> Result<(), Error> {
    stage_whole(report, path, encode)?.put()
}

/// As [`write_whole`], up to the moment when the file appears at `path`.
pub(crate) fn stage_whole(
    report: Report,
    path: &Path,
    encode: impl FnOnce(&mut dyn Sink) -> io::Result<()>,
) -> Result<Staged, Error> {
    let beside = create_beside(report, path)?;
    let mut sink = BufWriter::new(beside.file());
    encode(&mut sink)
        .and_then(|()| sink.flush())
        // Before the rename, so that a crash behind it cannot leave an empty file at the path.
        .and_then(|()| beside.file().sync_all())
        .map_err(|error| failed(report, error))?;
    drop(sink);
    Ok(Staged { beside, path: path.to_owned() })
}

/// An empty file in the folder of `path`, thus on the same file system: renaming is atomic there.
pub(crate) fn create_beside(report: Report, path: &Path) -> Result<Temporary, Error> {
    let path = &link_target(path);
    let folder = match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    let shown = folder.display();
    if path.is_dir() {
        return Err(report.write("there is a folder of this name", "choose another name", None));
    }
    if path.exists() && !path.is_file() {
        return Err(report.write("this is a device or a pipe", "name a file", None));
    }
    if !folder.is_dir() {
        let problem = format!("there is no folder {shown}");
        return Err(report.write(problem, "create it, or write elsewhere", None));
    }
    Temporary::beside(folder).map_err(|error| {
        let problem = format!("no file can be created in {shown}: {error}");
        report.write(problem, "check its permissions, or write elsewhere", Some(error))
    })
}

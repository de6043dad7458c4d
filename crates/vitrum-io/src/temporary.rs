//! Files that are not to stay: removed when nobody needs them any more, and when the program has to end in the middle.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

/// The paths of all that are there now.
static THERE: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn there() -> MutexGuard<'static, Vec<PathBuf>> {
    // A list of paths is whole whenever it can be seen.
    THERE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes every temporary file of this process and every output that is not whole, for a program that ends at once, as on a
/// second signal, when nothing runs its destructors.
///
/// Whoever then begins or ends a file waits for ever, so that none comes after: only call this right before
/// [`std::process::exit`].
pub fn remove_unfinished() {
    let there = there();
    for path in there.iter() {
        // There is nobody left to tell; it may be gone already.
        let _ = fs::remove_file(path);
    }
    std::mem::forget(there);
}

/// A file that is removed with this value.
#[derive(Debug)]
pub(crate) struct Temporary {
    // In this order: the file goes, then its entry.
    named: NamedTempFile,
    _entry: Entry,
}

impl Temporary {
    /// A file that `make` makes.
    pub fn new(make: impl FnOnce() -> io::Result<NamedTempFile>) -> io::Result<Self> {
        // Locked before it is there, so that none is missed.
        let mut there = there();
        let named = make()?;
        let path = named.path().to_owned();
        there.push(path.clone());
        Ok(Self { named, _entry: Entry(path) })
    }

    pub fn file(&self) -> &File {
        self.named.as_file()
    }

    pub fn path(&self) -> &Path {
        self.named.path()
    }

    /// Renames it, and leaves it there.
    pub fn persist(self, path: &Path) -> io::Result<()> {
        let Self { named, _entry: entry } = self;
        let there = there();
        let renamed = named.persist(path);
        drop(there);
        drop(entry);
        renamed.map(drop).map_err(|error| error.error)
    }
}

/// A path in the list, taken out with this value.
#[derive(Debug)]
struct Entry(PathBuf);

impl Drop for Entry {
    fn drop(&mut self) {
        there().retain(|path| *path != self.0);
    }
}

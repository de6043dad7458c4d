//! Temporary files: removed when their last owner drops them, and when the program has to end early.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

#[cfg(not(target_family = "wasm"))]
use tempfile::NamedTempFile as Named;

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
        // No caller is left to report an error to; the file may be gone already.
        let _ = fs::remove_file(path);
    }
    std::mem::forget(there);
}

/// A file that is removed with this value.
#[derive(Debug)]
pub(crate) struct Temporary {
    // In this order: the file goes, then its entry.
    named: Named,
    _entry: Entry,
}

impl Temporary {
    /// A file in the system's folder for temporary files.
    pub fn new() -> io::Result<Self> {
        Self::make(create)
    }

    /// A file in a folder, with the permissions of any new file.
    pub fn beside(folder: &Path) -> io::Result<Self> {
        Self::make(|| create_in(folder))
    }

    fn make(create: impl FnOnce() -> io::Result<Named>) -> io::Result<Self> {
        // Locked before it is there, so that none is missed.
        let mut there = there();
        let named = create()?;
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
        renamed.map(drop).map_err(io::Error::from)
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

#[cfg(not(target_family = "wasm"))]
fn create() -> io::Result<Named> {
    Named::with_prefix("vitrum-")
}

#[cfg(not(target_family = "wasm"))]
fn create_in(folder: &Path) -> io::Result<Named> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".vitrum-").suffix(".part");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // The permissions of any new file, less the umask; by default the file would be private to its owner.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

#[cfg(target_family = "wasm")]
use without_files::{Named, create, create_in};

/// A page has no files: none can be created there.
#[cfg(target_family = "wasm")]
mod without_files {
    use super::{File, Path, io};

    /// A file that cannot be there.
    #[derive(Debug)]
    pub enum Named {}

    impl Named {
        pub fn as_file(&self) -> &File {
            match *self {}
        }

        pub fn path(&self) -> &Path {
            match *self {}
        }

        pub fn persist(self, _path: &Path) -> io::Result<()> {
            match self {}
        }
    }

    pub fn create() -> io::Result<Named> {
        Err(io::Error::new(io::ErrorKind::Unsupported, "there are no files on this platform"))
    }

    pub fn create_in(_folder: &Path) -> io::Result<Named> {
        create()
    }
}

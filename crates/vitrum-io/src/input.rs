//! A file about to be read: where it is, how it is packed, how it begins.

use std::borrow::Cow;
use std::fs;
use std::io::{self, BufRead, IsTerminal, Read};
use std::path::Path;

use crate::error::{Error, Place, Report};
use crate::memory;
use crate::options::OpenOptions;
use crate::packing::Packing;
use crate::samples::read_up_to;
use crate::storage::{ByteReader, Storage};
use crate::stream;
use crate::temporary::Temporary;
use crate::tolerance::BYTE_ORDER_MARK;

/// The path that stands for standard input.
pub const STANDARD_INPUT: &str = "-";

/// First bytes of a file that readers look at.
const HEAD: usize = 1024;

/// A file about to be read.
#[derive(Debug)]
pub struct Input<'a> {
    /// Path of the file, or the name of bytes in memory.
    path: &'a Path,
    /// Name for messages: the path as it was given.
    pub name: String,
    /// Size of the packed file in bytes; 0 for a folder.
    pub length: u64,
    /// First bytes of the file, unpacked, at most 1024.
    pub head: Vec<u8>,
    /// Compression around the whole file.
    pub packing: Packing,
    content: Content<'a>,
}

/// The bytes of an [`Input`].
#[derive(Debug)]
enum Content<'a> {
    /// The file at the path has them.
    File,
    /// No bytes: the path is a folder's.
    Folder,
    /// A temporary file has them, which is removed with this value.
    Spooled(Temporary),
    /// The caller gave them.
    Given(&'a [u8]),
    /// The caller gave them packed; these are unpacked.
    Unpacked(Vec<u8>),
}

impl<'a> Input<'a> {
    /// Looks at the file, the folder or, where `path` is [`STANDARD_INPUT`], the standard input, which is put into a
    /// temporary file, since readers go back and forth.
    ///
    /// # Errors
    ///
    /// [`Error::Unreadable`] where it is not there or not ours to read; [`Error::Unsupported`]
    /// where it is neither a file nor a folder, since a pipe or a device has no size to check;
    /// [`Error::TooLarge`] where standard input goes on beyond the limit in `options`.
    pub fn new(path: &'a Path, options: &OpenOptions) -> Result<Self, Error> {
        let mut input = Self {
            path,
            name: display_name(path),
            length: 0,
            head: Vec::new(),
            packing: Packing::Plain,
            content: Content::File,
        };
        if path == Path::new(STANDARD_INPUT) {
            input.name = "standard input".to_owned();
            let (file, length) = standard_input(Report::new(&input.name), options)?;
            (input.content, input.length) = (Content::Spooled(file), length);
        } else {
            let report = Report::new(&input.name);
            let metadata = fs::metadata(path).map_err(|error| report.unreadable(error))?;
            if metadata.is_dir() {
                return Ok(Self { content: Content::Folder, ..input });
            }
            if !metadata.is_file() {
                return Err(report.unsupported(
                    Place::File,
                    "this is a pipe or a device",
                    "save its content to a file first, or give it as standard input, named `-`",
                ));
            }
            input.length = metadata.len();
        }
        input.read_head()?;
        Ok(input)
    }

    /// The bytes of a file of this name. Nothing beside it is ever read.
    #[must_use]
    pub fn of_bytes(name: &'a str, bytes: &'a [u8]) -> Self {
        let path = Path::new(name);
        let mut input = Self {
            path,
            name: display_name(path),
            length: bytes.len() as u64,
            head: Vec::new(),
            packing: Packing::Plain,
            content: Content::Given(bytes),
        };
        // A plain slice has no error, and that of a packed one is reported by its reader.
        let _ = input.read_head();
        input
    }

    /// The last part of its path, for readers that look at names.
    pub(crate) fn file_name(&self) -> String {
        file_name(self.path)
    }

    /// Path of the file, or the name under which its bytes were given.
    pub(crate) fn path(&self) -> &'a Path {
        self.path
    }

    /// The folder that this is.
    pub(crate) fn folder(&self) -> Option<&'a Path> {
        matches!(self.content, Content::Folder).then_some(self.path)
    }

    /// Whether this is a folder.
    pub(crate) fn is_folder(&self) -> bool {
        self.folder().is_some()
    }

    /// Whether the bytes are the content of the file at the path.
    pub(crate) fn is_at_path(&self) -> bool {
        matches!(self.content, Content::File)
    }

    /// The folder of the files that this one names; `None` where the caller gave bytes.
    pub(crate) fn folder_beside(&self) -> Option<&'a Path> {
        match self.content {
            Content::Given(_) | Content::Unpacked(_) => None,
            Content::File | Content::Folder | Content::Spooled(_) => Some(self.path.parent().unwrap_or(Path::new(""))),
        }
    }

    /// Place of the bytes.
    pub(crate) fn storage(&self) -> Storage<'_> {
        match &self.content {
            Content::File | Content::Folder => Storage::Disk(Cow::Borrowed(self.path)),
            Content::Spooled(file) => Storage::Disk(Cow::Borrowed(file.path())),
            Content::Given(bytes) => Storage::Memory(bytes),
            Content::Unpacked(bytes) => Storage::Memory(bytes),
        }
    }

    /// The bytes as they are packed.
    pub(crate) fn open(&self) -> Result<ByteReader<'_>, Error> {
        self.storage().open().map_err(|error| Report::new(&self.name).unreadable(error))
    }

    /// The unpacked bytes.
    pub(crate) fn unpacked(&self) -> Result<Box<dyn Read + '_>, Error> {
        Ok(self.packing.unpack(self.open()?))
    }

    /// Reads the first bytes of the file: its packing, and the head by which readers recognise a format.
    fn read_head(&mut self) -> Result<(), Error> {
        let mut file = self.open()?;
        let packing = Packing::of(file.fill_buf().map_err(|error| Report::new(&self.name).unreadable(error))?);
        let mut head = vec![0; HEAD];
        let (filled, outcome) = read_up_to(&mut packing.unpack(file), &mut head);
        head.truncate(filled);
        // Readers of text recognise a file behind the mark of some editors, too.
        if head.starts_with(BYTE_ORDER_MARK) {
            head.drain(..BYTE_ORDER_MARK.len());
        }
        (self.packing, self.head) = (packing, head);
        // A damaged stream shows as far as it goes; the reader reports the damage.
        if packing == Packing::Plain {
            outcome.map_err(|error| Report::new(&self.name).unreadable(error))
        } else {
            Ok(())
        }
    }

    /// Unpacks the whole file, for readers that go back and forth: into a temporary one, and bytes in memory into memory.
    ///
    /// Stops at the limit in `options`, however far the file would go on.
    pub(crate) fn unpack(&mut self, options: &OpenOptions) -> Result<(), Error> {
        if self.packing == Packing::Plain {
            return Ok(());
        }
        let report = Report::new(&self.name);
        let (content, length) = match self.content {
            Content::Given(_) | Content::Unpacked(_) => {
                let mut bytes = Vec::new();
                let length = copy(report, &mut self.unpacked()?, options, |chunk| {
                    bytes.try_reserve(chunk.len()).map_err(|_| {
                        let needed = (bytes.len() + chunk.len()) as u64;
                        report.too_large(needed, memory::available(), "the system refused the memory: free some first")
                    })?;
                    bytes.extend_from_slice(chunk);
                    Ok(())
                })?;
                (Content::Unpacked(bytes), length)
            }
            _ => {
                let (file, length) = spool(report, &mut self.unpacked()?, options)?;
                (Content::Spooled(file), length)
            }
        };
        (self.content, self.length) = (content, length);
        self.packing = Packing::Plain;
        Ok(())
    }
}

fn standard_input(report: Report, options: &OpenOptions) -> Result<(Temporary, u64), Error> {
    let stdin = io::stdin();
    if stdin.is_terminal() {
        return Err(report.unsupported(
            Place::File,
            "this is a terminal",
            "redirect a file there, such as by `< head.nrrd`",
        ));
    }
    let (file, length) = spool(report, &mut stdin.lock(), options)?;
    if length == 0 {
        return Err(report.invalid(Place::File, "there is nothing in it", "check the program that writes it"));
    }
    Ok((file, length))
}

/// Puts all that `reader` gives into a temporary file; that and its length.
fn spool(report: Report, reader: &mut dyn Read, options: &OpenOptions) -> Result<(Temporary, u64), Error> {
    let unwritable = |error: io::Error| {
        report.unsupported(
            Place::File,
            format!("no temporary file can be written for it: {error}"),
            "free some space in the folder for temporary files, or choose another by TMPDIR",
        )
    };
    let file = Temporary::new().map_err(unwritable)?;
    let length =
        copy(report, reader, options, |chunk| io::Write::write_all(&mut file.file(), chunk).map_err(unwritable))?;
    Ok((file, length))
}

/// Gives all that `reader` gives to `take`, piece by piece, and returns the length; fails beyond the limit in `options`.
fn copy(
    report: Report,
    reader: &mut dyn Read,
    options: &OpenOptions,
    mut take: impl FnMut(&[u8]) -> Result<(), Error>,
) -> Result<u64, Error> {
    // The folder for temporary files is often in memory, so that the limit is that of memory.
    let limit = options.max_bytes.unwrap_or_else(memory::available);
    let mut chunk = vec![0; 64 * 1024];
    let mut length = 0_u64;
    loop {
        let (count, outcome) = read_up_to(reader, &mut chunk);
        outcome.map_err(|error| stream::broken(report, length + count as u64, error))?;
        length += count as u64;
        if length > limit {
            return Err(report.too_large(
                length,
                limit,
                "that is only as far as it was read: raise the limit, or crop or downsample the data first",
            ));
        }
        take(&chunk[..count])?;
        if count < chunk.len() {
            return Ok(length);
        }
    }
}

/// A path for messages: as it was given, and of a very long one the end.
pub(crate) fn display_name(path: &Path) -> String {
    const MOST: usize = 160;
    let shown = path.to_string_lossy();
    match shown.char_indices().rev().nth(MOST - 1) {
        Some((start, _)) if start > 0 => format!("…{}", &shown[start..]),
        _ => shown.into_owned(),
    }
}

/// The last part of a path.
pub(crate) fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_shown_as_given_and_long_ones_by_their_end() {
        assert_eq!(display_name(Path::new("a/../b/scan.nrrd")), "a/../b/scan.nrrd");
        assert_eq!(display_name(Path::new("a/b/")), "a/b/");
        let most = "ä".repeat(160);
        assert_eq!(display_name(Path::new(&most)), most);
        let long = format!("folder/{most}");
        assert_eq!(display_name(Path::new(&long)), format!("…{most}"));
        assert_eq!(file_name(Path::new("a/b/scan.nrrd")), "scan.nrrd");
    }
}

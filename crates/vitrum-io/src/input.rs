//! A file about to be read: where it is, how it is packed, how it begins.

use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, IsTerminal, Read};
use std::path::Path;

use tempfile::NamedTempFile;

use crate::error::{Error, Place, Report};
use crate::memory;
use crate::open::OpenOptions;
use crate::packing::Packing;
use crate::samples::read_up_to;
use crate::stream;
use crate::temporary::Temporary;

/// The path that stands for standard input.
pub const STANDARD_INPUT: &str = "-";

/// A file about to be read.
#[derive(Debug)]
pub struct Input<'a> {
    /// Its path; the files that a header names lie beside it.
    pub path: &'a Path,
    /// Its name for messages: the path as it was given.
    pub name: String,
    /// Its size in bytes as it is packed; 0 for a folder.
    pub length: u64,
    /// Its first bytes, at most 1024, unpacked.
    pub head: Vec<u8>,
    /// How the whole file is packed.
    pub packing: Packing,
    /// Where the bytes are, if not at `path`; removed with this.
    spooled: Option<Temporary>,
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
            spooled: None,
        };
        if path == Path::new(STANDARD_INPUT) {
            input.name = "standard input".to_owned();
            let (file, length) = standard_input(Report::new(&input.name), options)?;
            (input.spooled, input.length) = (Some(file), length);
        } else {
            let report = Report::new(&input.name);
            let metadata = fs::metadata(path).map_err(|error| report.unreadable(error))?;
            if metadata.is_dir() {
                return Ok(input);
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
        input.look()?;
        Ok(input)
    }

    /// The last part of its path, for readers that look at names.
    pub(crate) fn file_name(&self) -> String {
        file_name(self.path)
    }

    /// The file that holds the bytes.
    pub(crate) fn file(&self) -> &Path {
        self.spooled.as_ref().map_or(self.path, Temporary::path)
    }

    /// Whether this is a folder.
    pub(crate) fn is_folder(&self) -> bool {
        self.spooled.is_none() && self.path.is_dir()
    }

    /// The bytes as they are packed.
    pub(crate) fn open(&self) -> Result<BufReader<File>, Error> {
        let file = File::open(self.file()).map_err(|error| Report::new(&self.name).unreadable(error))?;
        Ok(BufReader::new(file))
    }

    /// The unpacked bytes.
    pub(crate) fn unpacked(&self) -> Result<Box<dyn Read>, Error> {
        Ok(self.packing.unpack(self.open()?))
    }

    /// Takes in how the file begins.
    fn look(&mut self) -> Result<(), Error> {
        const HEAD: usize = 1024;
        let report = Report::new(&self.name);
        let mut file = self.open()?;
        self.packing = Packing::of(file.fill_buf().map_err(|error| report.unreadable(error))?);
        self.head = vec![0; HEAD];
        let (filled, outcome) = read_up_to(&mut self.packing.unpack(file), &mut self.head);
        self.head.truncate(filled);
        // A damaged stream shows as far as it goes; the reader reports the damage.
        if self.packing == Packing::Plain { outcome.map_err(|error| report.unreadable(error)) } else { Ok(()) }
    }

    /// Unpacks the whole file into a temporary one, for readers that go back and forth.
    ///
    /// Stops at the limit in `options`, however far the file would go on.
    pub(crate) fn unpack(&mut self, options: &OpenOptions) -> Result<(), Error> {
        if self.packing == Packing::Plain {
            return Ok(());
        }
        let report = Report::new(&self.name);
        let (file, length) = spool(report, &mut self.unpacked()?, options)?;
        (self.spooled, self.length) = (Some(file), length);
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
            "send a file there, such as by `vitrum info - < head.nrrd`",
        ));
    }
    let (file, length) = spool(report, &mut stdin.lock(), options)?;
    if length == 0 {
        return Err(report.invalid(Place::File, "there is nothing in it", "check the program that writes it"));
    }
    Ok((file, length))
}

/// Puts all that `reader` gives into a temporary file; its path and length.
fn spool(report: Report, reader: &mut dyn Read, options: &OpenOptions) -> Result<(Temporary, u64), Error> {
    // The folder for temporary files is often in memory, so that the limit is that of memory.
    let limit = options.max_bytes.unwrap_or_else(memory::available);
    let unwritable = |error: io::Error| {
        report.unsupported(
            Place::File,
            format!("no temporary file can be written for it: {error}"),
            "free some space in the folder for temporary files, or choose another by TMPDIR",
        )
    };
    let file = Temporary::new(|| NamedTempFile::with_prefix("vitrum-")).map_err(unwritable)?;
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
        io::Write::write_all(&mut file.file(), &chunk[..count]).map_err(unwritable)?;
        if count < chunk.len() {
            return Ok((file, length));
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

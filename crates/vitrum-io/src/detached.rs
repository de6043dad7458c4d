//! Files beside a header that hold its data: which ones it may name.

use std::borrow::Cow;
use std::fs;
use std::io::{Seek, SeekFrom};
use std::path::{Component, Path, PathBuf};

use crate::error::{Error, Place, Report, clip};
use crate::fields::Field;
use crate::input::{Input, display_name};
use crate::memory;
use crate::options::OpenOptions;
use crate::paged::Contiguous;
use crate::samples::{Endian, SampleType, VoxelBuffer};
use crate::source::Assumptions;
use crate::storage::{ByteReader, Storage};
use crate::stored::Stored;

/// More files than this for one volume are a mistake in the header.
const MOST_FILES: u64 = 1_000_000;

/// One file, and where its data segment starts.
#[derive(Debug)]
pub(crate) struct DataFile<'a> {
    storage: Storage<'a>,
    /// Name of the file, for messages.
    pub name: String,
    /// Size of the file in bytes.
    pub length: u64,
    /// The byte from which lines and bytes are skipped.
    pub start: u64,
}

impl<'a> DataFile<'a> {
    /// The header's own file, with the data behind the header's `start` bytes.
    pub fn attached(input: &'a Input, start: u64) -> Self {
        Self { storage: input.storage(), name: input.name.clone(), length: input.length, start }
    }

    /// A file that the header names at `place`, as [`locate`] finds it.
    pub fn detached(report: Report, place: Place, input: &Input, name: &str) -> Result<Self, Error> {
        let (path, length) = locate(report, place, input, name)?;
        Ok(Self { name: display_name(&path), length, storage: Storage::Disk(Cow::Owned(path)), start: 0 })
    }

    /// The bytes from the start of its data segment on.
    pub fn open(&self) -> Result<ByteReader<'a>, Error> {
        let unreadable = |error| Report::new(&self.name).unreadable(error);
        let mut reader = self.storage.open().map_err(unreadable)?;
        reader.seek(SeekFrom::Start(self.start)).map_err(unreadable)?;
        Ok(reader)
    }

    /// The file as one with samples that lie one behind the other from the byte `start` on.
    pub fn contiguous(
        &self,
        start: u64,
        dimensions: [u32; 3],
        (sample, endian): (SampleType, Endian),
    ) -> Contiguous<'_> {
        Contiguous { storage: self.storage.clone(), name: &self.name, start, dimensions, sample, endian }
    }

    /// Bytes of its data segment.
    pub fn available(&self) -> u64 {
        self.length.saturating_sub(self.start)
    }
}

/// Path and size of a file that a header names at `place`. A header may come from anywhere, so it
/// reaches only regular files in its own folder and below.
pub(crate) fn locate(report: Report, place: Place, input: &Input, name: &str) -> Result<(PathBuf, u64), Error> {
    let refuse = |problem: String| {
        let advice = "put a regular file beside the header, and name it relative to that";
        report.invalid(place, problem, advice)
    };
    if !is_below(name) {
        return Err(refuse(format!("the data file `{}` is not below the header", clip(name))));
    }
    let Some(folder) = input.folder_beside() else {
        return Err(report.unsupported(
            place,
            format!("the data is in another file, `{}`, and the bytes of this one alone were given", clip(name)),
            "open it by its path, or write both into one file",
        ));
    };
    let path = folder.join(name);
    let metadata = fs::metadata(&path)
        .map_err(|error| refuse(format!("the data file `{}` cannot be read: {error}", clip(name))))?;
    if !metadata.is_file() {
        return Err(refuse(format!("the data file `{}` is not a regular file", clip(name))));
    }
    Ok((path, metadata.len()))
}

/// Whether a path that a file names stays in that file's folder and below.
pub(crate) fn is_below(name: &str) -> bool {
    let is_step = |component| matches!(component, Component::Normal(_) | Component::CurDir);
    !name.is_empty() && Path::new(name).components().all(is_step)
}

/// Files that a header lists on the lines behind a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct List {
    /// Dimension of each file's data, from 1, a row, on; `None` where the header does not say it.
    pub dimension: Option<usize>,
}

impl List {
    /// The list that `LIST` or `LIST DIMENSION` begins, with a dimension of at most `most`; `None` of any other field.
    pub fn of(report: Report, field: &Field, most: usize) -> Result<Option<Self>, Error> {
        let Some(rest) = field.text.strip_prefix("LIST").filter(|_| Self::begins(field)) else { return Ok(None) };
        let rest = rest.trim();
        let dimension = (!rest.is_empty()).then(|| dimension(report, field, rest, most)).transpose()?;
        Ok(Some(Self { dimension }))
    }

    /// Whether a field begins a list.
    pub fn begins(field: &Field) -> bool {
        field.text.split_whitespace().next() == Some("LIST")
    }
}

/// The dimension of a file's data, 1 to `most`.
pub(crate) fn dimension(report: Report, field: &Field, text: &str, most: usize) -> Result<usize, Error> {
    text.parse().ok().filter(|dimension| (1..=most).contains(dimension)).ok_or_else(|| {
        report.invalid(
            field.place(),
            format!("`{}` is not the dimension of a file's data, 1 to {most}", clip(text)),
            "give 1 for rows, 2 for slices, 3 for slabs, or nothing for slices",
        )
    })
}

/// Fails where a header names `count` files for `expected`, such as `2 slices`, and these do not fit, or are too many.
pub(crate) fn check_file_count(
    report: Report,
    field: &Field,
    count: u64,
    fits: bool,
    expected: &str,
) -> Result<(), Error> {
    if fits && count <= MOST_FILES {
        return Ok(());
    }
    Err(report.invalid(
        field.place(),
        format!("{count} data files for {expected}, where at most {MOST_FILES} are read"),
        "give one file for each, and check the numbers behind the pattern",
    ))
}

/// Files that hold a volume one after the other, each with the same share of the voxels.
pub(crate) struct DataFiles<'a> {
    /// At least one.
    pub files: &'a [DataFile<'a>],
    /// Voxels in all of them.
    pub count: u64,
    pub sample: SampleType,
    pub endian: Endian,
    /// Bytes of a voxel in memory.
    pub stored: u64,
}

impl DataFiles<'_> {
    /// Has `check` look at each file, which holds so many voxels, before any memory is taken, and then `append` decode them;
    /// that returns the bytes behind a file's last voxel.
    pub fn read(
        &self,
        report: Report,
        options: &OpenOptions,
        notes: &mut Assumptions,
        check: impl Fn(&DataFile, u64) -> Result<(), Error>,
        append: impl Fn(&DataFile, &mut VoxelBuffer, usize) -> Result<u64, Error>,
    ) -> Result<Stored, Error> {
        // Lies about the size come first: they are the better message, and need no memory.
        let share = self.count / self.files.len() as u64;
        self.files.iter().try_for_each(|file| check(file, share))?;
        memory::check(report, self.count * self.stored, options.max_bytes)?;
        let capacity = usize::try_from(self.count).unwrap_or(usize::MAX);
        let mut voxels = VoxelBuffer::reserve(report, self.sample, self.endian, capacity)?;
        let mut unread = 0;
        for file in self.files {
            unread += append(file, &mut voxels, capacity / self.files.len())?;
        }
        if self.files.len() > 1 {
            notes.push(format!("the data was put together from {} files", self.files.len()));
        }
        if unread > 0 {
            notes.push(format!("{unread} bytes behind the last voxel were left unread"));
        }
        Ok(voxels.into_voxels())
    }
}

/// Names that differ by a number: one with `%d` in it, and the numbers.
pub(crate) struct NumberedNames<'a> {
    pub name: &'a str,
    pub first: i64,
    pub last: i64,
    pub step: i64,
}

impl NumberedNames<'_> {
    /// 0 where the step never gets from first to last.
    pub fn count(&self) -> u64 {
        let steps = (self.last - self.first).checked_div(self.step);
        steps.and_then(|steps| u64::try_from(steps).ok()).map_or(0, |steps| steps + 1)
    }

    /// Names of all data files; `example` is the form that the header should have.
    pub fn names(&self, report: Report, field: &Field, example: &str) -> Result<Vec<String>, Error> {
        let numbers = (0..self.count()).map(|index| self.first + index as i64 * self.step);
        let names: Option<Vec<_>> = numbers.map(|number| numbered_name(self.name, number)).collect();
        names.ok_or_else(|| {
            report.invalid(
                field.place(),
                format!("`{}` is not a name with one number such as %d or %03d", clip(self.name)),
                format!("write `{example}`"),
            )
        })
    }
}

/// `name` with its one `%d`, `%i` or `%u`, perhaps with a width such as `%03d`, put in numbers.
pub(crate) fn numbered_name(name: &str, number: i64) -> Option<String> {
    let (before, after) = name.split_once('%')?;
    let conversion = after.find(['d', 'i', 'u'])?;
    let (width, rest) = after.split_at(conversion);
    let rest = &rest[1..];
    if rest.contains('%') {
        return None;
    }
    let digits = match width {
        "" => number.to_string(),
        _ => match (width.strip_prefix('0'), width.parse::<usize>().ok()?) {
            (_, 33..) => return None,
            (Some(_), width) => format!("{number:0width$}"),
            (None, width) => format!("{number:width$}"),
        },
    };
    Some(format!("{before}{digits}{rest}"))
}

//! Files beside a header that hold its data: which ones it may name.

use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::error::{Error, Place, Report, clip};
use crate::input::{Input, display_name};

/// More files than this for one volume are a mistake in the header.
pub(crate) const MOST_FILES: u64 = 1_000_000;

/// One file, and where its data segment starts.
#[derive(Debug)]
pub(crate) struct DataFile {
    pub path: PathBuf,
    /// Its name for messages.
    pub name: String,
    /// Its size in bytes.
    pub length: u64,
    /// Where lines and bytes are skipped from.
    pub start: u64,
}

impl DataFile {
    /// The header's own file, with the data behind the header's `start` bytes.
    pub fn attached(input: &Input, start: u64) -> Self {
        Self { path: input.file().to_owned(), name: input.name.clone(), length: input.length, start }
    }

    /// Finds a file that the header names at `place`. A header may come from anywhere, so it
    /// reaches only regular files in its own folder and below.
    pub fn detached(report: Report, place: Place, input: &Input, name: &str) -> Result<Self, Error> {
        let refuse = |problem: String| {
            let advice = "put a regular file beside the header, and name it relative to that";
            report.invalid(place, problem, advice)
        };
        if !is_below(name) {
            return Err(refuse(format!("the data file `{}` is not below the header", clip(name))));
        }
        let path = input.path.parent().unwrap_or(Path::new("")).join(name);
        let metadata = fs::metadata(&path)
            .map_err(|error| refuse(format!("the data file `{}` cannot be read: {error}", clip(name))))?;
        if !metadata.is_file() {
            return Err(refuse(format!("the data file `{}` is not a regular file", clip(name))));
        }
        Ok(Self { name: display_name(&path), length: metadata.len(), path, start: 0 })
    }
}

/// Whether a path that a file names stays in that file's folder and below.
pub(crate) fn is_below(name: &str) -> bool {
    let is_step = |component| matches!(component, Component::Normal(_) | Component::CurDir);
    !name.is_empty() && Path::new(name).components().all(is_step)
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

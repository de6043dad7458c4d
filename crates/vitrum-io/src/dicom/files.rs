//! Which files make up a volume: those of one series.

use std::fs::{self, DirEntry};
use std::io::Read;
use std::path::{Path, PathBuf};

use super::header::{File, Frame, Slice};
use super::syntax::{self, Compression};
use crate::error::{Error, Place, Report, clip};
use crate::input::{Input, display_name};

/// More files than this in a folder are no volume.
const MOST_FILES: usize = 100_000;

/// Where the letters are that every file has.
const MAGIC: std::ops::Range<usize> = 128..132;

pub(super) fn is_dicom(head: &[u8]) -> bool {
    head.get(MAGIC) == Some(b"DICM")
}

/// Whether `path` is a folder with at least one DICOM file in it.
pub(super) fn has_dicom(path: &Path) -> bool {
    path.is_dir()
        && fs::read_dir(path).is_ok_and(|entries| entries.flatten().take(MOST_FILES).any(|entry| holds(&entry)))
}

fn holds(entry: &DirEntry) -> bool {
    let mut head = Vec::new();
    let path = entry.path();
    // The file behind a link, and no pipe, which could be waited for.
    path.is_file()
        && fs::File::open(path).is_ok_and(|file| file.take(MAGIC.end as u64).read_to_end(&mut head).is_ok())
        && is_dicom(&head)
}

/// The files of one series, at least one, each with at least one frame.
pub(super) struct Series {
    pub files: Vec<File>,
}

impl Series {
    /// The series of a file, or the largest one of a folder.
    pub fn find(input: &Input, assumptions: &mut Vec<String>) -> Result<Self, Error> {
        let report = Report::new(&input.name);
        if input.is_folder() {
            let files = scan(report, input.path, assumptions)?;
            return Self::largest(report, files, assumptions);
        }
        let opened = File::read(input.file(), input.name.clone(), input.length)?.ok_or_else(|| {
            report.unsupported(Place::File, "this DICOM file holds no image", "open the file of an image, or a folder")
        })?;
        let beside = input.file() == input.path && opened.frames.len() == 1 && !opened.series.is_empty();
        if !beside {
            return Ok(Self { files: vec![opened] });
        }
        let folder = input.path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        let mut files = scan(report, folder, &mut Vec::new())?;
        files.retain(|file| file.series == opened.series);
        if files.len() > 1 {
            assumptions.push(format!("the {} files beside it of the same series were read, too", files.len() - 1));
        }
        Ok(Self { files: if files.is_empty() { vec![opened] } else { files } })
    }

    fn largest(report: Report, files: Vec<File>, assumptions: &mut Vec<String>) -> Result<Self, Error> {
        let mut groups: Vec<Vec<File>> = Vec::new();
        for file in files {
            match groups.iter_mut().find(|group| group[0].series == file.series) {
                Some(group) => group.push(file),
                None => groups.push(vec![file]),
            }
        }
        let slices = |group: &[File]| group.iter().map(|file| file.frames.len()).sum::<usize>();
        groups.sort_by_key(|group| std::cmp::Reverse(slices(group)));
        let named = |group: &[File]| {
            let File { name, description, .. } = &group[0];
            let described = if description.is_empty() { String::new() } else { format!("`{description}`, ") };
            format!("{described}{} slices, {} among its files", slices(group), clip(name))
        };
        let listed = |groups: &[Vec<File>]| {
            const MOST_NAMES: usize = 8;
            let mut shown: Vec<_> = groups.iter().take(MOST_NAMES).map(|group| named(group)).collect();
            shown.extend((groups.len() > MOST_NAMES).then(|| format!("{} more", groups.len() - MOST_NAMES)));
            shown.join("; ")
        };
        let advice = "name a file of the one that is wanted instead of the folder";
        match &groups[..] {
            [] => {
                return Err(report.unsupported(
                    Place::File,
                    "the DICOM files in this folder hold no images",
                    "give the folder with the slices",
                ));
            }
            [first, second, ..] if slices(first) == slices(second) => {
                let count = groups.len();
                let problem = format!("the folder holds {count} series, the largest alike: {}", listed(&groups));
                return Err(report.unsupported(Place::File, problem, advice));
            }
            [first, others @ ..] if !others.is_empty() => {
                let (first, others) = (named(first), listed(others));
                assumptions.push(format!("the largest series was taken ({first}); others are: {others}; {advice}"));
            }
            _ => {}
        }
        Ok(Self { files: groups.swap_remove(0) })
    }

    /// The first file, once all others are of its size and type.
    pub fn check_alike(&self) -> Result<&File, Error> {
        let first = &self.files[0];
        for file in &self.files {
            let report = Report::new(&file.name);
            let compressed = syntax::compression(report, &file.syntax)? != Compression::None;
            if file.describe() != first.describe() || file.pixels != first.pixels {
                return Err(report.invalid(
                    Place::File,
                    format!(
                        "this slice is {} of {} bits, and {} of the same series {} of {}",
                        file.describe(),
                        file.pixels.stored,
                        first.name,
                        first.describe(),
                        first.pixels.stored
                    ),
                    "leave out the files that are no slices, such as scouts",
                ));
            }
            let bytes = u64::from(file.rows) * u64::from(file.columns) * file.pixels.sample.size() as u64;
            let all = bytes.saturating_mul(file.frames.len() as u64);
            if !compressed && all > file.length {
                return Err(report.invalid(
                    Place::File,
                    format!("the pixels take {all} bytes, and the whole file has {}", file.length),
                    "get the whole file",
                ));
            }
        }
        Ok(first)
    }

    /// All frames of all files.
    pub fn slices(&self) -> Vec<Slice<'_>> {
        let frames = self.files.iter().enumerate().flat_map(|(number, file)| {
            file.frames.iter().enumerate().map(move |(index, frame)| (file, [number, index], frame))
        });
        let slice = |(file, index, frame): (_, _, &Frame)| {
            let Frame { position, orientation, rescale } = *frame;
            Slice { file, index, position, orientation, rescale }
        };
        frames.map(slice).collect()
    }
}

/// The images among the files of a folder, sorted by name.
fn scan(report: Report, folder: &Path, assumptions: &mut Vec<String>) -> Result<Vec<File>, Error> {
    let entries = fs::read_dir(folder).map_err(|error| report.unreadable(error))?;
    let mut paths: Vec<PathBuf> = Vec::new();
    let mut others = 0_u64;
    for entry in entries {
        let entry = entry.map_err(|error| report.unreadable(error))?;
        if paths.len() == MOST_FILES {
            let problem = format!("there are more than {MOST_FILES} DICOM files in the folder");
            return Err(report.unsupported(Place::File, problem, "give a folder with one series"));
        }
        if holds(&entry) { paths.push(entry.path()) } else { others += 1 }
    }
    paths.sort();
    let mut files = Vec::new();
    for path in paths {
        let name = display_name(&path);
        let length = fs::metadata(&path).map_err(|error| Report::new(&name).unreadable(error))?.len();
        match File::read(&path, name, length)? {
            Some(file) => files.push(file),
            None => others += 1,
        }
    }
    if others > 0 {
        assumptions.push(format!("{others} files of the folder are no DICOM images, and were left unread"));
    }
    Ok(files)
}

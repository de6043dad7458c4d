//! Search for the images of a folder: in it, or below it, as hospitals export them.

use std::borrow::Cow;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use super::envelope::begins_data_set;
use super::header::Header;
use super::image::File;
use crate::error::{Error, Place, Report};
use crate::folder::MOST_FILES;
use crate::input::display_name;
use crate::source::Assumptions;
use crate::storage::Storage;

/// Folders below one another that are looked into: exports have one for the patient, the study and the series, and perhaps some above.
const MOST_DEPTH: usize = 8;

/// Position of the letters that every file has.
pub(super) const MAGIC: std::ops::Range<usize> = 128..132;

pub(super) fn is_dicom(head: &[u8]) -> bool {
    head.get(MAGIC) == Some(b"DICM") || begins_data_set(head)
}

/// Whether `path` is a folder with at least one DICOM file in it.
pub(super) fn has_dicom(path: &Path) -> bool {
    path.is_dir()
        && fs::read_dir(path).is_ok_and(|entries| entries.flatten().take(MOST_FILES).any(|entry| holds(&entry.path())))
}

/// Whether `path` is a folder with at least one DICOM file below it.
pub(super) fn has_dicom_below(path: &Path) -> bool {
    let mut seen = 0;
    path.is_dir()
        && Below::of(path).any(|folder| {
            let mut entries = fs::read_dir(&folder).into_iter().flatten().flatten();
            entries.any(|entry| {
                seen += 1;
                seen <= MOST_FILES && holds(&entry.path())
            })
        })
}

fn holds(path: &Path) -> bool {
    let mut head = Vec::new();
    // The file behind a link, and no pipe, which could be waited for.
    let large = fs::metadata(path).is_ok_and(|metadata| metadata.is_file() && metadata.len() >= MAGIC.end as u64);
    large
        && fs::File::open(path).is_ok_and(|file| file.take(MAGIC.end as u64).read_to_end(&mut head).is_ok())
        && is_dicom(&head)
}

/// A folder and those below it, without those behind links, which may lead back.
struct Below {
    left: Vec<(PathBuf, usize)>,
    folders: usize,
}

impl Below {
    fn of(folder: &Path) -> Self {
        Self { left: vec![(folder.to_owned(), 0)], folders: 0 }
    }
}

impl Iterator for Below {
    type Item = PathBuf;

    fn next(&mut self) -> Option<PathBuf> {
        let (folder, depth) = self.left.pop()?;
        if depth < MOST_DEPTH {
            let folders = fs::read_dir(&folder).into_iter().flatten().flatten();
            let folders = folders.filter(|entry| entry.file_type().is_ok_and(|kind| kind.is_dir()));
            let room = MOST_FILES.saturating_sub(self.folders);
            let before = self.left.len();
            self.left.extend(folders.take(room).map(|entry| (entry.path(), depth + 1)));
            self.folders += self.left.len() - before;
        }
        Some(folder)
    }
}

/// The images of a folder.
pub(super) struct Images {
    /// The image files, sorted by name.
    pub files: Vec<File>,
    /// Errors of files that cannot be read.
    pub broken: Vec<Error>,
    /// Images of kinds that are not read, with their series.
    pub refused: Vec<(String, Error)>,
    /// Whether they lie below the folder, and not in it.
    pub below: bool,
}

/// The images in a folder, or in the folders below it if it has none itself.
pub(super) fn images(report: Report, folder: &Path, assumptions: &mut Assumptions) -> Result<Images, Error> {
    let direct = scan(report, &[folder.to_owned()], assumptions)?;
    if !direct.files.is_empty() || !direct.refused.is_empty() {
        return Ok(direct);
    }
    let folders: Vec<PathBuf> = Below::of(folder).skip(1).collect();
    assumptions.clear();
    let mut below = scan(report, &folders, assumptions)?;
    below.broken.splice(0..0, direct.broken);
    Ok(Images { below: true, ..below })
}

impl Images {
    /// Tells of the files that cannot be read.
    pub fn note_broken(&self, assumptions: &mut Assumptions) {
        if let Some(first) = self.broken.first() {
            assumptions.push(format!("left out: {} files that cannot be read, such as {first}", self.broken.len()));
        }
    }
}

/// The images in one folder.
pub(super) fn images_in(report: Report, folder: &Path) -> Result<Images, Error> {
    scan(report, &[folder.to_owned()], &mut Assumptions::default())
}

fn scan(report: Report, folders: &[PathBuf], assumptions: &mut Assumptions) -> Result<Images, Error> {
    let mut paths: Vec<PathBuf> = Vec::new();
    let mut others = 0_u64;
    for folder in folders {
        let shown = display_name(folder);
        let unreadable = |error| Report::new(&shown).unreadable(error);
        for entry in fs::read_dir(folder).map_err(unreadable)? {
            let path = entry.map_err(unreadable)?.path();
            if paths.len() == MOST_FILES {
                let problem = format!("there are more than {MOST_FILES} DICOM files in the folder");
                return Err(report.unsupported(Place::File, problem, "give a folder with one series"));
            }
            if holds(&path) {
                paths.push(path);
            } else if !(folders.len() > 1 && path.is_dir()) {
                others += 1;
            }
        }
    }
    paths.sort();
    let mut images = Images { files: Vec::new(), broken: Vec::new(), refused: Vec::new(), below: false };
    for path in paths {
        let name = display_name(&path);
        let length = fs::metadata(&path).map_err(|error| Report::new(&name).unreadable(error))?.len();
        match File::read(&Storage::Disk(Cow::Borrowed(&path)), &path, &name, length) {
            Ok(Header::Image(file)) => images.files.push(*file),
            Ok(Header::Refused { series, error }) => images.refused.push((series, error)),
            Ok(Header::Other) => others += 1,
            // Memory is no fault of the file.
            Err(error @ Error::TooLarge { .. }) => return Err(error),
            Err(error) => images.broken.push(error),
        }
    }
    if others > 0 {
        assumptions.push(format!("{others} files of the folder are no DICOM images, and were left unread"));
    }
    Ok(images)
}

//! The files of a volume: the files of one DICOM series.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use super::header::Header;
use super::image::{File, Frame, Slice};
use super::search::{Images, images, images_in};
use super::syntax::{self, Compression};
use crate::error::{Error, Place, Report, clip};
use crate::input::{Input, display_name};
use crate::source::Assumptions;

/// The files of one series, at least one, each with at least one frame.
pub(super) struct Series {
    pub files: Vec<File>,
}

impl Series {
    /// The series of a file, the largest one in a folder, or the only one below it.
    pub fn find(input: &Input, assumptions: &mut Assumptions) -> Result<Self, Error> {
        let report = Report::new(&input.name);
        if let Some(folder) = input.folder() {
            let images = images(report, folder, assumptions)?;
            return Self::choose(report, folder, images, assumptions);
        }
        let opened = match File::read(&input.storage(), input.path(), &input.name, input.length)? {
            Header::Image(file) => *file,
            Header::Refused { error, .. } => return Err(error),
            Header::Other => {
                let advice = "open the file of an image, or a folder";
                return Err(report.unsupported(Place::File, "this DICOM file holds no image", advice));
            }
        };
        let beside = input.is_at_path() && opened.frames.len() == 1 && !opened.series.is_empty();
        if !beside {
            return Ok(Self { files: vec![opened] });
        }
        let folder = input.path().parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        let images = images_in(report, folder)?;
        images.note_broken(assumptions);
        let Images { mut files, mut refused, .. } = images;
        files.retain(|file| file.series == opened.series);
        if let Some(index) = refused.iter().position(|(series, _)| *series == opened.series) {
            return Err(refused.swap_remove(index).1);
        }
        if files.len() > 1 {
            assumptions.push(format!("the {} files beside it of the same series were read, too", files.len() - 1));
        }
        Ok(Self { files: if files.is_empty() { vec![opened] } else { single(files, assumptions) } })
    }

    /// The series of a folder that is meant: in it the largest, below it the only one.
    fn choose(report: Report, folder: &Path, images: Images, assumptions: &mut Assumptions) -> Result<Self, Error> {
        images.note_broken(assumptions);
        let Images { files, mut broken, mut refused, below } = images;
        let mut groups = grouped(files);
        let slices = |group: &[File]| group.iter().map(|file| file.frames.len()).sum::<usize>();
        groups.sort_by_key(|group| std::cmp::Reverse(slices(group)));
        let named = |group: &[File]| {
            let File { path, description, series, .. } = &group[0];
            let described = if description.is_empty() { String::new() } else { format!("`{description}`, ") };
            let described = format!("{described}{} slices, ", slices(group));
            match path.strip_prefix(folder) {
                Ok(path) if below => format!("{described}series {}, such as {}", clip(series), display_name(path)),
                _ => format!("{described}{} among its files", clip(&group[0].short_name())),
            }
        };
        let listed = |groups: &[Vec<File>]| {
            const MOST_NAMES: usize = 8;
            let mut shown: Vec<_> = groups.iter().take(MOST_NAMES).map(|group| named(group)).collect();
            shown.extend((groups.len() > MOST_NAMES).then(|| format!("{} more", groups.len() - MOST_NAMES)));
            shown.join("; ")
        };
        let advice = "name a file of the one that is wanted instead of the folder";
        match &groups[..] {
            [] if refused.is_empty() && !broken.is_empty() => return Err(broken.swap_remove(0)),
            [] if refused.is_empty() => {
                return Err(report.unsupported(
                    Place::File,
                    "the DICOM files in this folder hold no images, nor do those below",
                    "give the folder with the slices",
                ));
            }
            [] => return Err(refused.swap_remove(0).1),
            [_, _, ..] if below => {
                let problem = format!("there are {} series below the folder: {}", groups.len(), listed(&groups));
                let advice = "give the folder of the one that is wanted, or one of its files";
                return Err(report.unsupported(Place::File, problem, advice));
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
            [first, ..] if below => {
                assumptions.push(format!("the one series below the folder was taken ({})", named(first)));
            }
            _ => {}
        }
        let chosen = groups.swap_remove(0);
        // A slice of it that is of a kind that is not read would be missing.
        if let Some(index) = refused.iter().position(|(series, _)| *series == chosen[0].series) {
            return Err(refused.swap_remove(index).1);
        }
        if let Some((_, error)) = refused.first() {
            assumptions.push(format!("{} files of other series were left out, such as {error}", refused.len()));
        }
        Ok(Self { files: single(chosen, assumptions) })
    }

    /// Leaves out the few files that are of another size or type than most, such as scouts.
    pub fn leave_out_unlike(&mut self, assumptions: &mut Assumptions) {
        let mut kinds: HashMap<String, usize> = HashMap::new();
        for file in &self.files {
            *kinds.entry(file.kind()).or_default() += 1;
        }
        let Some((usual, count)) = kinds.into_iter().max_by_key(|(_, count)| *count) else { return };
        let all = self.files.len();
        if count == all || 2 * count <= all {
            return;
        }
        let unlike = self.files.iter().find(|file| file.kind() != usual).map(File::short_name).unwrap_or_default();
        self.files.retain(|file| file.kind() == usual);
        let fact = format!("left out: {} files of another size or type than the others, such as {unlike}", all - count);
        assumptions.push(fact);
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
                        first.short_name(),
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

    /// The frames of all files.
    pub fn slices(&self) -> Vec<Slice<'_>> {
        let frames = self.files.iter().enumerate().flat_map(|(number, file)| {
            file.frames.iter().enumerate().map(move |(index, frame)| (file, [number, index], frame))
        });
        let slice = |(file, index, frame): (_, _, &Frame)| {
            let Frame { position, orientation, rescale, times } = *frame;
            Slice { file, index, position, orientation, rescale, times }
        };
        frames.map(slice).collect()
    }
}

/// The files, grouped by series; files without a series are grouped by folder.
fn grouped(files: Vec<File>) -> Vec<Vec<File>> {
    let mut numbers: HashMap<(String, Option<PathBuf>), usize> = HashMap::new();
    let mut groups: Vec<Vec<File>> = Vec::new();
    for file in files {
        let folder = file.series.is_empty().then(|| file.path.parent().map(Path::to_owned)).flatten();
        let number = *numbers.entry((file.series.clone(), folder)).or_insert(groups.len());
        if number == groups.len() {
            groups.push(Vec::new());
        }
        groups[number].push(file);
    }
    groups
}

/// The files without those whose image is there already, by its identifier.
fn single(mut files: Vec<File>, assumptions: &mut Assumptions) -> Vec<File> {
    let before = files.len();
    let mut seen = HashSet::new();
    files.retain(|file| file.instance.is_empty() || seen.insert(file.instance.clone()));
    if files.len() < before {
        let count = before - files.len();
        assumptions.push(format!("left out: {count} files whose image is in another one, too, by its instance UID"));
    }
    files
}

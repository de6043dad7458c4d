//! TIFF files whose pages are the slices of a volume, or numbered files of one page each, perhaps a folder of them.

mod decoder;
mod folder;
mod ome;
mod page;
mod patched;
mod selection;
mod series;
mod spacing;

use std::borrow::Cow;
use std::path::PathBuf;

use self::page::Pages;
use self::selection::Selection;
use self::series::series;
use crate::error::{Error, Place, Report};
use crate::folder::has_tiff;
use crate::formats::{self, Format};
use crate::input::{Input, display_name, file_name};
use crate::labels::Labels;
use crate::memory;
use crate::options::{OpenOptions, Part};
use crate::placement::unoriented;
use crate::reader::VolumeReader;
use crate::samples::{Endian, VoxelBuffer};
use crate::source::{Assumptions, Source};
use crate::storage::Storage;
use crate::stream;
use crate::volume::Volume;

/// The reader of `.tif` and `.tiff` files.
pub(crate) struct Stack;

/// Samples come decoded, in the machine's order.
const NATIVE: Endian = if cfg!(target_endian = "big") { Endian::Big } else { Endian::Little };

impl VolumeReader for Stack {
    fn format(&self) -> &'static Format {
        &formats::STACK
    }

    fn recognises(&self, input: &Input) -> bool {
        self.format().begins(&input.head) || input.folder().is_some_and(has_tiff)
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Array, Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let mut assumptions = Assumptions::default();
        let files = files(input, &mut assumptions)?;
        let first = &files[0];
        let selection = Selection::of(report, &first.notes, first.count, options, &mut assumptions)?;
        // Several files have a page each.
        let slices = selection.count * files.len() as u64;
        let dimensions = [first.first.width, first.first.height, u32::try_from(slices).unwrap_or(u32::MAX)];
        let sample = first.first.sample;
        let bytes = stream::byte_count(dimensions, sample.size())
            .map_err(|problem| report.invalid(Place::File, problem, "get the file again, or write it anew"))?;
        let count = bytes / sample.size() as u64;
        memory::check(report, count * sample.stored_size() as u64, options.max_bytes)?;
        let capacity = usize::try_from(count).unwrap_or(usize::MAX);
        let mut voxels = VoxelBuffer::reserve(report, sample, NATIVE, capacity)?;
        for file in &files {
            file.read(selection, &mut voxels)?;
        }
        note(&files, &mut assumptions);
        assumptions.push(unoriented());
        assumptions.extend(sample.rounding_note());
        let spacing = first.notes.spacing(options, &mut assumptions);
        let name = input.name.clone();
        let mut volume = Volume::of_samples(name, dimensions, spacing, voxels.into_voxels(), sample)?;
        let encoding = first.encoding.clone();
        if let Some([offset, factor]) = first.notes.calibration() {
            assumptions.push(format!("values are samples times {factor} and {offset}, by ImageJ's calibration"));
            let [offset, factor] =
                [offset + factor * f64::from(sample.value_offset()), factor].map(|value| value as f32);
            volume = volume.with_value_mapping(factor, offset)?;
        }
        if first.palette
            && let Some(labels) = Labels::of_palette(&first.colors, &volume)
        {
            assumptions.set_labels(labels);
        }
        let sample_type = sample.name().to_owned();
        Ok(volume.with_source(Source { format: self.format().name, sample_type, encoding, assumptions }))
    }
}

/// The file itself where it has several pages, else it and its numbered neighbours; of a folder, its slices. Never empty.
fn files<'a>(input: &'a Input, assumptions: &mut Assumptions) -> Result<Vec<Pages<'a>>, Error> {
    let scan = |path: PathBuf| {
        let name = display_name(&path);
        Pages::scan(Storage::Disk(Cow::Owned(path.clone())), path, name)
    };
    let (opened, paths) = if let Some(folder) = input.folder() {
        let paths = folder::slices(Report::new(&input.name), folder, assumptions)?;
        (scan(paths[0].clone())?, paths)
    } else {
        let opened = Pages::scan(input.storage(), input.path().to_owned(), input.name.clone())?;
        let alone = opened.count > 1 || input.folder_beside().is_none();
        let paths = if alone { Vec::new() } else { series(input.path()) };
        (opened, paths)
    };
    if paths.len() <= 1 {
        return Ok(vec![opened]);
    }
    let mut files = Vec::new();
    for path in paths {
        let file = scan(path)?;
        if file.count != 1 || file.first != opened.first {
            let (found, expected) = (file.first.describe(), opened.first.describe());
            return Err(Report::new(&file.name).invalid(
                Place::File,
                format!(
                    "{} page(s) of {found}, and its numbered neighbour {} has one of {expected}",
                    file.count,
                    file_name(&opened.path)
                ),
                "put only the slices of one volume into a folder under such names",
            ));
        }
        files.push(file);
    }
    Ok(files)
}

fn note(files: &[Pages], assumptions: &mut Assumptions) {
    if let [first, .., last] = files {
        let (count, first, last) = (files.len(), file_name(&first.path), file_name(&last.path));
        assumptions.push(format!("the data was put together from {count} files, {first} to {last}"));
    }
    let thumbnails = files.iter().map(|file| file.thumbnails).sum::<u64>();
    if thumbnails > 0 {
        assumptions.push(format!("{thumbnails} smaller copies of pages were left unread"));
    }
    if files.iter().any(|file| file.white_is_zero) {
        assumptions.push("the file's 0 is meant to be white: values were kept as they are".to_owned());
    }
    if files.iter().any(|file| file.palette) {
        let fact = "values are indices of a palette of colours: they were kept as numbers";
        assumptions.push(fact.to_owned());
    }
}

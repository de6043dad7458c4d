//! TIFF files whose pages are the slices of a volume, or numbered files of one page each, perhaps a folder of them.

mod folder;
mod page;
mod selection;
mod series;
mod spacing;

use std::path::{Path, PathBuf};

pub(crate) use self::folder::has_tiff;
use self::page::Pages;
use self::selection::Selection;
use self::series::series;
use crate::error::{Error, Place, Report};
use crate::input::{Input, display_name, file_name};
use crate::memory;
use crate::open::{OpenOptions, Part, VolumeReader};
use crate::placement::UNORIENTED;
use crate::samples::{Endian, VoxelBuffer};
use crate::stream;
use crate::volume::{Source, Volume};

/// The reader of `.tif` and `.tiff` files.
pub(crate) struct Stack;

/// Samples come decoded, in the machine's order.
const NATIVE: Endian = if cfg!(target_endian = "big") { Endian::Big } else { Endian::Little };

impl VolumeReader for Stack {
    fn name(&self) -> &'static str {
        "TIFF stack"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &[".tif", ".tiff"]
    }

    fn recognises(&self, head: &[u8], path: &Path) -> bool {
        [b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"].iter().any(|magic| head.starts_with(*magic))
            || head.is_empty() && has_tiff(path)
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Array, Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let mut assumptions = Vec::new();
        let files = files(input, &mut assumptions)?;
        let first = &files[0];
        let selection = Selection::of(report, first, options, &mut assumptions)?;
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
        assumptions.push(UNORIENTED.to_owned());
        assumptions.extend(sample.rounding_note());
        let spacing = first.notes.spacing(&mut assumptions);
        let name = input.name.clone();
        let mut volume = Volume::of_samples(name, dimensions, spacing, voxels.into_voxels(), sample)?;
        let encoding = first.encoding.clone();
        volume.source = Source { format: self.name(), sample_type: sample.name().to_owned(), encoding, assumptions };
        Ok(volume)
    }
}

/// The file itself where it has several pages, else it and its numbered neighbours; of a folder, its slices. Never empty.
fn files(input: &Input, assumptions: &mut Vec<String>) -> Result<Vec<Pages>, Error> {
    let scan = |path: PathBuf| {
        let name = display_name(&path);
        Pages::scan(path, name)
    };
    let (opened, paths) = if input.is_folder() {
        let paths = folder::slices(Report::new(&input.name), input.path, assumptions)?;
        (scan(paths[0].clone())?, paths)
    } else {
        let opened = Pages::scan(input.file().to_owned(), input.name.clone())?;
        let paths = if opened.count > 1 { Vec::new() } else { series(input.path) };
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

fn note(files: &[Pages], assumptions: &mut Vec<String>) {
    if let [first, .., last] = files {
        let (count, first, last) = (files.len(), file_name(&first.path), file_name(&last.path));
        assumptions.push(format!("the data was put together from {count} files, {first} to {last}"));
    }
    let thumbnails = files.iter().map(|file| file.thumbnails).sum::<u64>();
    if thumbnails > 0 {
        assumptions.push(format!("{thumbnails} smaller copies of pages were left unread"));
    }
    if files.iter().any(|file| file.first.inverted) {
        assumptions.push("the file's white is 0: its samples were inverted, so that white is the largest".to_owned());
    }
}

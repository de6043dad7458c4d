//! TIFF files whose pages are the slices of a volume, or numbered files of one page each.

mod page;
mod series;
mod spacing;

use std::path::Path;

use self::page::Pages;
use self::series::series;
use crate::error::{Error, Place, Report};
use crate::input::{Input, display_name};
use crate::memory;
use crate::open::{OpenOptions, VolumeReader};
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

    fn recognises(&self, head: &[u8], _path: &Path) -> bool {
        [b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"].iter().any(|magic| head.starts_with(*magic))
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let files = files(input)?;
        let first = &files[0];
        let mut assumptions = Vec::new();
        check_kind(report, first, &mut assumptions)?;
        let slices = files.iter().map(|file| file.count).sum::<u64>();
        let dimensions = [first.first.width, first.first.height, u32::try_from(slices).unwrap_or(u32::MAX)];
        let sample = first.first.sample;
        let bytes = stream::byte_count(dimensions, sample.size())
            .map_err(|problem| report.invalid(Place::File, problem, "get the file again, or write it anew"))?;
        let count = bytes / sample.size() as u64;
        memory::check(report, count * sample.stored_size() as u64, options.max_bytes)?;
        let capacity = usize::try_from(count).unwrap_or(usize::MAX);
        let mut voxels = VoxelBuffer::reserve(report, sample, NATIVE, capacity)?;
        for file in &files {
            file.read(&mut voxels)?;
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

/// The file itself where it has several pages, else it and its numbered neighbours. Never empty.
fn files(input: &Input) -> Result<Vec<Pages>, Error> {
    let opened = Pages::scan(input.file().to_owned(), input.name.clone())?;
    if opened.count > 1 {
        return Ok(vec![opened]);
    }
    let paths = series(input.path);
    if paths.len() == 1 {
        return Ok(vec![opened]);
    }
    let mut files = Vec::new();
    for path in paths {
        let name = display_name(&path);
        let file = Pages::scan(path, name)?;
        if file.count != 1 || file.first != opened.first {
            let (found, expected) = (file.first.describe(), opened.first.describe());
            return Err(Report::new(&file.name).invalid(
                Place::File,
                format!(
                    "{} page(s) of {found}, and its numbered neighbour {} has one of {expected}",
                    file.count, opened.name
                ),
                "put only the slices of one volume into a folder under such names",
            ));
        }
        files.push(file);
    }
    Ok(files)
}

/// Fails where ImageJ says that the pages are more than the slices of one volume.
fn check_kind(report: Report, file: &Pages, assumptions: &mut Vec<String>) -> Result<(), Error> {
    let [images, channels, slices, frames] =
        ["images", "channels", "slices", "frames"].map(|name| file.notes.count(name));
    if channels > 1 || (slices > 1 && frames > 1) {
        return Err(report.unsupported(
            Place::File,
            format!("the pages are {channels} channels of {slices} slices at {frames} points in time"),
            "pick out one channel and point in time first, for example by Image > Duplicate in ImageJ",
        ));
    }
    if images > 1 && file.count == 1 {
        return Err(report.unsupported(
            Place::File,
            format!("ImageJ wrote {images} images behind one page, as it does beyond 4 GiB"),
            "write it as BigTIFF, for example by Bio-Formats, or as several files",
        ));
    }
    if frames > 1 {
        assumptions.push("the pages are points in time, and were taken for slices".to_owned());
    }
    Ok(())
}

fn note(files: &[Pages], assumptions: &mut Vec<String>) {
    if let [first, .., last] = files {
        let (count, first, last) = (files.len(), &first.name, &last.name);
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

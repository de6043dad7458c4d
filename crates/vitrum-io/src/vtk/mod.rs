//! Legacy VTK files: a few header lines, and the values behind them as text or big-endian bytes.
//!
//! The format: <https://docs.vtk.org/en/latest/vtk_file_formats/vtk_legacy_file_format.html>.

mod blocks;
mod fields;
mod grid;
mod header;

use std::io::{Seek, SeekFrom};

use self::header::Header;
use crate::components::{self, Components};
use crate::error::{Error, Report};
use crate::formats::{self, Format};
use crate::input::Input;
use crate::memory;
use crate::options::{OpenOptions, Part};
use crate::reader::VolumeReader;
use crate::samples::{Endian, VoxelBuffer};
use crate::source::Source;
use crate::stored::Stored;
use crate::stream;
use crate::text;
use crate::volume::Volume;

/// The reader of `.vtk` files.
pub(crate) struct Vtk;

impl VolumeReader for Vtk {
    fn format(&self) -> &'static Format {
        &formats::VTK
    }

    fn recognises(&self, input: &Input) -> bool {
        input.head.get(..14).is_some_and(|head| head.eq_ignore_ascii_case(b"# vtk DataFile"))
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Array]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let header = Header::read(input.open()?, input.length, options, report)?;
        let voxels = read_data(&header, input, options)?;
        let (sample, ..) = components::decoded_as(header.sample, Endian::Big, header.components);
        let volume = header.placement.volume(&input.name, header.dimensions, voxels, sample)?;
        let volume = volume.with_source(Source {
            format: self.format().name,
            sample_type: Components::named(header.components, header.sample),
            encoding: if header.binary { "binary, big-endian" } else { "ascii" }.to_owned(),
            assumptions: header.assumptions,
        });
        Ok(volume)
    }
}

fn read_data(header: &Header, input: &Input, options: &OpenOptions) -> Result<Stored, Error> {
    let report = Report::new(&input.name);
    let unreadable = |error| report.unreadable(error);
    let start = header.length;
    let (sample, endian, size) = components::decoded_as(header.sample, Endian::Big, header.components);
    let there = input.length.saturating_sub(start);
    let count = header.data_bytes / size as u64;
    if header.binary {
        stream::check_length(report, header.data_bytes, start, there)?;
    } else {
        text::check_text_length(report, count, start, there)?;
    }
    memory::check(report, count * components::stored_bytes(sample, header.components), options.max_bytes)?;
    let count = usize::try_from(count).unwrap_or(usize::MAX);
    let mut voxels = VoxelBuffer::reserve(report, sample, endian, count)?;
    let mut reader = input.open()?;
    reader.seek(SeekFrom::Start(start)).map_err(unreadable)?;
    if header.binary {
        components::fill(report, &mut voxels, &mut reader, count, size, header.components)?;
    } else {
        let numbers = (header.sample, header.components);
        components::read_numbers(report, &mut voxels, &mut reader, count, numbers, false)?;
    }
    // Other parts of the file begin with a keyword, and were read before.
    if !header.binary
        && let Some(word) = text::next_word(&mut reader).map_err(unreadable)?
        && !word.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_')
    {
        return Err(text::surplus(report, &word, count));
    }
    Ok(voxels.into_voxels())
}

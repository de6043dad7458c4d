//! NRRD, "nearly raw raster data": a text header, with the data behind it or in files beside it.
//!
//! The format: <https://teem.sourceforge.net/nrrd/format.html>.

mod components;
mod data_files;
mod description;
pub(crate) mod encodings;
mod header;
mod samples;
mod segments;
mod space;
mod write;

pub use samples::Samples;
pub use write::{Lattice, check_nrrd_writable, write_nrrd};

use std::io::{self, BufRead, Read, Seek, SeekFrom};

use self::description::{ByteSkip, Description, Encoding};
use self::header::Header;
use crate::components::{self as several, Components};
use crate::detached::{DataFile, DataFiles};
use crate::error::{Error, Place, Report};
use crate::formats::{self, Format};
use crate::input::Input;
use crate::options::{OpenOptions, Part};
use crate::packing::Members;
use crate::reader::VolumeReader;
use crate::samples::VoxelBuffer;
use crate::source::{Assumptions, Source};
use crate::stored::Stored;
use crate::stream;
use crate::text;
use crate::time::Times;
use crate::volume::Volume;

/// The reader of `.nrrd` and `.nhdr` files.
pub(crate) struct Nrrd;

impl VolumeReader for Nrrd {
    fn format(&self) -> &'static Format {
        &formats::NRRD
    }

    fn recognises(&self, input: &Input) -> bool {
        self.format().begins(&input.head)
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Array, Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let mut header = Header::read(input.open()?, report)?;
        let mut description = Description::new(&mut header, options, report)?;
        header.segments.tell(&mut description.assumptions);
        std::mem::take(&mut header.left_out).tell(&mut description.assumptions);
        let voxels = read_data(&header, &mut description, input, options)?;
        let (sample, ..) = several::decoded_as(description.sample, description.endian, description.components);
        let volume = description.placement.volume(&input.name, description.dimensions, voxels, sample)?;
        let volume = volume.with_source(Source {
            format: self.format().name,
            sample_type: Components::named(description.components, description.sample),
            encoding: description.sample.coding(description.encoding.name(), description.endian),
            assumptions: description.assumptions,
        });
        Ok(volume)
    }
}

fn read_data(
    header: &Header,
    description: &mut Description,
    input: &Input,
    options: &OpenOptions,
) -> Result<Stored, Error> {
    let report = Report::new(&input.name);
    let files = data_files::locate(header, description, input, report)?;
    // A file of its own has that point alone.
    if header.several_files() {
        description.times = Times { count: 1, chosen: 0 };
    }
    let (sample, endian, _) = several::decoded_as(description.sample, description.endian, description.components);
    let stored = several::stored_bytes(sample, description.components);
    let data = DataFiles { files: &files, count: description.voxel_count(), sample, endian, stored };
    let mut notes = Assumptions::default();
    let check = |file: &DataFile, share| check_possible(file, description, share);
    let append = |file: &DataFile, voxels: &mut _, count| read_file(file, description, voxels, count);
    if let ([file], Encoding::Raw, None) = (files.as_slice(), description.encoding, description.components) {
        check(file, data.count)?;
        let mut reader = file.open()?;
        skip_lines(report, &mut reader, description.line_skip)?;
        let bytes = data.count * description.voxel_size as u64;
        let (before, start, _) = raw_start(file, description, &mut reader, bytes)?;
        let start = start.saturating_add(before);
        if let Some(paged) = file.contiguous(start, description.dimensions, (sample, endian)).open(options)? {
            return Ok(paged);
        }
    }
    let voxels = data.read(report, options, &mut notes, check, append)?;
    description.assumptions.extend(notes);
    Ok(voxels)
}

/// Fails where a file is too short for its share of voxels, however its bytes may be spread.
fn check_possible(file: &DataFile, description: &Description, share: u64) -> Result<(), Error> {
    let report = Report::new(&file.name);
    let share = share.saturating_mul(description.times.count);
    let bytes = share.saturating_mul(description.voxel_size as u64);
    let there = file.available();
    match description.encoding {
        Encoding::Gzip => stream::check_deflate(report, bytes, there),
        Encoding::Raw => stream::check_length(report, bytes, file.start, there),
        Encoding::Hex => stream::check_length(report, bytes.saturating_mul(2), file.start, there),
        Encoding::Text => text::check_text_length(report, share, file.start, there),
    }
}

/// Where a file's raw data lies: the bytes of points in time before the chosen one, whose voxels take `bytes`, the byte of the first point in time, and
/// the bytes behind all of them. `reader` is behind the lines that are skipped.
fn raw_start(
    file: &DataFile,
    description: &Description,
    reader: &mut impl Seek,
    bytes: u64,
) -> Result<(u64, u64, u64), Error> {
    let report = Report::new(&file.name);
    let (before, all) = description.times.spans(report, Place::File, bytes)?;
    let here = reader.stream_position().map_err(|error| report.unreadable(error))?;
    let start = match description.byte_skip {
        ByteSkip::Forward(skip) => here.saturating_add(skip),
        // A file too short for that is told so by the check below.
        ByteSkip::FromEnd => file.length.saturating_sub(all).max(here),
    };
    let there = file.length.saturating_sub(start);
    stream::check_length(report, all, start, there)?;
    Ok((before, start, there - all))
}

/// Decodes a file's `count` voxels, and returns how many bytes of raw data it has behind them.
///
/// Such bytes may be padding or another program's. Surplus in any other encoding is an error: nothing
/// pads inside a compressed stream or a list of numbers.
fn read_file(file: &DataFile, description: &Description, voxels: &mut VoxelBuffer, count: usize) -> Result<u64, Error> {
    let report = Report::new(&file.name);
    let unreadable = |error| report.unreadable(error);
    let mut reader = file.open()?;
    skip_lines(report, &mut reader, description.line_skip)?;
    let (size, components) = (description.voxel_size, description.components);
    let bytes = count as u64 * size as u64;
    let times = description.times;
    let (before, all) = times.spans(report, Place::File, bytes)?;
    match description.encoding {
        Encoding::Raw => {
            let (before, start, behind) = raw_start(file, description, &mut reader, bytes)?;
            reader.seek(SeekFrom::Start(start + before)).map_err(unreadable)?;
            several::fill(report, voxels, &mut reader, count, size, components)?;
            return Ok(behind);
        }
        Encoding::Gzip => {
            if description.byte_skip == ByteSkip::FromEnd {
                // The end is known once all is inflated, so that it is inflated twice.
                let length = io::copy(&mut Members::new(reader), &mut io::sink());
                let length = length.map_err(|error| stream::damaged(report, 0, all, error))?;
                let mut again = file.open()?;
                skip_lines(report, &mut again, description.line_skip)?;
                let mut inflated = Members::new(again);
                stream::check_length(report, all, 0, length)?;
                stream::skip(report, &mut inflated, length - all + before)?;
                several::fill(report, voxels, &mut inflated, count, size, components)?;
                return Ok(0);
            }
            let mut inflated = Members::new(reader);
            skip_bytes(report, &mut inflated, description.byte_skip)?;
            stream::skip(report, &mut inflated, before)?;
            several::fill(report, voxels, &mut inflated, count, size, components)?;
            if times.is_last() {
                stream::refuse_surplus(report, &mut inflated, bytes)?;
            }
        }
        Encoding::Hex => {
            skip_bytes(report, &mut reader, description.byte_skip)?;
            let mut decoded = encodings::HexReader::new(reader);
            stream::skip(report, &mut decoded, before)?;
            several::fill(report, voxels, &mut decoded, count, size, components)?;
            if times.is_last() {
                stream::refuse_surplus(report, &mut decoded, bytes)?;
            }
        }
        Encoding::Text => {
            skip_bytes(report, &mut reader, description.byte_skip)?;
            text::skip_numbers(report, &mut reader, before / description.sample.size() as u64)?;
            let numbers = (description.sample, components);
            several::read_numbers(report, voxels, &mut reader, count, numbers, times.is_last())?;
        }
    }
    Ok(0)
}

fn skip_lines(report: Report, reader: &mut impl BufRead, lines: u64) -> Result<(), Error> {
    for line in 0..lines {
        let skipped = reader.skip_until(b'\n').map_err(|error| report.unreadable(error))?;
        if skipped == 0 {
            return Err(report.invalid(
                Place::File,
                format!("the header skips {lines} lines of data, {line} are there"),
                "correct `line skip` in the header",
            ));
        }
    }
    Ok(())
}

fn skip_bytes(report: Report, reader: &mut impl Read, skip: ByteSkip) -> Result<(), Error> {
    // Skipping from the end is refused with the encodings that come here.
    let ByteSkip::Forward(bytes) = skip else { return Ok(()) };
    let skipped = io::copy(&mut reader.take(bytes), &mut io::sink());
    match skipped {
        Ok(skipped) if skipped == bytes => Ok(()),
        Ok(skipped) => Err(report.invalid(
            Place::File,
            format!("the header skips {bytes} bytes of data, {skipped} are there"),
            "correct `byte skip` in the header",
        )),
        Err(error) => Err(stream::damaged(report, 0, bytes, error)),
    }
}

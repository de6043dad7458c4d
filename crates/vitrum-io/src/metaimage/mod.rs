//! MetaImage, the format of ITK: a text header, with the data behind it or in files beside it.
//!
//! The format: <https://itk.org/Wiki/ITK/MetaIO/Documentation>.

mod data_files;
mod description;
mod header;
mod space;

use std::io::{BufRead, Read};

use flate2::bufread::ZlibDecoder;

use self::description::{Description, Encoding};
use self::header::Header;
use crate::components::{self, Components};
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
use crate::text::{self, check_text_length};
use crate::time::Times;
use crate::volume::Volume;

/// The reader of `.mha` and `.mhd` files.
pub(crate) struct MetaImage;

impl VolumeReader for MetaImage {
    fn format(&self) -> &'static Format {
        &formats::METAIMAGE
    }

    fn recognises(&self, input: &Input) -> bool {
        header::recognises(&input.head)
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Array, Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let mut header = Header::read(input.open()?, report)?;
        let mut description = Description::new(&header, options, report)?;
        std::mem::take(&mut header.left_out).tell(&mut description.assumptions);
        let voxels = read_data(&header, &mut description, input, options)?;
        let (sample, ..) = components::decoded_as(description.sample, description.endian, description.components);
        let volume = description.placement.volume(&input.name, description.dimensions, voxels, sample)?;
        let volume = volume.with_source(Source {
            format: self.format().name,
            sample_type: Components::named(description.components, description.sample),
            encoding: match description.encoding {
                Encoding::Text => Encoding::Text.name().to_owned(),
                encoding => description.sample.coding(encoding.name(), description.endian),
            },
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
    let (sample, endian, _) = components::decoded_as(description.sample, description.endian, description.components);
    let stored = components::stored_bytes(sample, description.components);
    let data = DataFiles { files: &files, count: description.voxel_count(), sample, endian, stored };
    let mut notes = Assumptions::default();
    let check = |file: &DataFile, share| check_possible(file, description, share);
    let append = |file: &DataFile, voxels: &mut _, count| read_file(file, description, voxels, count);
    if let ([file], Encoding::Raw, None) = (files.as_slice(), description.encoding, description.components) {
        check(file, data.count)?;
        let bytes = data.count * description.voxel_size as u64;
        let (before, _) = description.times.spans(report, Place::File, bytes)?;
        let start = file.start.saturating_add(before);
        if let Some(paged) = file.contiguous(start, description.dimensions, (sample, endian)).open(options)? {
            return Ok(paged);
        }
    }
    let voxels = data.read(report, options, &mut notes, check, append)?;
    notes.extend(size_note(header, description, &files));
    description.assumptions.extend(notes);
    Ok(voxels)
}

/// Fails where a file is too short for its share of voxels.
fn check_possible(file: &DataFile, description: &Description, share: u64) -> Result<(), Error> {
    let report = Report::new(&file.name);
    let share = share.saturating_mul(description.times.count);
    let bytes = share.saturating_mul(description.voxel_size as u64);
    let there = file.available();
    match description.encoding {
        Encoding::Deflate => stream::check_deflate(report, bytes, there),
        Encoding::Raw => stream::check_length(report, bytes, file.start, there),
        Encoding::Text => check_text_length(report, share, file.start, there),
    }
}

/// Decodes a file's `count` voxels, and returns how many bytes of raw data it has behind them.
fn read_file(file: &DataFile, description: &Description, voxels: &mut VoxelBuffer, count: usize) -> Result<u64, Error> {
    let report = Report::new(&file.name);
    let unreadable = |error| report.unreadable(error);
    let mut reader = file.open()?;
    let (size, components) = (description.voxel_size, description.components);
    let bytes = count as u64 * size as u64;
    let times = description.times;
    let (before, all) = times.spans(report, Place::File, bytes)?;
    match description.encoding {
        Encoding::Raw => {
            stream::skip(report, &mut reader, before)?;
            components::fill(report, voxels, &mut reader, count, size, components)?;
            return Ok(file.available().saturating_sub(all));
        }
        Encoding::Deflate => {
            let gzipped = reader.fill_buf().map_err(unreadable)?.starts_with(&[0x1f, 0x8b]);
            let mut inflated: Box<dyn Read> =
                if gzipped { Box::new(Members::new(reader)) } else { Box::new(ZlibDecoder::new(reader)) };
            stream::skip(report, &mut inflated, before)?;
            components::fill(report, voxels, &mut inflated, count, size, components)?;
            if times.is_last() {
                stream::refuse_surplus(report, &mut inflated, bytes)?;
            }
        }
        Encoding::Text => {
            text::skip_numbers(report, &mut reader, before / description.sample.size() as u64)?;
            let numbers = (description.sample, components);
            components::read_numbers(report, voxels, &mut reader, count, numbers, times.is_last())?;
        }
    }
    Ok(0)
}

/// A wrong `CompressedDataSize` does no harm, since the stream knows its own end.
fn size_note(header: &Header, description: &Description, files: &[DataFile]) -> Option<String> {
    let stated: u64 = header.fields.get("CompressedDataSize")?.text.parse().ok()?;
    let there: u64 = files.iter().map(DataFile::available).sum();
    (description.encoding == Encoding::Deflate && stated != there && files.len() == 1)
        .then(|| format!("the header says {stated} bytes of compressed data, {there} are there: all were read"))
}

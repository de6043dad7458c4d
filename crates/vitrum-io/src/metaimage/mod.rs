//! MetaImage, the format of ITK: a text header, with the data behind it or in files beside it.
//!
//! The format: <https://itk.org/Wiki/ITK/MetaIO/Documentation>.

mod data_files;
mod description;
mod header;
mod space;

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::Path;

use flate2::bufread::{MultiGzDecoder, ZlibDecoder};

use self::description::{Description, Encoding};
use self::header::Header;
use crate::data_file::{DataFile, DataFiles};
use crate::error::{Error, Report};
use crate::input::Input;
use crate::open::{OpenOptions, VolumeReader};
use crate::samples::VoxelBuffer;
use crate::stream;
use crate::text::{check_text_length, read_text};
use crate::volume::{Source, Volume};
use crate::voxels::Voxels;

/// The reader of `.mha` and `.mhd` files.
pub(crate) struct MetaImage;

impl VolumeReader for MetaImage {
    fn name(&self) -> &'static str {
        "MetaImage"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &[".mha", ".mhd"]
    }

    fn recognises(&self, head: &[u8], _path: &Path) -> bool {
        header::recognises(head)
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let header = Header::read(input.open()?, report)?;
        let mut description = Description::new(&header, report)?;
        let voxels = read_data(&header, &mut description, input, options)?;
        let mut volume =
            description.placement.volume(&input.name, description.dimensions, voxels, description.sample)?;
        volume.source = Source {
            format: self.name(),
            sample_type: description.sample.name().to_owned(),
            encoding: match (description.sample.size(), description.encoding) {
                (1, encoding) | (_, encoding @ Encoding::Text) => encoding.name().to_owned(),
                (_, encoding) => format!("{}, {}", encoding.name(), description.endian.name()),
            },
            assumptions: description.assumptions,
        };
        Ok(volume)
    }
}

fn read_data(
    header: &Header,
    description: &mut Description,
    input: &Input,
    options: &OpenOptions,
) -> Result<Voxels, Error> {
    let report = Report::new(&input.name);
    let files = data_files::locate(header, description, input, report)?;
    let Description { sample, endian, .. } = *description;
    let data = DataFiles { files: &files, count: description.voxel_count(), sample, endian };
    let mut notes = Vec::new();
    let check = |file: &DataFile, share| check_possible(file, description, share);
    let append = |file: &DataFile, voxels: &mut _, count| read_file(file, description, voxels, count);
    let voxels = data.read(report, options, &mut notes, check, append)?;
    notes.extend(size_note(header, description, &files));
    description.assumptions.extend(notes);
    Ok(voxels)
}

/// Fails where a file is too short for its share of voxels.
fn check_possible(file: &DataFile, description: &Description, share: u64) -> Result<(), Error> {
    let report = Report::new(&file.name);
    let bytes = share * description.sample.size() as u64;
    let there = file.length.saturating_sub(file.start);
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
    let mut reader = BufReader::new(File::open(&file.path).map_err(unreadable)?);
    reader.seek(SeekFrom::Start(file.start)).map_err(unreadable)?;
    let size = description.sample.size();
    let bytes = count as u64 * size as u64;
    match description.encoding {
        Encoding::Raw => {
            stream::fill(report, voxels, &mut reader, count, size)?;
            return Ok(file.length.saturating_sub(file.start).saturating_sub(bytes));
        }
        Encoding::Deflate => {
            let gzipped = reader.fill_buf().map_err(unreadable)?.starts_with(&[0x1f, 0x8b]);
            let mut inflated: Box<dyn Read> =
                if gzipped { Box::new(MultiGzDecoder::new(reader)) } else { Box::new(ZlibDecoder::new(reader)) };
            stream::fill(report, voxels, &mut inflated, count, size)?;
            stream::refuse_surplus(report, &mut inflated, bytes)?;
        }
        Encoding::Text => read_text(report, voxels, &mut reader, count, description.sample.name())?,
    }
    Ok(0)
}

/// A wrong `CompressedDataSize` does no harm, since the stream knows its own end.
fn size_note(header: &Header, description: &Description, files: &[DataFile]) -> Option<String> {
    let stated: u64 = header.fields.get("CompressedDataSize")?.text.parse().ok()?;
    let there: u64 = files.iter().map(|file| file.length.saturating_sub(file.start)).sum();
    (description.encoding == Encoding::Deflate && stated != there && files.len() == 1)
        .then(|| format!("the header says {stated} bytes of compressed data, {there} are there: all were read"))
}

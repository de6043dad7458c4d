//! VTK XML image data: a grid described in XML, with its arrays inside or appended.
//!
//! The format: <https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html>.

mod collection;
mod data;
mod description;
mod layout;
mod series;
mod xml;

pub(crate) use self::collection::Pvd;

use std::io::{BufRead, Read, Seek, SeekFrom};

use self::data::{Base64Reader, Block, BlockReader};
use self::description::{Coding, Description, Word};
use self::layout::Layout;
use crate::components::{self, Components};
use crate::error::{Error, Place, Report};
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

/// The reader of `.vti` files.
pub(crate) struct Vti;

impl VolumeReader for Vti {
    fn format(&self) -> &'static Format {
        &formats::VTI
    }

    fn recognises(&self, input: &Input) -> bool {
        input.head.windows(8).any(|window| window == b"<VTKFile")
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Array, Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        series::read(input, options)
    }
}

impl Vti {
    /// Reads one file, whatever lies beside it.
    fn read_alone(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let layout = Layout::read(input.open()?, report)?;
        let description = Description::new(&layout, input.length, options, report)?;
        let voxels = read_data(&description, input, options)?;
        let (sample, ..) = components::decoded_as(description.sample, description.endian, description.components);
        let volume = description.placement.volume(&input.name, description.dimensions, voxels, sample)?;
        let volume = volume.with_source(Source {
            format: self.format().name,
            sample_type: Components::named(description.components, description.sample),
            encoding: description.encoding(),
            assumptions: description.assumptions,
        });
        Ok(volume)
    }
}

fn read_data(description: &Description, input: &Input, options: &OpenOptions) -> Result<Stored, Error> {
    let report = Report::new(&input.name);
    let unreadable = |error| report.unreadable(error);
    let (count, bytes) = (description.voxel_count(), description.data_bytes);
    check_possible(description, report)?;
    let mut file = input.open()?;
    file.seek(SeekFrom::Start(description.start)).map_err(unreadable)?;
    let mut characters = file.take(description.length);
    let (sample, endian, size) = components::decoded_as(description.sample, description.endian, description.components);
    let memory =
        || memory::check(report, count * components::stored_bytes(sample, description.components), options.max_bytes);
    let reserve = || {
        let capacity = usize::try_from(count).unwrap_or(usize::MAX);
        let voxels = VoxelBuffer::reserve(report, sample, endian, capacity)?;
        Ok((voxels, capacity))
    };
    if description.coding == Coding::Text {
        memory()?;
        let (mut voxels, count) = reserve()?;
        let numbers = (description.sample, description.components);
        components::read_numbers(report, &mut voxels, &mut characters, count, numbers, true)?;
        return Ok(voxels.into_voxels());
    }
    let mut reader: Box<dyn BufRead> = match description.coding {
        Coding::Base64 => Box::new(Base64Reader::new(characters)),
        _ => Box::new(characters),
    };
    let mut data: Box<dyn Read> = if description.zlib {
        let blocks = read_blocks(description, report, &mut reader)?;
        Box::new(BlockReader::new(reader, blocks))
    } else {
        let [promised] = words::<1>(description, report, &mut reader)?;
        if promised != bytes {
            return Err(report.invalid(
                Place::Byte(description.start),
                format!("the array says to have {promised} bytes, and {count} voxels take {bytes}"),
                "correct `WholeExtent` or the array's type, or get the file again",
            ));
        }
        Box::new(reader)
    };
    memory()?;
    let (mut voxels, count) = reserve()?;
    components::fill(report, &mut voxels, &mut data, count, size, description.components)?;
    if description.zlib {
        stream::refuse_surplus(report, &mut data, bytes)?;
    }
    Ok(voxels.into_voxels())
}

/// Fails where the characters that are there cannot hold the data, however they are written.
fn check_possible(description: &Description, report: Report) -> Result<(), Error> {
    let Description { start, length, word, data_bytes, .. } = *description;
    // The size of a block header is checked once the header is read.
    let plain = if description.zlib { 0 } else { data_bytes } + word.size() as u64;
    match description.coding {
        Coding::Text => text::check_text_length(report, description.voxel_count(), start, length),
        Coding::Raw => stream::check_length(report, plain, start, length),
        Coding::Base64 => stream::check_length(report, plain.div_ceil(3).saturating_mul(4) - 2, start, length),
    }
}

/// The header of compressed data: the number of blocks, the size to which each inflates, the size of the last if it is smaller, and the
/// compressed size of each.
fn read_blocks(description: &Description, report: Report, reader: &mut dyn BufRead) -> Result<Vec<Block>, Error> {
    let Description { start, length, data_bytes, .. } = *description;
    let [count, full, last] = words::<3>(description, report, reader)?;
    let sizes = u128::from(count) * description.word.size() as u128;
    let last = if last == 0 { full } else { last };
    let inflated =
        u128::from(count.saturating_sub(1)) * u128::from(full) + u128::from(if count == 0 { 0 } else { last });
    if sizes > u128::from(length) || inflated != u128::from(data_bytes) {
        return Err(report.invalid(
            Place::Byte(start),
            format!("the array's {count} blocks inflate to {inflated} bytes, and its voxels take {data_bytes}"),
            "correct `WholeExtent` or the array's type, or get the file again",
        ));
    }
    let mut blocks = memory::reserve(report, usize::try_from(count).unwrap_or(usize::MAX))?;
    let mut total = 0_u64;
    for index in 0..count {
        let [compressed] = words::<1>(description, report, reader)?;
        total = total.saturating_add(compressed);
        blocks.push(Block { compressed, inflated: if index + 1 == count { last } else { full } });
    }
    stream::check_length(report, total, start, length)?;
    stream::check_deflate(report, data_bytes, total)?;
    Ok(blocks)
}

/// The next numbers of the data's header.
fn words<const COUNT: usize>(
    description: &Description,
    report: Report,
    reader: &mut dyn BufRead,
) -> Result<[u64; COUNT], Error> {
    let mut numbers = [0; COUNT];
    for number in &mut numbers {
        let mut bytes = [0; 8];
        let size = description.word.size();
        let word = &mut bytes[..size];
        reader.read_exact(word).map_err(|error| stream::damaged(report, 0, description.data_bytes, error))?;
        *number = match (description.word, description.endian) {
            (_, Endian::Little) => u64::from_le_bytes(bytes),
            (Word::U32, Endian::Big) => u64::from_be_bytes(bytes) >> 32,
            (Word::U64, Endian::Big) => u64::from_be_bytes(bytes),
        };
    }
    Ok(numbers)
}

//! Voxels without any header, described by the caller or by the file's name, such as `head_256x256x109_uint8.raw`.

use crate::error::{Error, Report};
use crate::formats::{self, Format};
use crate::input::Input;
use crate::memory;
use crate::options::OpenOptions;
use crate::packing::Packing;
use crate::paged::Contiguous;
use crate::placement::unoriented;
use crate::raw_layout::{RawLayout, dimensions, endian, sample_type};
use crate::reader::VolumeReader;
use crate::samples::{Endian, SampleType, VoxelBuffer};
use crate::source::{Assumptions, Source};
use crate::stream;
use crate::tolerance;
use crate::volume::Volume;

/// The reader of `.raw` and `.bin` files.
pub(crate) struct Raw;

impl VolumeReader for Raw {
    fn format(&self) -> &'static Format {
        &formats::RAW
    }

    /// Never recognises a file: the content of a raw file has no mark.
    fn recognises(&self, _input: &Input) -> bool {
        false
    }

    fn unpacks(&self) -> bool {
        true
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let mut assumptions = Assumptions::default();
        let layout = match options.raw {
            Some(layout) => layout,
            None => of_name(input, &mut assumptions)?,
        };
        let RawLayout { dimensions, sample, endian, skip } = layout;
        tolerance::note_unspaced(options, &mut assumptions);
        if endian.is_none() && sample.size() > 1 {
            assumptions.push("no byte order is said: little-endian was taken".to_owned());
        }
        let endian = endian.unwrap_or(Endian::Little);
        assumptions.extend(sample.rounding_note());
        assumptions.push(unoriented());
        let refuse = |problem: String| unknown_layout(input, problem);
        let bytes = stream::byte_count(dimensions, sample.size()).map_err(&refuse)?;
        // Voxels may begin like a packed file; the size tells.
        let packing = if skip.saturating_add(bytes) == input.length { Packing::Plain } else { input.packing };
        if packing == Packing::Plain && skip.saturating_add(bytes) != input.length {
            let [x, y, z] = dimensions;
            let behind = if skip > 0 { format!(" behind the {skip} skipped") } else { String::new() };
            let said = if options.raw.is_some() { "" } else { ", as the name says," };
            return Err(refuse(format!(
                "{x} x {y} x {z} voxels of {}{said} take {bytes} bytes{behind}, and {} are there",
                sample.name(),
                input.length.saturating_sub(skip)
            )));
        }
        let data = Contiguous { storage: input.storage(), name: &input.name, start: skip, dimensions, sample, endian };
        let paged = if packing == Packing::Plain { data.open(options)? } else { None };
        let voxels = match paged {
            Some(paged) => paged,
            None => read_data(input, options, layout, packing, bytes)?.into_voxels(),
        };
        let volume = Volume::of_samples(input.name.clone(), dimensions, [1.0; 3], voxels, sample)?;
        let encoding = sample.coding(packing.name(), endian);
        let source =
            Source { format: self.format().name, sample_type: sample.name().to_owned(), encoding, assumptions };
        Ok(volume.with_source(source))
    }
}

/// The layout that the file's name says, perhaps completed by the file's size.
fn of_name(input: &Input, assumptions: &mut Assumptions) -> Result<RawLayout, Error> {
    let refuse = |problem: &str| Err(unknown_layout(input, problem));
    let said = Said::new(&input.file_name());
    let Some(dimensions) = said.dimensions else {
        return refuse("the file has no header, and its name says no dimensions");
    };
    assumptions.push("the file has no header: its dimensions and type were taken from its name".to_owned());
    let sample = match said.sample {
        Some(sample) => sample,
        None if input.packing == Packing::Plain && stream::byte_count(dimensions, 1) == Ok(input.length) => {
            assumptions.push("the name says no type: uint8 was taken, which fits the size".to_owned());
            SampleType::U8
        }
        None => return refuse("the file has no header, and its name says no sample type"),
    };
    Ok(RawLayout { dimensions, sample, endian: said.endian, skip: 0 })
}

fn unknown_layout(input: &Input, problem: impl Into<String>) -> Error {
    Error::UnknownLayout { file: input.name.clone(), problem: problem.into() }
}

fn read_data(
    input: &Input,
    options: &OpenOptions,
    layout: RawLayout,
    packing: Packing,
    bytes: u64,
) -> Result<VoxelBuffer, Error> {
    let report = Report::new(&input.name);
    let size = layout.sample.size();
    let count = bytes / size as u64;
    stream::check_ratio(report, layout.skip.saturating_add(bytes), input.length, packing.ratio())?;
    memory::check(report, count * layout.sample.stored_size() as u64, options.max_bytes)?;
    let count = usize::try_from(count).unwrap_or(usize::MAX);
    let endian = layout.endian.unwrap_or(Endian::Little);
    let mut voxels = VoxelBuffer::reserve(report, layout.sample, endian, count)?;
    let mut reader = packing.unpack(input.open()?);
    stream::skip(report, &mut reader, layout.skip)?;
    stream::fill(report, &mut voxels, &mut reader, count, size)?;
    stream::refuse_surplus(report, &mut reader, bytes)?;
    Ok(voxels)
}

/// Layout that a file's name says, as far as it does.
#[derive(Debug, Default, PartialEq)]
struct Said {
    dimensions: Option<[u32; 3]>,
    sample: Option<SampleType>,
    endian: Option<Endian>,
}

impl Said {
    fn new(name: &str) -> Self {
        let name = name.to_ascii_lowercase();
        let mut said = Self::default();
        for word in name.split(|character: char| !character.is_ascii_alphanumeric()) {
            // Such as uint16le; there is no type that ends so by itself.
            let (word, order) = match (word.strip_suffix("le"), word.strip_suffix("be")) {
                (Some(word), _) if sample_type(word).is_some() => (word, Some(Endian::Little)),
                (_, Some(word)) if sample_type(word).is_some() => (word, Some(Endian::Big)),
                _ => (word, endian(word)),
            };
            said.endian = said.endian.or(order);
            said.sample = said.sample.or(sample_type(word));
            // Perhaps behind a name, as in `head256x256x109`.
            let sizes = word.trim_start_matches(|character: char| character.is_ascii_alphabetic());
            said.dimensions = said.dimensions.or(dimensions(sizes));
        }
        said
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_dimensions_type_and_byte_order() {
        let said = |dimensions, sample, endian| Said { dimensions, sample, endian };
        let cases = [
            ("a_256x256x109_uint8.raw.gz", said(Some([256, 256, 109]), Some(SampleType::U8), None)),
            ("Head256X256X109.raw", said(Some([256, 256, 109]), None, None)),
            ("a-3x2x2-u16_le.bin", said(Some([3, 2, 2]), Some(SampleType::U16), Some(Endian::Little))),
            ("3x2x2.float32.be.raw", said(Some([3, 2, 2]), Some(SampleType::F32), Some(Endian::Big))),
            ("a_3x2x2_int16be.raw", said(Some([3, 2, 2]), Some(SampleType::I16), Some(Endian::Big))),
            ("double_3x2x2.raw", said(Some([3, 2, 2]), Some(SampleType::F64), None)),
            ("table_3x2.raw", said(None, None, None)),
            ("a_3x0x2_3x2x2x4_99999999999x1x1.raw", said(None, None, None)),
            ("ü_1x1x1_é.raw", said(Some([1, 1, 1]), None, None)),
        ];
        for (name, expected) in cases {
            assert_eq!(Said::new(name), expected, "{name}");
        }
    }
}

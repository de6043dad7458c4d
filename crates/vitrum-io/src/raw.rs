//! Voxels without any header, described by the file's name, such as `head_256x256x109_uint8.raw`.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use flate2::bufread::MultiGzDecoder;

use crate::error::{Error, Place, Report};
use crate::memory;
use crate::open::{Input, OpenOptions, VolumeReader};
use crate::samples::{Endian, SampleType, VoxelBuffer};
use crate::stream;
use crate::volume::{Source, Volume};

/// The reader of `.raw` and `.bin` files.
pub(crate) struct Raw;

const ADVICE: &str = "rename the file to say them, for example NAME_256x256x109_uint8.raw, NAME_64x64x32_int16_be.raw or \
                      NAME_64x64x32_float32.raw.gz; if a header lies beside it, open that";

impl VolumeReader for Raw {
    fn name(&self) -> &'static str {
        "raw voxels"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &[".raw", ".raw.gz", ".bin", ".bin.gz"]
    }

    /// Nothing in the content tells.
    fn recognises(&self, _head: &[u8], _path: &Path) -> bool {
        false
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let refuse = |problem: String| report.unsupported(Place::File, problem, ADVICE);
        let said = Said::new(&input.name);
        let Some(dimensions) = said.dimensions else {
            return Err(refuse("the file has no header, and its name says no dimensions".to_owned()));
        };
        let mut assumptions = vec![
            "the file has no header: its dimensions and type were taken from its name".to_owned(),
            "the file says no spacing: 1 was taken along each axis".to_owned(),
        ];
        let sample = match said.sample {
            Some(sample) => sample,
            None if !input.gzipped && stream::byte_count(dimensions, 1) == Ok(input.length) => {
                assumptions.push("the name says no type: uint8 was taken, which fits the size".to_owned());
                SampleType::U8
            }
            None => return Err(refuse("the file has no header, and its name says no sample type".to_owned())),
        };
        if said.endian.is_none() && sample.size() > 1 {
            assumptions.push("the name says no byte order: little-endian was taken".to_owned());
        }
        let endian = said.endian.unwrap_or(Endian::Little);
        assumptions.extend(sample.rounding_note());
        let bytes = stream::byte_count(dimensions, sample.size()).map_err(&refuse)?;
        if !input.gzipped && bytes != input.length {
            let [x, y, z] = dimensions;
            return Err(refuse(format!(
                "{x} x {y} x {z} voxels of {}, as the name says, take {bytes} bytes, and {} are there",
                sample.name(),
                input.length
            )));
        }
        let voxels = read_data(input, options, sample, endian, bytes)?.into_voxels();
        let volume = Volume::of_samples(input.name.clone(), dimensions, [1.0; 3], voxels, sample)?;
        let packing = if input.gzipped { "gzip" } else { "raw" };
        let encoding = if sample.size() == 1 { packing.to_owned() } else { format!("{packing}, {}", endian.name()) };
        let source = Source { format: self.name(), sample_type: sample.name().to_owned(), encoding, assumptions };
        Ok(Volume { source, ..volume })
    }
}

fn read_data(
    input: &Input,
    options: &OpenOptions,
    sample: SampleType,
    endian: Endian,
    bytes: u64,
) -> Result<VoxelBuffer, Error> {
    let report = Report::new(&input.name);
    let size = sample.size();
    let count = bytes / size as u64;
    if input.gzipped {
        stream::check_deflate(report, bytes, input.length)?;
    }
    memory::check(report, count * sample.stored_size() as u64, options.max_bytes)?;
    let count = usize::try_from(count).unwrap_or(usize::MAX);
    let mut voxels = VoxelBuffer::reserve(report, sample, endian, count)?;
    let file = BufReader::new(File::open(input.path).map_err(|error| report.unreadable(error))?);
    let mut reader: Box<dyn Read> = if input.gzipped { Box::new(MultiGzDecoder::new(file)) } else { Box::new(file) };
    stream::fill(report, &mut voxels, &mut reader, count, size)?;
    stream::refuse_surplus(report, &mut reader, bytes)?;
    Ok(voxels)
}

/// What a file's name says of its voxels.
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
            let (word, endian) = match word {
                "le" | "little" | "lsb" => ("", Some(Endian::Little)),
                "be" | "big" | "msb" => ("", Some(Endian::Big)),
                // Such as uint16le; there is no type that ends so by itself.
                word => match (word.strip_suffix("le"), word.strip_suffix("be")) {
                    (Some(word), _) if sample_type(word).is_some() => (word, Some(Endian::Little)),
                    (_, Some(word)) if sample_type(word).is_some() => (word, Some(Endian::Big)),
                    _ => (word, None),
                },
            };
            said.endian = said.endian.or(endian);
            said.sample = said.sample.or(sample_type(word));
            said.dimensions = said.dimensions.or(dimensions(word));
        }
        said
    }
}

/// `256x256x109`, perhaps behind a name as in `head256x256x109`.
fn dimensions(word: &str) -> Option<[u32; 3]> {
    let mut sizes = word.trim_start_matches(|character: char| character.is_ascii_alphabetic()).split('x');
    let mut size = || sizes.next()?.parse().ok().filter(|&size| size > 0);
    let found = [size()?, size()?, size()?];
    sizes.next().is_none().then_some(found)
}

fn sample_type(word: &str) -> Option<SampleType> {
    match word {
        "int8" | "i8" | "schar" => Some(SampleType::I8),
        "uint8" | "u8" | "uchar" | "byte" => Some(SampleType::U8),
        "int16" | "i16" | "short" => Some(SampleType::I16),
        "uint16" | "u16" | "ushort" => Some(SampleType::U16),
        "int32" | "i32" => Some(SampleType::I32),
        "uint32" | "u32" => Some(SampleType::U32),
        "int64" | "i64" => Some(SampleType::I64),
        "uint64" | "u64" => Some(SampleType::U64),
        "float" | "float32" | "f32" => Some(SampleType::F32),
        "double" | "float64" | "f64" => Some(SampleType::F64),
        _ => None,
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

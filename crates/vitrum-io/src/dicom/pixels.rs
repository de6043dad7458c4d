//! The pixels of the slices, decoded.

use std::borrow::Cow;

use dicom_object::DefaultDicomObject;

use super::attributes;
use super::codecs::Problem;
use super::envelope::Envelope;
use super::files::Series;
use super::header::damaged;
use super::image::{File, Pixels, Slice};
use super::syntax::{self, Compression};
use super::{codecs, rle};
use crate::error::{Error, Place, Report};
use crate::input::Input;
use crate::samples::VoxelBuffer;
use crate::storage::Storage;
use crate::stream;

/// Decodes `slices` in their order; values of slopes of their own where the series has no one slope.
pub(super) fn read(
    input: &Input,
    series: &Series,
    slices: &[Slice],
    uniform: bool,
    voxels: &mut VoxelBuffer,
) -> Result<(), Error> {
    let mut opened: Option<(usize, Opened)> = None;
    for slice in slices {
        let [file, frame] = slice.index;
        let report = Report::new(&slice.file.name);
        let opened = match &mut opened {
            Some((number, opened)) if *number == file => opened,
            other => &mut other.insert((file, Opened::new(input, &series.files[file])?)).1,
        };
        let mut bytes = opened.frame(slice.file, frame)?;
        straighten(&mut bytes, slice.file.pixels);
        let count = slice.file.rows as usize * slice.file.columns as usize;
        if uniform {
            stream::fill(report, voxels, &mut bytes.as_slice(), count, slice.file.pixels.sample.size())?;
        } else {
            let values = values(&bytes, slice);
            stream::fill(report, voxels, &mut values.as_slice(), count, 4)?;
        }
    }
    Ok(())
}

/// A file with all of its pixels.
struct Opened {
    object: DefaultDicomObject,
    compression: Compression,
    /// The samples of all frames, little-endian, if they are not compressed.
    plain: Option<Vec<u8>>,
}

impl Opened {
    fn new(input: &Input, file: &File) -> Result<Self, Error> {
        let report = Report::new(&file.name);
        // Only a file at a path has others beside it.
        let at_path = input.is_at_path() || input.is_folder();
        let storage = if at_path { Storage::Disk(Cow::Borrowed(&file.path)) } else { input.storage() };
        let object = Envelope::open(&storage, file.length, report)?.object(report, true)?;
        let missing = || report.invalid(Place::File, "there are no pixels behind the header", "get the whole file");
        let data = object.get(file.data).ok_or_else(missing)?;
        let compression = syntax::compression(report, &file.syntax)?;
        let plain = if compression != Compression::None {
            None
        } else {
            let mut bytes = data.to_bytes().map_err(|error| damaged(report, &error))?.into_owned();
            // Words come in the machine's order, bytes in that of the file, which then is its own.
            if cfg!(target_endian = "big") && data.vr().to_string() == "OW" {
                bytes.chunks_exact_mut(2).for_each(<[u8]>::reverse);
            }
            if file.swapped {
                bytes.chunks_exact_mut(4).for_each(|pixel| pixel.rotate_left(2));
            }
            Some(bytes)
        };
        Ok(Self { object, compression, plain })
    }

    /// The bytes of a frame.
    fn frame(&self, file: &File, frame: usize) -> Result<Vec<u8>, Error> {
        let report = Report::new(&file.name);
        let size = file.rows as usize * file.columns as usize * file.pixels.sample.size();
        let found = match &self.plain {
            Some(bytes) => bytes.get(frame * size..).unwrap_or_default().iter().copied().take(size).collect(),
            None => self.unpack(file, frame).map_err(|problem| {
                let name = syntax::name(&file.syntax);
                match problem {
                    Problem::Damaged(problem) => report.invalid(
                        Place::File,
                        format!("the {name} of frame {} is damaged: {problem}", frame + 1),
                        "get the whole file, or write it anew",
                    ),
                    Problem::Unknown(problem) => report.unsupported(
                        Place::File,
                        format!("the {name} of frame {} cannot be decoded here: {problem}", frame + 1),
                        "convert the files, for example by `gdcmconv --raw IN OUT`",
                    ),
                }
            })?,
        };
        if found.len() < size {
            return Err(report.invalid(
                Place::File,
                format!("frame {} takes {size} bytes, {} are there", frame + 1, found.len()),
                "get the whole file",
            ));
        }
        Ok(found)
    }
}

impl Opened {
    /// The compressed bytes of a frame: all fragments of a file with one frame; one fragment where there are as many as frames; else
    /// the fragments between the frame's entries in the offset table.
    fn fragments(&self, file: &File, frame: usize) -> Vec<u8> {
        let data = self.object.get(attributes::PIXEL_DATA);
        let fragments = data.and_then(|data| data.fragments()).unwrap_or_default();
        let frames = file.frames.len();
        if frames == 1 {
            return fragments.concat();
        }
        if fragments.len() == frames {
            return fragments[frame].clone();
        }
        let offsets = data.and_then(|data| data.value().offset_table()).unwrap_or_default();
        let Some(start) = offsets.get(frame).map(|&offset| u64::from(offset)) else { return Vec::new() };
        let end = offsets.get(frame + 1).map_or(u64::MAX, |&offset| u64::from(offset));
        let mut offset = 0;
        let mut bytes = Vec::new();
        for fragment in fragments {
            if (start..end).contains(&offset) {
                bytes.extend_from_slice(fragment);
            }
            // Each has a header of eight bytes.
            offset += fragment.len() as u64 + 8;
        }
        bytes
    }

    /// The decoded pixels of a compressed frame, or the problem.
    fn unpack(&self, file: &File, frame: usize) -> Result<Vec<u8>, Problem> {
        let packed = self.fragments(file, frame);
        let (size, bytes) = ([file.rows, file.columns], file.pixels.sample.size());
        match self.compression {
            Compression::Jpeg => codecs::jpeg(&packed, size, bytes),
            Compression::JpegLs => codecs::jpeg_ls(&packed, size, bytes),
            Compression::Jpeg2000 => codecs::jpeg_2000(&packed, size, bytes),
            _ => Ok(rle::decode(&packed, file.rows as usize * file.columns as usize, bytes)?),
        }
    }
}

/// Moves the bits that hold the number down, and gives the others its sign.
fn straighten(bytes: &mut [u8], pixels: Pixels) {
    let size = pixels.sample.size();
    let width = 8 * size as u32;
    if pixels.stored == width || size > 4 {
        return;
    }
    let signed = pixels.sample.value_offset() != 0.0 || pixels.sample == crate::samples::SampleType::I32;
    for pixel in bytes.chunks_exact_mut(size) {
        let mut word = [0; 4];
        word[..size].copy_from_slice(pixel);
        // Up to the top, so that what is above falls off, and down again.
        let top = u32::from_le_bytes(word) << (32 - pixels.low_bit - pixels.stored);
        let down = 32 - pixels.stored;
        let value = if signed { ((top as i32) >> down) as u32 } else { top >> down };
        pixel.copy_from_slice(&value.to_le_bytes()[..size]);
    }
}

/// The physical values of a slice as float32, little-endian.
fn values(bytes: &[u8], slice: &Slice) -> Vec<u8> {
    use crate::samples::SampleType;
    let sample = slice.file.pixels.sample;
    let [slope, intercept] = slice.rescale;
    let float = |pixel: &[u8]| match *pixel {
        [a, b, c, d] => f32::from_le_bytes([a, b, c, d]).into(),
        [a, b, c, d, e, f, g, h] => f64::from_le_bytes([a, b, c, d, e, f, g, h]),
        _ => 0.0,
    };
    let value = |pixel: &[u8]| {
        if matches!(sample, SampleType::F32 | SampleType::F64) {
            return ((slope * float(pixel) + intercept) as f32).to_le_bytes();
        }
        let mut word = [0; 4];
        word[..pixel.len()].copy_from_slice(pixel);
        let unsigned = u32::from_le_bytes(word);
        let number = match sample {
            SampleType::I8 => f64::from(unsigned as u8 as i8),
            SampleType::I16 => f64::from(unsigned as u16 as i16),
            SampleType::I32 => f64::from(unsigned as i32),
            _ => f64::from(unsigned),
        };
        ((slope * number + intercept) as f32).to_le_bytes()
    };
    bytes.chunks_exact(sample.size()).flat_map(value).collect()
}

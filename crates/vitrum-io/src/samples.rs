//! The sample types that files use, and their decoding to the three that the kernels store.

use std::io::{self, Read};

use half::f16;

use crate::error::{Error, Report};
use crate::memory;
use crate::shared::Shared;
use crate::stored::Stored;

/// Byte order of multi-byte samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Endian {
    Little,
    Big,
}

impl Endian {
    pub fn name(self) -> &'static str {
        match self {
            Self::Little => "little-endian",
            Self::Big => "big-endian",
        }
    }
}

/// A sample as a file stores it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SampleType {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F16,
    F32,
    F64,
}

impl SampleType {
    pub fn name(self) -> &'static str {
        match self {
            Self::I8 => "int8",
            Self::U8 => "uint8",
            Self::I16 => "int16",
            Self::U16 => "uint16",
            Self::I32 => "int32",
            Self::U32 => "uint32",
            Self::I64 => "int64",
            Self::U64 => "uint64",
            Self::F16 => "float16",
            Self::F32 => "float32",
            Self::F64 => "float64",
        }
    }

    /// Bytes per sample in the file.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 | Self::F16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// Bytes per voxel once decoded.
    pub fn stored_size(self) -> usize {
        if self == Self::F16 { 4 } else { self.size().min(4) }
    }

    /// Offset from a stored voxel to the file's sample: signed integers are stored shifted.
    pub fn value_offset(self) -> f32 {
        match self {
            Self::I8 => -128.0,
            Self::I16 => -32768.0,
            _ => 0.0,
        }
    }

    /// A number written in text; `None` if it is none of this type.
    pub fn parse(self, number: &str) -> Option<f64> {
        match self {
            Self::F16 | Self::F32 | Self::F64 => number.parse().ok(),
            Self::U64 => Some(number.parse::<u64>().ok()? as f64),
            _ => Some(self.parse_integer(number)? as f64),
        }
    }

    /// A number of an integer type other than [`Self::U64`].
    fn parse_integer(self, number: &str) -> Option<i64> {
        let value: i64 = number.parse().ok()?;
        let unsigned = matches!(self, Self::U8 | Self::U16 | Self::U32);
        let in_range = match (unsigned, 8 * self.size()) {
            (_, 64) => true,
            (true, bits) => (0..1_i64 << bits).contains(&value),
            (false, bits) => (-(1_i64 << (bits - 1))..1_i64 << (bits - 1)).contains(&value),
        };
        in_range.then_some(value)
    }

    /// Coding of samples for people: its `name`, and the byte order where a sample has several bytes.
    pub fn coding(self, name: &str, endian: Endian) -> String {
        if self.size() == 1 { name.to_owned() } else { format!("{name}, {}", endian.name()) }
    }

    /// A sentence for [`crate::Source::assumptions`] where decoding may round.
    pub fn rounding_note(self) -> Option<String> {
        let exact = match self {
            Self::I32 | Self::U32 | Self::I64 | Self::U64 => "integers beyond ±16777216 are",
            Self::F64 => "samples are",
            _ => return None,
        };
        Some(format!("{} samples are stored as float32: {exact} rounded", self.name()))
    }
}

enum Decoded {
    U8(Vec<u8>),
    U16(Vec<u16>),
    F32(Vec<f32>),
}

/// Voxels while they are decoded. The room for all of them is reserved at the start.
pub(crate) struct VoxelBuffer {
    voxels: Decoded,
    sample: SampleType,
    endian: Endian,
    /// A colour for each voxel, where the file has colours.
    pub colors: Option<Vec<u32>>,
}

impl VoxelBuffer {
    pub fn reserve(report: Report, sample: SampleType, endian: Endian, count: usize) -> Result<Self, Error> {
        let voxels = match sample.stored_size() {
            1 => Decoded::U8(memory::reserve(report, Shared::<u8>::room(count))?),
            2 => Decoded::U16(memory::reserve(report, Shared::<u16>::room(count))?),
            _ => Decoded::F32(memory::reserve(report, Shared::<f32>::room(count))?),
        };
        Ok(Self { voxels, sample, endian, colors: None })
    }

    pub fn into_voxels(self) -> Stored {
        let voxels = match self.voxels {
            Decoded::U8(voxels) => voxels.into(),
            Decoded::U16(voxels) => voxels.into(),
            Decoded::F32(voxels) => voxels.into(),
        };
        Stored { voxels, colors: self.colors.map(Into::into), paged: None }
    }

    /// Decodes up to `count` samples from `reader`.
    ///
    /// Returns the bytes that it found, fewer than `count` samples' where the reader ends early,
    /// and the error that ended it, where one did.
    pub fn append(&mut self, reader: &mut dyn Read, count: usize) -> (u64, io::Result<()>) {
        // A multiple of every sample size, and small enough to stay in the second-level cache.
        const CHUNK: usize = 64 * 1024;
        let mut chunk = vec![0_u8; CHUNK];
        let expected = (count as u64).saturating_mul(self.sample.size() as u64);
        let mut found = 0;
        while found < expected {
            let want = CHUNK.min(usize::try_from(expected - found).unwrap_or(CHUNK));
            let (got, outcome) = read_up_to(reader, &mut chunk[..want]);
            found += got as u64;
            self.decode(&chunk[..got], self.endian);
            if outcome.is_err() || got < want {
                return (found, outcome);
            }
        }
        (found, Ok(()))
    }

    /// Decodes one number written in text; `None` if it is none of the sample type's.
    pub fn append_text(&mut self, number: &str) -> Option<()> {
        let mut bytes = [0_u8; 8];
        let size = self.sample.size();
        let parsed: [u8; 8] = match self.sample {
            SampleType::F16 | SampleType::F32 => return self.append_float(number.parse().ok()?),
            // Twice rounded (decimal to f64 to f32), as the binary encodings of f64 are.
            SampleType::F64 => number.parse::<f64>().ok()?.to_le_bytes(),
            SampleType::U64 => number.parse::<u64>().ok()?.to_le_bytes(),
            sample => sample.parse_integer(number)?.to_le_bytes(),
        };
        bytes[..size].copy_from_slice(&parsed[..size]);
        self.decode(&bytes[..size], Endian::Little);
        Some(())
    }

    /// Appends a number of the type float32; `None` where voxels are of another.
    pub fn append_float(&mut self, value: f32) -> Option<()> {
        match &mut self.voxels {
            Decoded::F32(voxels) => voxels.push(value),
            Decoded::U8(_) | Decoded::U16(_) => return None,
        }
        Some(())
    }

    /// Appends the whole samples in `bytes`; a broken one at the end is left out.
    pub fn decode(&mut self, bytes: &[u8], endian: Endian) {
        match (&mut self.voxels, self.sample) {
            // Flipping the top bit adds half of the range: two's complement becomes unsigned.
            (Decoded::U8(out), SampleType::I8) => out.extend(bytes.iter().map(|byte| byte ^ 0x80)),
            (Decoded::U8(out), _) => out.extend_from_slice(bytes),
            (Decoded::U16(out), SampleType::I16) => {
                out.extend(words(bytes, endian, |word| u16::from_le_bytes(word) ^ 0x8000));
            }
            (Decoded::U16(out), _) => out.extend(words(bytes, endian, u16::from_le_bytes)),
            (Decoded::F32(out), SampleType::I32) => {
                out.extend(words(bytes, endian, |word| i32::from_le_bytes(word) as f32));
            }
            (Decoded::F32(out), SampleType::U32) => {
                out.extend(words(bytes, endian, |word| u32::from_le_bytes(word) as f32));
            }
            (Decoded::F32(out), SampleType::I64) => {
                out.extend(words(bytes, endian, |word| i64::from_le_bytes(word) as f32));
            }
            (Decoded::F32(out), SampleType::U64) => {
                out.extend(words(bytes, endian, |word| u64::from_le_bytes(word) as f32));
            }
            (Decoded::F32(out), SampleType::F16) => {
                out.extend(words(bytes, endian, |word| f16::from_le_bytes(word).to_f32()));
            }
            (Decoded::F32(out), SampleType::F64) => {
                out.extend(words(bytes, endian, |word| f64::from_le_bytes(word) as f32));
            }
            (Decoded::F32(out), _) => out.extend(words(bytes, endian, f32::from_le_bytes)),
        }
    }
}

/// The words of `bytes`, each put in little-endian order and given to `decode`.
fn words<const SIZE: usize, T>(
    bytes: &[u8],
    endian: Endian,
    decode: impl Fn([u8; SIZE]) -> T,
) -> impl Iterator<Item = T> {
    bytes.as_chunks::<SIZE>().0.iter().map(move |&(mut word)| {
        if endian == Endian::Big {
            word.reverse();
        }
        decode(word)
    })
}

/// Fills `buffer` as far as `reader` goes; like `read_exact`, but says how far that was.
pub(crate) fn read_up_to(reader: &mut dyn Read, buffer: &mut [u8]) -> (usize, io::Result<()>) {
    let mut filled = 0;
    while filled < buffer.len() {
        match reader.read(&mut buffer[filled..]) {
            Ok(0) => break,
            Ok(count) => filled += count,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return (filled, Err(error)),
        }
    }
    (filled, Ok(()))
}

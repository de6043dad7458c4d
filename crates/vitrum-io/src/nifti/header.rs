//! The 348 bytes of a NIfTI-1 header.
//!
//! The format: <https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h>.

use crate::error::{Error, Place, Report};
use crate::samples::{Endian, SampleType};

/// Bytes of the header itself.
pub(super) const LENGTH: usize = 348;

/// Where the samples start in a `.nii` file at the earliest: behind the header and the 4 bytes
/// that say whether extensions follow.
pub(super) const FIRST_DATA_BYTE: u64 = 352;

/// The fields that matter, in the machine's byte order and unchecked unless said.
#[derive(Debug)]
pub(super) struct Header {
    pub endian: Endian,
    /// Checked: each at least 1.
    pub dimensions: [u32; 3],
    pub sample: SampleType,
    /// Sign of the z axis, then the spacings along x, y and z.
    pub pixdim: [f32; 4],
    /// Checked: a whole number, at least [`FIRST_DATA_BYTE`].
    pub data_start: u64,
    pub slope: f32,
    pub intercept: f32,
    pub units: u8,
    pub qform_code: i16,
    pub sform_code: i16,
    pub quaternion: [f32; 3],
    pub qoffset: [f32; 3],
    /// World x, y and z, each as weights of the indices and a constant.
    pub srow: [[f32; 4]; 3],
}

/// Byte offsets in the header.
mod offset {
    pub const DIM: usize = 40;
    pub const DATATYPE: usize = 70;
    pub const PIXDIM: usize = 76;
    pub const VOX_OFFSET: usize = 108;
    pub const SLOPE: usize = 112;
    pub const INTERCEPT: usize = 116;
    pub const UNITS: usize = 123;
    pub const QFORM_CODE: usize = 252;
    pub const SFORM_CODE: usize = 254;
    pub const QUATERNION: usize = 256;
    pub const QOFFSET: usize = 268;
    pub const SROW: usize = 280;
    pub const MAGIC: usize = 344;
}

/// Which NIfTI a file starts as, if any.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// NIfTI-1 with the data in the same file.
    Single(Endian),
    /// NIfTI-1 with the data in an `.img` file.
    Pair,
    /// NIfTI-2.
    Second,
}

pub(super) fn kind(head: &[u8]) -> Option<Kind> {
    let size: [u8; 4] = head.get(..4)?.try_into().ok()?;
    let magic = |at: usize| head.get(at..at + 4);
    let (size, endian) = match (i32::from_le_bytes(size), i32::from_be_bytes(size)) {
        (size @ (348 | 540), _) => (size, Endian::Little),
        (_, size @ (348 | 540)) => (size, Endian::Big),
        _ => return None,
    };
    match (size, magic(offset::MAGIC), magic(4)) {
        (348, Some(b"n+1\0"), _) => Some(Kind::Single(endian)),
        (348, Some(b"ni1\0"), _) => Some(Kind::Pair),
        (540, _, Some(b"n+2\0" | b"ni2\0")) => Some(Kind::Second),
        _ => None,
    }
}

impl Header {
    pub fn parse(bytes: &[u8; LENGTH], endian: Endian, report: Report) -> Result<Self, Error> {
        let fields = Fields { bytes, endian };
        let floats = |at: usize, index: usize| fields.f32(at + 4 * index);
        Ok(Self {
            endian,
            dimensions: dimensions(&fields, report)?,
            sample: sample_type(&fields, report)?,
            pixdim: std::array::from_fn(|index| floats(offset::PIXDIM, index)),
            data_start: data_start(&fields, report)?,
            slope: fields.f32(offset::SLOPE),
            intercept: fields.f32(offset::INTERCEPT),
            units: bytes[offset::UNITS],
            qform_code: fields.i16(offset::QFORM_CODE),
            sform_code: fields.i16(offset::SFORM_CODE),
            quaternion: std::array::from_fn(|index| floats(offset::QUATERNION, index)),
            qoffset: std::array::from_fn(|index| floats(offset::QOFFSET, index)),
            srow: std::array::from_fn(|row| std::array::from_fn(|column| floats(offset::SROW, 4 * row + column))),
        })
    }
}

struct Fields<'a> {
    bytes: &'a [u8; LENGTH],
    endian: Endian,
}

impl Fields<'_> {
    /// `at` is one of [`offset`]'s and small steps on: always inside.
    fn word<const SIZE: usize>(&self, at: usize) -> [u8; SIZE] {
        let mut word = std::array::from_fn(|index| self.bytes[at + index]);
        if self.endian == Endian::Big {
            word.reverse();
        }
        word
    }

    fn i16(&self, at: usize) -> i16 {
        i16::from_le_bytes(self.word(at))
    }

    fn f32(&self, at: usize) -> f32 {
        f32::from_le_bytes(self.word(at))
    }
}

fn dimensions(fields: &Fields, report: Report) -> Result<[u32; 3], Error> {
    let place = |index: usize| Place::Byte((offset::DIM + 2 * index) as u64);
    let count = fields.i16(offset::DIM);
    if !(1..=7).contains(&count) {
        return Err(report.invalid(
            place(0),
            format!("dim[0] is {count}, not a number of dimensions from 1 to 7"),
            "check that the file is whole",
        ));
    }
    if count < 3 {
        return Err(report.unsupported(
            place(0),
            format!("the data has {count} dimensions, and a volume has 3"),
            "stack the slices to a volume first",
        ));
    }
    for index in 4..=count as usize {
        let size = fields.i16(offset::DIM + 2 * index);
        if size > 1 {
            let what = if index == 4 { "points in time" } else { "components a voxel" };
            return Err(report.unsupported(
                place(index),
                format!("dim[{index}] is {size}: {size} {what}, and a scalar volume has 1"),
                "pick out one first, for example by `fslroi FILE OUT 0 1`",
            ));
        }
    }
    let mut dimensions = [0; 3];
    for (axis, dimension) in dimensions.iter_mut().enumerate() {
        let size = fields.i16(offset::DIM + 2 * (axis + 1));
        *dimension = u32::try_from(size).ok().filter(|&size| size > 0).ok_or_else(|| {
            report.invalid(
                place(axis + 1),
                format!("dim[{}] is {size}, not a size of at least 1", axis + 1),
                "correct the header",
            )
        })?;
    }
    Ok(dimensions)
}

fn sample_type(fields: &Fields, report: Report) -> Result<SampleType, Error> {
    let unsupported = match fields.i16(offset::DATATYPE) {
        2 => return Ok(SampleType::U8),
        4 => return Ok(SampleType::I16),
        8 => return Ok(SampleType::I32),
        16 => return Ok(SampleType::F32),
        64 => return Ok(SampleType::F64),
        256 => return Ok(SampleType::I8),
        512 => return Ok(SampleType::U16),
        768 => return Ok(SampleType::U32),
        1024 => return Ok(SampleType::I64),
        1280 => return Ok(SampleType::U64),
        1 => "bits".to_owned(),
        32 | 1792 | 2048 => "complex numbers".to_owned(),
        128 | 2304 => "colours".to_owned(),
        1536 => "float128".to_owned(),
        other => format!("of the unknown type {other}"),
    };
    Err(report.unsupported(
        Place::Byte(offset::DATATYPE as u64),
        format!("the samples are {unsupported}, not integers or floats of 8 to 64 bits"),
        "convert them first, for example by `fslmaths FILE OUT -odt float`",
    ))
}

fn data_start(fields: &Fields, report: Report) -> Result<u64, Error> {
    let start = fields.f32(offset::VOX_OFFSET);
    // Some writers leave it 0, which can only mean the first possible byte.
    if start == 0.0 {
        return Ok(FIRST_DATA_BYTE);
    }
    // A float holds every whole number to 2^24, and no extension is larger than that by far.
    let whole = start.fract() == 0.0 && start >= FIRST_DATA_BYTE as f32 && start <= 1e12;
    if !whole {
        return Err(report.invalid(
            Place::Byte(offset::VOX_OFFSET as u64),
            format!("vox_offset is {start}, not a whole number of at least {FIRST_DATA_BYTE}"),
            "correct the header",
        ));
    }
    Ok(start as u64)
}

//! The 348 bytes of a NIfTI-1 header, or the 540 of a NIfTI-2 header.

use super::layout::{FIRST, Fields, Layout, SECOND};
use crate::error::{Error, Place, Report};
use crate::samples::{Endian, SampleType};
use crate::time::Clock;

/// The fields that matter, in the machine's byte order and unchecked unless said.
#[derive(Debug)]
pub(super) struct Header {
    pub layout: &'static Layout,
    pub endian: Endian,
    /// Checked: each at least 1.
    pub dimensions: [u32; 3],
    /// Points in time, at least 1.
    pub times: u64,
    pub sample: SampleType,
    /// Numbers of a voxel that lie side by side, as those of colours do; 1 of others.
    pub channels: u64,
    /// Numbers of a voxel that lie in planes behind all points in time, as those of vectors do; 1 of others.
    pub planes: u64,
    /// Sign of the z axis, then the spacings along x, y and z, and the time from point to point.
    pub pixdim: [f64; 5],
    /// Checked: a whole number, behind the header where the data is in the same file.
    pub data_start: u64,
    pub slope: f32,
    pub intercept: f32,
    pub units: i32,
    /// The code of the meaning of the values.
    pub intent: i32,
    /// The moment of the first point in time.
    pub time_offset: f64,
    pub qform_code: i32,
    pub sform_code: i32,
    pub quaternion: [f64; 3],
    pub qoffset: [f64; 3],
    /// World x, y and z, each as weights of the indices and a constant.
    pub srow: [[f64; 4]; 3],
}

/// The kind of a NIfTI file, by its first bytes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kind {
    pub layout: &'static Layout,
    pub endian: Endian,
    /// Whether the data is in an `.img` file.
    pub pair: bool,
}

pub(super) fn kind(head: &[u8]) -> Option<Kind> {
    let size: [u8; 4] = head.get(..4)?.try_into().ok()?;
    let (size, endian) = match (i32::from_le_bytes(size), i32::from_be_bytes(size)) {
        (size @ (348 | 540), _) => (size, Endian::Little),
        (_, size @ (348 | 540)) => (size, Endian::Big),
        _ => return None,
    };
    let layout = if size == 348 { &FIRST } else { &SECOND };
    let pair = match (size, head.get(layout.magic..layout.magic + 4)?) {
        (348, b"n+1\0") | (540, b"n+2\0") => false,
        (348, b"ni1\0") | (540, b"ni2\0") => true,
        _ => return None,
    };
    Some(Kind { layout, endian, pair })
}

impl Header {
    /// When points in time are: the distance between them, in a unit.
    pub fn clock(&self) -> Clock {
        let unit = match self.units & 0x38 {
            16 => 1e-3,
            24 => 1e-6,
            // Without a unit, seconds are what programs take.
            0 | 8 => 1.0,
            _ => return Clock::Unknown,
        };
        Clock::steps(self.time_offset * unit, self.pixdim[4] * unit)
    }

    /// The header in `bytes`, which are as many as the layout of `kind` has.
    pub fn parse(bytes: &[u8], kind: Kind, report: Report) -> Result<Self, Error> {
        let Kind { layout, endian, pair } = kind;
        let fields = Fields { bytes, endian, layout };
        let float = |at: usize, index: usize| fields.float(at, index);
        let (sample, channels) = sample_type(&fields, report)?;
        Ok(Self {
            layout,
            endian,
            dimensions: dimensions(&fields, report)?,
            times: if fields.dim(0) > 3 { u64::try_from(fields.dim(4)).unwrap_or(1).max(1) } else { 1 },
            sample,
            channels,
            planes: planes(&fields, channels, report)?,
            pixdim: std::array::from_fn(|index| float(layout.pixdim, index)),
            data_start: data_start(&fields, pair, report)?,
            slope: float(layout.slope, 0) as f32,
            intercept: float(layout.intercept, 0) as f32,
            units: fields.units(),
            intent: fields.code(layout.intent),
            time_offset: float(layout.time_offset, 0),
            qform_code: fields.code(layout.qform_code),
            sform_code: fields.code(layout.sform_code),
            quaternion: std::array::from_fn(|index| float(layout.quaternion, index)),
            qoffset: std::array::from_fn(|index| float(layout.qoffset, index)),
            srow: std::array::from_fn(|row| std::array::from_fn(|column| float(layout.srow, 4 * row + column))),
        })
    }
}

fn dimensions(fields: &Fields, report: Report) -> Result<[u32; 3], Error> {
    let place = |index: usize| Place::Byte(fields.layout.dim(index) as u64);
    let count = fields.dim(0);
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
    // The fourth is time, the fifth of vectors.
    for index in 6..=count as usize {
        let size = fields.dim(index);
        if size > 1 {
            return Err(report.unsupported(
                place(index),
                format!("dim[{index}] is {size}, and axes beyond the fifth are not read"),
                "pick out a part of 5 dimensions first, for example by nibabel",
            ));
        }
    }
    let mut dimensions = [0; 3];
    for (axis, dimension) in dimensions.iter_mut().enumerate() {
        let size = fields.dim(axis + 1);
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

/// The size of the fifth dimension.
fn planes(fields: &Fields, channels: u64, report: Report) -> Result<u64, Error> {
    const FIFTH: usize = 5;
    if fields.dim(0) < FIFTH as i64 {
        return Ok(1);
    }
    let size = u64::try_from(fields.dim(FIFTH)).unwrap_or(1).max(1);
    if size > 1 && channels > 1 {
        return Err(report.unsupported(
            Place::Byte(fields.layout.dim(FIFTH) as u64),
            format!("dim[{FIFTH}] is {size}, and the samples are colours: a voxel has one colour or one vector"),
            "pick out one first, for example by nibabel",
        ));
    }
    Ok(size)
}

/// The type of a number, and how many of them a sample has.
fn sample_type(fields: &Fields, report: Report) -> Result<(SampleType, u64), Error> {
    let scalar = |sample| Ok((sample, 1));
    let unsupported = match fields.short(fields.layout.datatype) {
        2 => return scalar(SampleType::U8),
        4 => return scalar(SampleType::I16),
        8 => return scalar(SampleType::I32),
        16 => return scalar(SampleType::F32),
        64 => return scalar(SampleType::F64),
        256 => return scalar(SampleType::I8),
        512 => return scalar(SampleType::U16),
        768 => return scalar(SampleType::U32),
        1024 => return scalar(SampleType::I64),
        1280 => return scalar(SampleType::U64),
        128 => return Ok((SampleType::U8, 3)),
        2304 => return Ok((SampleType::U8, 4)),
        1 => "bits".to_owned(),
        32 | 1792 | 2048 => "complex numbers".to_owned(),
        1536 => "float128".to_owned(),
        other => format!("of the unknown type {other}"),
    };
    Err(report.unsupported(
        Place::Byte(fields.layout.datatype as u64),
        format!("the samples are {unsupported}, not integers or floats of 8 to 64 bits"),
        "convert them first, for example by `fslmaths FILE OUT -odt float`",
    ))
}

fn data_start(fields: &Fields, pair: bool, report: Report) -> Result<u64, Error> {
    let start = fields.vox_offset();
    let first = if pair { 0 } else { fields.layout.first_data_byte() };
    // Some writers leave it 0, which can only mean the first possible byte.
    if start == 0.0 {
        return Ok(first);
    }
    // NIfTI-1 keeps it in a float32, which holds every whole number to 2^24: no extension is longer by far.
    const LARGEST: u64 = 1_000_000_000_000;
    let whole = start.fract() == 0.0 && (first as f64..=LARGEST as f64).contains(&start);
    if !whole {
        return Err(report.invalid(
            Place::Byte(fields.layout.vox_offset as u64),
            format!("vox_offset is {start}, not a whole number from {first} to {LARGEST}"),
            "correct the header",
        ));
    }
    Ok(start as u64)
}

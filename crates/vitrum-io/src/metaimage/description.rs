//! Meaning of the fields of a MetaImage header.

use super::header::Header;
use super::space;
use crate::components::{self, Components};
use crate::error::{Error, Place, Report, clip};
use crate::fields::{Field, Fields};
use crate::options::OpenOptions;
use crate::placement::Placement;
use crate::samples::{Endian, SampleType};
use crate::source::Assumptions;
use crate::stream;
use crate::time::{Clock, Times};

/// Coding of the samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Raw,
    Deflate,
    Text,
}

impl Encoding {
    pub fn name(self) -> &'static str {
        match self {
            Self::Raw => "raw",
            Self::Deflate => "zlib",
            Self::Text => "text",
        }
    }
}

/// Start of the data in its file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum HeaderSize {
    /// Behind the header, or at the start of a file of its own.
    None,
    /// Offset of the data from the start of the file, in bytes.
    Bytes(u64),
    /// Data that ends with the file.
    FromEnd,
}

/// A header understood: all that reading the data takes.
#[derive(Debug)]
pub(super) struct Description {
    pub sample: SampleType,
    pub endian: Endian,
    /// The components of a voxel, where it has several.
    pub components: Option<Components>,
    /// Bytes of a voxel in the file.
    pub voxel_size: usize,
    pub encoding: Encoding,
    /// Number of axes in the file, axes of size 1 behind the third included.
    pub rank: usize,
    pub dimensions: [u32; 3],
    /// Points in time, along the one axis behind the third that has several.
    pub times: Times,
    /// Bytes of data of one point in time, decoded to the file's sample type.
    pub data_bytes: u64,
    pub header_size: HeaderSize,
    pub placement: Placement,
    pub assumptions: Assumptions,
}

impl Description {
    pub fn new(header: &Header, options: &OpenOptions, report: Report) -> Result<Self, Error> {
        let fields = &header.fields;
        let mut assumptions = Assumptions::default();
        let (channels, place) = channels(fields, report)?;
        let sample = sample_type(fields, report)?;
        let encoding = encoding(fields, report)?;
        let endian = endian(fields, report, sample, encoding, &mut assumptions)?;
        let asked = options.array.as_deref();
        let components = if channels == 1 {
            components::refuse(report, "MetaImage", asked)?;
            None
        } else {
            let colors = sample == SampleType::U8 && (3..=4).contains(&channels);
            Some(Components::choose((report, place), channels, colors, (sample, endian), asked, &mut assumptions)?)
        };
        let (.., voxel_size) = components::decoded_as(sample, endian, components);
        let (rank, dimensions, count) = dimensions(fields, report)?;
        let sizes = fields.get("DimSize").map_or(Place::File, Field::place);
        let data_bytes = stream::data_bytes_of(report, sizes, dimensions, voxel_size)?;
        let times = Times::choose(report, sizes, count, &clock(fields), options, &mut assumptions)?;
        times.spans(report, sizes, data_bytes)?;
        let header_size = header_size(fields, report, encoding)?;
        let placement = space::placement(fields, report, rank, options, &mut assumptions)?;
        assumptions.extend(sample.rounding_note());
        assumptions.extend(fields.unknown_notes(KNOWN));
        Ok(Self {
            sample,
            endian,
            components,
            voxel_size,
            encoding,
            rank,
            dimensions,
            times,
            data_bytes,
            header_size,
            placement,
            assumptions,
        })
    }

    pub fn voxel_count(&self) -> u64 {
        self.data_bytes / self.voxel_size as u64
    }
}

/// When points in time are: the fourth distance is in seconds, as far as the format says.
fn clock(fields: &Fields) -> Clock {
    let number = |name: &str| -> Option<f64> { fields.get(name)?.text.split_whitespace().nth(3)?.parse().ok() };
    match number("ElementSpacing") {
        Some(step) => Clock::steps(number("Offset").or(number("Position")).or(number("Origin")).unwrap_or(0.0), step),
        None => Clock::Unknown,
    }
}

/// Fields that are read, or that say nothing about the picture.
#[rustfmt::skip]
pub(super) const KNOWN: &[&str] = &[
    "AcquisitionDate", "AnatomicalOrientation", "BinaryData", "BinaryDataByteOrderMSB", "CenterOfRotation", "Color",
    "CompressedData", "CompressedDataSize", "CompressionLevel", "DimSize", "DistanceUnits", "ElementByteOrderMSB",
    "ElementMax", "ElementMin", "ElementNBits", "ElementNumberOfChannels", "ElementSize", "ElementSpacing",
    "ElementType", "HeaderSize", "ID", "Modality", "NDims", "Name", "ObjectSubType", "ObjectType", "Offset",
    "Orientation", "Origin", "ParentID", "Position", "Rotation", "SequenceID", "TransformMatrix", "TransformType",
];

/// The number of components of a voxel, and where it is said.
fn channels(fields: &Fields, report: Report) -> Result<(u64, Place), Error> {
    if let Some(field) = fields.get("ObjectType")
        && !field.text.eq_ignore_ascii_case("Image")
    {
        return Err(report.unsupported(
            field.place(),
            format!("the object is a `{}`, not an `Image`", clip(&field.text)),
            "give a file with an image in it",
        ));
    }
    match fields.get("ElementNumberOfChannels") {
        None => Ok((1, Place::File)),
        Some(field) => Ok((field.numbers::<u64>(report, 1)?[0], field.place())),
    }
}

fn sample_type(fields: &Fields, report: Report) -> Result<SampleType, Error> {
    let field = fields.require(report, "ElementType", "ElementType = MET_UCHAR")?;
    match field.text.as_str() {
        "MET_CHAR" => Ok(SampleType::I8),
        "MET_UCHAR" => Ok(SampleType::U8),
        "MET_SHORT" => Ok(SampleType::I16),
        "MET_USHORT" => Ok(SampleType::U16),
        // The format's long has 4 bytes on every machine.
        "MET_INT" | "MET_LONG" => Ok(SampleType::I32),
        "MET_UINT" | "MET_ULONG" => Ok(SampleType::U32),
        "MET_LONG_LONG" => Ok(SampleType::I64),
        "MET_ULONG_LONG" => Ok(SampleType::U64),
        "MET_FLOAT" => Ok(SampleType::F32),
        "MET_DOUBLE" => Ok(SampleType::F64),
        other => Err(report.invalid(
            field.place(),
            format!("`{}` is not a type of one number", clip(other)),
            "use one of MET_CHAR, MET_UCHAR, MET_SHORT, MET_USHORT, MET_INT, MET_UINT, MET_LONG_LONG, \
             MET_ULONG_LONG, MET_FLOAT, MET_DOUBLE",
        )),
    }
}

fn encoding(fields: &Fields, report: Report) -> Result<Encoding, Error> {
    let text = fields.get("BinaryData").map(|field| truth(field, report)).transpose()? == Some(false);
    let Some(field) = fields.get("CompressedData") else {
        return Ok(if text { Encoding::Text } else { Encoding::Raw });
    };
    match (truth(field, report)?, text) {
        (false, false) => Ok(Encoding::Raw),
        (false, true) => Ok(Encoding::Text),
        (true, false) => Ok(Encoding::Deflate),
        (true, true) => Err(report.invalid(
            field.place(),
            "`CompressedData = True` with `BinaryData = False`",
            "set the one that is wrong right: only binary data is compressed",
        )),
    }
}

fn endian(
    fields: &Fields,
    report: Report,
    sample: SampleType,
    encoding: Encoding,
    assumptions: &mut Assumptions,
) -> Result<Endian, Error> {
    match fields.get("BinaryDataByteOrderMSB").or_else(|| fields.get("ElementByteOrderMSB")) {
        Some(field) => Ok(if truth(field, report)? { Endian::Big } else { Endian::Little }),
        None => {
            if sample.size() > 1 && encoding != Encoding::Text {
                assumptions.push("the file names no byte order: little-endian was taken".to_owned());
            }
            Ok(Endian::Little)
        }
    }
}

/// The number of axes, the sizes of the first three, and the number of points in time.
fn dimensions(fields: &Fields, report: Report) -> Result<(usize, [u32; 3], u64), Error> {
    const MOST_AXES: usize = 10;
    let field = fields.require(report, "NDims", "NDims = 3")?;
    let rank: usize = field.numbers(report, 1)?[0];
    if rank < 3 {
        return Err(report.unsupported(
            field.place(),
            format!("the data has {rank} dimensions, and a volume has 3"),
            "stack the slices to a volume first",
        ));
    }
    if rank > MOST_AXES {
        return Err(report.invalid(
            field.place(),
            format!("NDims is {rank}, and the format has {MOST_AXES} at most"),
            "correct the header",
        ));
    }
    let field = fields.require(report, "DimSize", "DimSize = 64 64 64")?;
    let sizes: Vec<u32> = field.numbers(report, rank)?;
    if sizes.contains(&0) {
        return Err(report.invalid(
            field.place(),
            format!("`DimSize = {}` has no voxels", clip(&field.text)),
            "give each axis a size of at least 1",
        ));
    }
    let mut several = sizes.iter().skip(3).filter(|&&size| size > 1);
    let times = several.next().copied().unwrap_or(1);
    if several.next().is_some() {
        return Err(report.unsupported(
            field.place(),
            format!(
                "`DimSize = {}` has two axes and more behind the third, and one alone can be time",
                clip(&field.text)
            ),
            "pick out one volume first, for example by SimpleITK's Extract",
        ));
    }
    Ok((rank, [sizes[0], sizes[1], sizes[2]], times.into()))
}

fn header_size(fields: &Fields, report: Report, encoding: Encoding) -> Result<HeaderSize, Error> {
    let Some(field) = fields.get("HeaderSize") else {
        return Ok(HeaderSize::None);
    };
    let size: i64 = field.numbers(report, 1)?[0];
    match (u64::try_from(size), encoding) {
        (Ok(0), _) => Ok(HeaderSize::None),
        (Ok(size), _) => Ok(HeaderSize::Bytes(size)),
        (Err(_), Encoding::Raw) if size == -1 => Ok(HeaderSize::FromEnd),
        _ => Err(report.invalid(
            field.place(),
            format!("`HeaderSize = {size}` with {} data", encoding.name()),
            "give 0 or more, or -1 with raw data at the end of the file",
        )),
    }
}

fn truth(field: &Field, report: Report) -> Result<bool, Error> {
    match field.text.to_ascii_lowercase().as_str() {
        "true" | "t" | "1" | "yes" => Ok(true),
        "false" | "f" | "0" | "no" => Ok(false),
        other => Err(report.invalid(
            field.place(),
            format!("`{}` is neither True nor False", clip(other)),
            "use one of the two",
        )),
    }
}

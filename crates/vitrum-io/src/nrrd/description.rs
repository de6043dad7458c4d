//! Meaning of the fields of a NRRD header.

use super::components as axis;
use super::header::Header;
use super::space;
use crate::components::{self, Components};
use crate::error::{Error, Place, Report, clip};
use crate::fields::Field;
use crate::options::OpenOptions;
use crate::placement::Placement;
use crate::samples::{Endian, SampleType};
use crate::source::Assumptions;
use crate::stream;
use crate::time::{Clock, Times, seconds};

/// Coding of the samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Raw,
    Gzip,
    Text,
    Hex,
}

impl Encoding {
    pub fn name(self) -> &'static str {
        match self {
            Self::Raw => "raw",
            Self::Gzip => "gzip",
            Self::Text => "text",
            Self::Hex => "hex",
        }
    }
}

/// Start of the data, behind the skipped lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ByteSkip {
    /// Offset of the data in bytes; in decompressed bytes for gzip.
    Forward(u64),
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
    pub dimensions: [u32; 3],
    /// Points in time, along a fourth axis, the slowest.
    pub times: Times,
    /// Bytes of data of one point in time, decoded to the file's sample type.
    pub data_bytes: u64,
    pub line_skip: u64,
    pub byte_skip: ByteSkip,
    pub placement: Placement,
    pub assumptions: Assumptions,
}

impl Description {
    pub fn new(header: &mut Header, options: &OpenOptions, report: Report) -> Result<Self, Error> {
        let several = axis::take(header, report)?;
        let header = &*header;
        let sample = sample_type(header, report)?;
        let encoding = encoding(header, report)?;
        let endian = endian(header, report, sample, encoding)?;
        let (dimensions, rank, count) = dimensions(header, report)?;
        let sizes = header.get("sizes").map_or(Place::File, Field::place);
        let mut assumptions = Assumptions::default();
        let asked = options.array.as_deref();
        let components = match several {
            None => {
                components::refuse(report, "NRRD", asked)?;
                None
            }
            Some((1, ..)) => None,
            Some((count, colors, place)) => {
                Some(Components::choose((report, place), count, colors, (sample, endian), asked, &mut assumptions)?)
            }
        };
        let (.., voxel_size) = components::decoded_as(sample, endian, components);
        let data_bytes = stream::data_bytes_of(report, sizes, dimensions, voxel_size)?;
        let (line_skip, byte_skip) = skips(header, report, encoding)?;
        let times = Times::choose(report, sizes, count, &clock(header), options, &mut assumptions)?;
        times.spans(report, sizes, data_bytes)?;
        let placement = space::placement(header, rank, report, options, &mut assumptions)?;
        assumptions.extend(sample.rounding_note());
        assumptions.extend(header.fields.unknown_notes(KNOWN));
        Ok(Self {
            sample,
            endian,
            components,
            voxel_size,
            encoding,
            dimensions,
            times,
            data_bytes,
            line_skip,
            byte_skip,
            placement,
            assumptions,
        })
    }

    pub fn voxel_count(&self) -> u64 {
        self.data_bytes / self.voxel_size as u64
    }
}

/// When points in time are: the fourth axis has a spacing and a unit of time.
fn clock(header: &Header) -> Clock {
    let word = |name: &str| header.get(name).and_then(|field| field.text.split_whitespace().nth(3).map(str::to_owned));
    let number = |name: &str| word(name).and_then(|word| word.parse::<f64>().ok());
    let unit = word("units").map(|unit| unit.trim_matches('"').to_owned());
    // An axis without a unit, or of another kind, is not known to be in seconds; `units` may be missing where `kinds` says time.
    let scale = match unit.as_deref().filter(|unit| !unit.is_empty() && *unit != "???") {
        Some(unit) => seconds(unit),
        None => word("kinds").is_some_and(|kind| kind.eq_ignore_ascii_case("time")).then_some(1.0),
    };
    match (scale, number("spacings")) {
        (Some(scale), Some(step)) => Clock::steps(number("axismins").unwrap_or(0.0) * scale, step * scale),
        _ => Clock::Unknown,
    }
}

/// Fields that are read, or that say nothing about the picture.
pub(super) const KNOWN: &[&str] = &[
    "axismaxs",
    "axismins",
    "blocksize",
    "byteskip",
    "centerings",
    "centers",
    "content",
    "datafile",
    "dimension",
    "encoding",
    "endian",
    "kinds",
    "labels",
    "lineskip",
    "max",
    "measurementframe",
    "min",
    "number",
    "sampleunits",
    "sizes",
    "space",
    "spacedimension",
    "spacedirections",
    "spaceorigin",
    "spaceunits",
    "spacings",
    "thicknesses",
    "type",
    "units",
];

fn sample_type(header: &Header, report: Report) -> Result<SampleType, Error> {
    let field = header.require(report, "type", "type: uint8")?;
    // "unsigned  short" has been seen with two spaces.
    let words: Vec<_> = field.text.split_whitespace().collect();
    match words.join(" ").to_ascii_lowercase().as_str() {
        "signed char" | "int8" | "int8_t" => Ok(SampleType::I8),
        "uchar" | "unsigned char" | "uint8" | "uint8_t" => Ok(SampleType::U8),
        "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => Ok(SampleType::I16),
        "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => Ok(SampleType::U16),
        "int" | "signed int" | "int32" | "int32_t" => Ok(SampleType::I32),
        "uint" | "unsigned int" | "uint32" | "uint32_t" => Ok(SampleType::U32),
        "longlong"
        | "long long"
        | "long long int"
        | "signed long long"
        | "signed long long int"
        | "int64"
        | "int64_t" => Ok(SampleType::I64),
        "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => Ok(SampleType::U64),
        "float" => Ok(SampleType::F32),
        "double" => Ok(SampleType::F64),
        "block" => Err(report.unsupported(
            field.place(),
            "`block` samples have no number in them",
            "convert them to a number type",
        )),
        other => Err(report.invalid(
            field.place(),
            format!("`{}` is not a sample type", clip(other)),
            "use one of int8, uint8, int16, uint16, int32, uint32, int64, uint64, float, double",
        )),
    }
}

fn encoding(header: &Header, report: Report) -> Result<Encoding, Error> {
    let field = header.require(report, "encoding", "encoding: raw")?;
    match field.text.to_ascii_lowercase().as_str() {
        "raw" => Ok(Encoding::Raw),
        "gzip" | "gz" => Ok(Encoding::Gzip),
        "txt" | "text" | "ascii" => Ok(Encoding::Text),
        "hex" => Ok(Encoding::Hex),
        name @ ("bzip2" | "bz2" | "zrl") => Err(report.unsupported(
            field.place(),
            format!("the encoding `{name}` is not raw, gzip, text or hex"),
            "convert the file, for example by `unu save -f nrrd -e gzip`",
        )),
        other => Err(report.invalid(
            field.place(),
            format!("`{}` is not an encoding", clip(other)),
            "use one of raw, gzip, text, hex",
        )),
    }
}

fn endian(header: &Header, report: Report, sample: SampleType, encoding: Encoding) -> Result<Endian, Error> {
    // Single bytes and digits have no order, whatever the file says of it.
    if sample.size() == 1 || encoding == Encoding::Text {
        return Ok(Endian::Little);
    }
    let Some(field) = header.get("endian") else {
        return Err(report.invalid(
            Place::File,
            format!("the header has no `endian`, which {} samples in {} need", sample.name(), encoding.name()),
            "add a line `endian: little` or `endian: big`",
        ));
    };
    match field.text.to_ascii_lowercase().as_str() {
        "little" => Ok(Endian::Little),
        "big" => Ok(Endian::Big),
        other => Err(report.invalid(
            field.place(),
            format!("`endian: {}` is neither little nor big", clip(other)),
            "use one of the two",
        )),
    }
}

/// The sizes along x, y and z, the number of axes, and the number of points in time.
fn dimensions(header: &Header, report: Report) -> Result<([u32; 3], usize, u64), Error> {
    let field = header.require(report, "dimension", "dimension: 3")?;
    let dimension: usize = field.numbers(report, 1)?[0];
    if !(3..=4).contains(&dimension) {
        return Err(report.unsupported(
            field.place(),
            format!("the data has {dimension} dimensions, and a scalar volume has 3, or 4 with time"),
            "pick out one volume or component first, for example by `unu slice -a AXIS -p INDEX`",
        ));
    }
    let field = header.require(report, "sizes", "sizes: 64 64 64")?;
    let sizes: Vec<u32> = field.numbers(report, dimension)?;
    if sizes.contains(&0) {
        return Err(report.invalid(
            field.place(),
            format!("`sizes: {}` has no voxels", clip(&field.text)),
            "give each axis a size of at least 1",
        ));
    }
    Ok(([sizes[0], sizes[1], sizes[2]], dimension, sizes.get(3).copied().unwrap_or(1).into()))
}

fn skips(header: &Header, report: Report, encoding: Encoding) -> Result<(u64, ByteSkip), Error> {
    let line_skip = match header.get("lineskip") {
        Some(field) => field.numbers(report, 1)?[0],
        None => 0,
    };
    let Some(field) = header.get("byteskip") else {
        return Ok((line_skip, ByteSkip::Forward(0)));
    };
    let skip: i64 = field.numbers(report, 1)?[0];
    match (u64::try_from(skip), encoding) {
        (Ok(skip), _) => Ok((line_skip, ByteSkip::Forward(skip))),
        (Err(_), Encoding::Raw | Encoding::Gzip) if skip == -1 => Ok((line_skip, ByteSkip::FromEnd)),
        _ => Err(report.invalid(
            field.place(),
            format!("`byte skip: {skip}` with {} encoding", encoding.name()),
            "give 0 or more, or -1 with raw or gzip encoding for data at the end of the file",
        )),
    }
}

//! The header of a `.npy` file: a magic string, a length and a Python dictionary.

use std::io::Read;

use super::literal::{self, Literal};
use crate::error::{Error, Place, Report, clip};
use crate::samples::{Endian, SampleType, read_up_to};
use crate::stream;

/// First bytes of every file, before two bytes of version.
pub(super) const MAGIC: &[u8] = b"\x93NUMPY";

/// Largest dictionary in bytes; the dictionary of a plain array has about 100.
const MAX_BYTES: u64 = 1 << 20;

/// What the user says of an array, which tells a last axis of components from one of space.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Wanted<'a> {
    /// What is asked for of the components of voxels.
    pub part: Option<&'a str>,
    /// Whether a point in time is asked for.
    pub time: bool,
}

impl Wanted<'_> {
    /// Whether the last axis has the numbers of a voxel, by what is asked for, or else by the shape: a volume of 3 or 4 voxels along x is
    /// none that anyone looks at, where its other axes are longer.
    fn has_components(self, sizes: &[u64], fortran_order: bool) -> bool {
        let [.., second, third, last] = sizes else { return false };
        if sizes.len() < 4 {
            return false;
        }
        if self.part.is_some() {
            return (2..=MOST_COMPONENTS).contains(last);
        }
        let beside_time = sizes.iter().filter(|&&size| size > 1).count() > 4;
        let like_colors = (3..=4).contains(last) && [second, third].iter().all(|&&size| size > 4);
        !fortran_order && (like_colors && !self.time || beside_time && (2..=4).contains(last))
    }
}

/// A last axis of more is not one of components.
const MOST_COMPONENTS: u64 = 64;

/// A header understood.
#[derive(Debug)]
pub(super) struct Header {
    pub sample: SampleType,
    pub endian: Endian,
    /// `bool` in the file: zeros and ones.
    pub boolean: bool,
    pub fortran_order: bool,
    /// Voxels along x, which changes fastest, y and z.
    pub dimensions: [u32; 3],
    /// Volumes one after the other, along the index that changes slowest; 1 where there is none of time.
    pub times: u64,
    /// Numbers of a voxel along the last index, as those of colours and vectors; 1 of others.
    pub components: u64,
    /// Start of the dictionary.
    pub dictionary: Place,
    /// First byte of the samples.
    pub data_start: u64,
}

impl Header {
    /// `length` is the size of the file.
    pub fn read(reader: &mut dyn Read, length: u64, wanted: Wanted, report: Report) -> Result<Self, Error> {
        let mut start = [0; MAGIC.len() + 2];
        let (_, outcome) = read_up_to(reader, &mut start);
        outcome.map_err(|error| stream::broken(report, 0, error))?;
        if !start.starts_with(MAGIC) {
            return Err(report.invalid(
                Place::Byte(0),
                "this does not start with `\\x93NUMPY`, as a .npy file does",
                "check that the file is whole, and that its extension is right",
            ));
        }
        let (version, minor) = (start[MAGIC.len()], start[MAGIC.len() + 1]);
        let size_bytes = match version {
            1 => 2,
            2 | 3 => 4,
            _ => {
                return Err(report.unsupported(
                    Place::Byte(MAGIC.len() as u64),
                    format!("format version {version}.{minor} is not one of 1.0, 2.0, 3.0"),
                    "write the array anew by numpy.save",
                ));
            }
        };
        let mut size = [0; 4];
        let (_, outcome) = read_up_to(reader, &mut size[..size_bytes]);
        outcome.map_err(|error| stream::broken(report, 0, error))?;
        let size = u64::from(u32::from_le_bytes(size));
        let place = (start.len() + size_bytes) as u64;
        let there = length.saturating_sub(place);
        if size > there.min(MAX_BYTES) {
            return Err(report.invalid(
                Place::Byte(start.len() as u64),
                format!("the header is {size} bytes long, where {there} are there and {MAX_BYTES} are read at most"),
                "get the whole file, or write the array anew by numpy.save",
            ));
        }
        let mut text = Vec::new();
        reader.take(size).read_to_end(&mut text).map_err(|error| stream::broken(report, 0, error))?;
        Self::parse(&String::from_utf8_lossy(&text), Place::Byte(place), place + size, wanted, report)
    }

    fn parse(text: &str, dictionary: Place, data_start: u64, wanted: Wanted, report: Report) -> Result<Self, Error> {
        let entries = literal::dictionary(text).ok_or_else(|| {
            report.invalid(
                dictionary,
                format!("`{}` is not a dictionary such as {{'descr': '<f4', ...}}", clip(text.trim())),
                "write the array anew by numpy.save",
            )
        })?;
        let get = |key: &str| {
            entries.iter().find(|(name, _)| name == key).map(|(_, value)| value).ok_or_else(|| {
                report.invalid(dictionary, format!("the header has no `{key}`"), "write the array anew by numpy.save")
            })
        };
        let (sample, endian, boolean) = sample_type(get("descr")?, dictionary, report)?;
        let &Literal::Bool(fortran_order) = get("fortran_order")? else {
            return Err(report.invalid(dictionary, "`fortran_order` is neither True nor False", "use one of the two"));
        };
        let shape = get("shape")?;
        let (mut sizes, components) = sizes(shape, fortran_order, wanted, dictionary, report)?;
        // The last index of an array in C order changes fastest, and so is x.
        if !fortran_order {
            sizes.reverse();
        }
        let (dimensions, times) = ([sizes[0], sizes[1], sizes[2]], sizes.get(3).copied().unwrap_or(1).into());
        Ok(Self { sample, endian, boolean, fortran_order, dimensions, times, components, dictionary, data_start })
    }

    /// The sample type as NumPy calls it.
    pub fn sample_name(&self) -> &'static str {
        if self.boolean { "bool" } else { self.sample.name() }
    }
}

/// The type, its byte order and whether it is `bool`.
fn sample_type(descr: &Literal, place: Place, report: Report) -> Result<(SampleType, Endian, bool), Error> {
    let advice = "convert it first, for example by `array.astype('float32')`";
    let Literal::Text(text) = descr else {
        let problem = "the samples are records of several fields, not single numbers";
        return Err(report.unsupported(place, problem, "save one field, for example `array['density']`"));
    };
    let (order, kind) = match text.char_indices().nth(1) {
        Some((second, _)) => text.split_at(second),
        None => ("", text.as_str()),
    };
    let sample = match kind {
        "b1" | "u1" => SampleType::U8,
        "i1" => SampleType::I8,
        "u2" => SampleType::U16,
        "i2" => SampleType::I16,
        "u4" => SampleType::U32,
        "i4" => SampleType::I32,
        "u8" => SampleType::U64,
        "i8" => SampleType::I64,
        "f2" => SampleType::F16,
        "f4" => SampleType::F32,
        "f8" => SampleType::F64,
        _ => {
            let problem =
                format!("the samples are `{}`, not bool, or integers or floats of at most 64 bits", clip(text));
            return Err(report.unsupported(place, problem, advice));
        }
    };
    let endian = match order {
        "<" => Endian::Little,
        ">" => Endian::Big,
        // A byte has no order, whatever is said of it.
        "|" | "=" if sample.size() == 1 => Endian::Little,
        _ => {
            return Err(report.invalid(
                place,
                format!("`{}` names no byte order", clip(text)),
                "use < for little-endian, > for big-endian, | for one byte",
            ));
        }
    };
    Ok((sample, endian, kind == "b1"))
}

/// Three sizes, or four with time, without the axes of size 1 that are more than these; and the numbers of a voxel.
fn sizes(
    shape: &Literal,
    fortran_order: bool,
    wanted: Wanted,
    place: Place,
    report: Report,
) -> Result<(Vec<u32>, u64), Error> {
    let Literal::Tuple(sizes) = shape else {
        return Err(report.invalid(place, "`shape` is not a tuple of sizes", "write the array anew by numpy.save"));
    };
    // A last or a first axis of size 1 is of channels or of time; an axis of the volume may have size 1, too.
    let mut sizes = sizes.clone();
    while sizes.len() > 3 && sizes.last() == Some(&1) {
        sizes.pop();
    }
    let components = if wanted.has_components(&sizes, fortran_order) { sizes.pop().unwrap_or(1) } else { 1 };
    while sizes.len() > 3 && sizes.first() == Some(&1) {
        sizes.remove(0);
    }
    while sizes.len() > 4
        && let Some(index) = sizes.iter().position(|&size| size == 1)
    {
        sizes.remove(index);
    }
    if !(3..=4).contains(&sizes.len()) {
        return Err(report.unsupported(
            place,
            format!("the array has {} dimensions, and a scalar volume has 3, or 4 with time", sizes.len()),
            "save one volume of it, or stack slices to one by numpy.stack",
        ));
    }
    let checked = sizes.iter().map(|&size| {
        u32::try_from(size).ok().filter(|&size| size > 0).ok_or_else(|| {
            report.invalid(
                place,
                format!("the shape {sizes:?} has the size {size}, not one from 1 to {}", u32::MAX),
                "save an array with something in it",
            )
        })
    });
    Ok((checked.collect::<Result<_, _>>()?, components))
}

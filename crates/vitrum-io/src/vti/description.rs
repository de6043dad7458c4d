//! Meaning of the attributes of a `.vti` file.

use std::str::FromStr;

use super::layout::{Array, Association, Layout};
use super::xml::Tag;
use crate::arrays;
use crate::components::{self, Components};
use crate::error::clip;
use crate::error::{Error, Report};
use crate::options::OpenOptions;
use crate::orientation::Orientation;
use crate::placement::{Placement, unoriented};
use crate::samples::{Endian, SampleType};
use crate::source::Assumptions;
use crate::stream;
use crate::tolerance;

/// Coding of an array's bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Coding {
    Text,
    Base64,
    Raw,
}

/// Size of the numbers in front of the data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Word {
    U32,
    U64,
}

impl Word {
    pub fn size(self) -> usize {
        match self {
            Self::U32 => 4,
            Self::U64 => 8,
        }
    }
}

/// A document understood: all that reading the data takes.
#[derive(Debug)]
pub(super) struct Description {
    pub sample: SampleType,
    pub endian: Endian,
    /// The components of a voxel, where it has several.
    pub components: Option<Components>,
    /// Bytes of a voxel in the file.
    pub voxel_size: usize,
    pub word: Word,
    pub zlib: bool,
    pub coding: Coding,
    /// Offset of the array's characters or bytes in the file, and their largest number.
    pub start: u64,
    pub length: u64,
    pub dimensions: [u32; 3],
    /// Bytes of data, decoded to the file's sample type.
    pub data_bytes: u64,
    pub placement: Placement,
    pub assumptions: Assumptions,
}

impl Description {
    pub fn new(layout: &Layout, file_length: u64, options: &OpenOptions, report: Report) -> Result<Self, Error> {
        let asked = options.array.as_deref();
        let mut assumptions = Assumptions::default();
        let (array, part) = choose(layout, asked, report, &mut assumptions)?;
        let sample = sample_type(report, array)?;
        let (coding, start, length) = locate(layout, array, file_length, report)?;
        let zlib = coding != Coding::Text && compressed(report, &layout.file)?;
        let endian = endian(report, &layout.file, &mut assumptions)?;
        let word = match layout.file.get("header_type") {
            None | Some("UInt32") => Word::U32,
            Some("UInt64") => Word::U64,
            Some(other) => {
                return Err(report.invalid(
                    layout.file.place(),
                    format!("`header_type` is `{}`, neither UInt32 nor UInt64", clip(other)),
                    "use one of the two",
                ));
            }
        };
        let (dimensions, placement) = grid(report, &layout.image, array.association, options, &mut assumptions)?;
        let components = components_of(report, array, (sample, endian), part, &mut assumptions)?;
        let (.., voxel_size) = components::decoded_as(sample, endian, components);
        let data_bytes = stream::byte_count(dimensions, voxel_size)
            .map_err(|problem| report.invalid(layout.image.place(), problem, "correct `WholeExtent`"))?;
        assumptions.extend(sample.rounding_note());
        assumptions.extend(placement.shear_note());
        Ok(Self {
            sample,
            endian,
            components,
            voxel_size,
            word,
            zlib,
            coding,
            start,
            length,
            dimensions,
            data_bytes,
            placement,
            assumptions,
        })
    }

    pub fn voxel_count(&self) -> u64 {
        self.data_bytes / self.voxel_size as u64
    }

    /// Encoding of the array, such as `appended raw, zlib, little-endian`.
    pub fn encoding(&self) -> String {
        let coding = match self.coding {
            Coding::Text => return "ascii".to_owned(),
            Coding::Base64 => "base64",
            Coding::Raw => "raw",
        };
        format!("{coding}{}, {}", if self.zlib { ", zlib" } else { "" }, self.endian.name())
    }
}

/// The components of an array's voxels, where there are several.
fn components_of(
    report: Report,
    array: &Array,
    decoding: (SampleType, Endian),
    part: Option<&str>,
    assumptions: &mut Assumptions,
) -> Result<Option<Components>, Error> {
    let at = (report, array.tag.place());
    let text = array.tag.get("NumberOfComponents").map_or("1", str::trim);
    let count = text.parse::<u64>().map_err(|_| {
        report.invalid(at.1, format!("`NumberOfComponents` is `{}`, no number", clip(text)), "write a number")
    })?;
    let colors = decoding.0 == SampleType::U8 && (3..=4).contains(&count);
    Components::of_array(at, array.name(), count, colors, decoding, part, assumptions)
}

/// The array of the name that is asked for, and what is asked for of its components, which may stand behind a colon: `velocity:norm`. Else the
/// active scalars, else the first array with one component, at points before in cells; else the first array.
fn choose<'a, 'b>(
    layout: &'a Layout,
    asked: Option<&'b str>,
    report: Report,
    assumptions: &mut Assumptions,
) -> Result<(&'a Array, Option<&'b str>), Error> {
    let all = || {
        [Association::Point, Association::Cell]
            .into_iter()
            .flat_map(|association| layout.arrays.iter().filter(move |array| array.association == association))
    };
    let named = |name: &str| all().find(|array| array.name() == name);
    if let Some(asked) = asked {
        if let Some(array) = named(asked) {
            return Ok((array, None));
        }
        if let Some((name, part)) = asked.rsplit_once(':')
            && let Some(array) = named(name)
        {
            return Ok((array, Some(part)));
        }
        let several =
            all().find(|array| !matches!(array.tag.get("NumberOfComponents").map(str::trim), None | Some("1")));
        return match several.filter(|_| Components::is_part(asked)) {
            Some(array) => Ok((array, Some(asked))),
            None => Err(arrays::unknown(report, asked, all().map(Array::name))),
        };
    }
    match first(layout, report, assumptions) {
        Ok(array) => Ok((array, None)),
        Err(error) => match all().next() {
            Some(array) => {
                note_others(layout, array, assumptions);
                Ok((array, None))
            }
            None => Err(error),
        },
    }
}

/// The active scalars, else the first array with one component; at points before in cells.
fn first<'a>(layout: &'a Layout, report: Report, assumptions: &mut Assumptions) -> Result<&'a Array, Error> {
    let scalar = |array: &&Array| matches!(array.tag.get("NumberOfComponents").map(str::trim), None | Some("1"));
    let of = |association| layout.arrays.iter().filter(move |array| array.association == association);
    for association in [Association::Point, Association::Cell] {
        let active = layout.active.iter().find(|(other, _)| *other == association).map(|(_, name)| name);
        if let Some(array) = active.and_then(|name| of(association).find(|array| array.name() == name)) {
            note_others(layout, array, assumptions);
            return Ok(array);
        }
        if let Some(array) = of(association).find(scalar) {
            if let Some(name) = active {
                assumptions.push(format!("the active scalars `{}` are not there", clip(name)));
            }
            note_others(layout, array, assumptions);
            return Ok(array);
        }
    }
    let names = arrays::listed(layout.arrays.iter().map(Array::name));
    let found = if names.is_empty() { "no array".to_owned() } else { format!("only {names}") };
    Err(report.unsupported(
        layout.image.place(),
        format!("there is no array with one component, {found}"),
        "write a scalar array, for example by ParaView's filter Calculator",
    ))
}

fn note_others(layout: &Layout, array: &Array, assumptions: &mut Assumptions) {
    let others = layout.arrays.iter().filter(|other| !std::ptr::eq(*other, array)).map(Array::name);
    assumptions.extend(arrays::others_note(array.name(), others));
}

fn sample_type(report: Report, array: &Array) -> Result<SampleType, Error> {
    match array.tag.get("type").unwrap_or_default() {
        "Int8" => Ok(SampleType::I8),
        "UInt8" => Ok(SampleType::U8),
        "Int16" => Ok(SampleType::I16),
        "UInt16" => Ok(SampleType::U16),
        "Int32" => Ok(SampleType::I32),
        "UInt32" => Ok(SampleType::U32),
        "Int64" => Ok(SampleType::I64),
        "UInt64" => Ok(SampleType::U64),
        "Float32" => Ok(SampleType::F32),
        "Float64" => Ok(SampleType::F64),
        other => Err(report.unsupported(
            array.tag.place(),
            format!("the type `{}` is not a number's", clip(other)),
            "use one of Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64",
        )),
    }
}

fn locate(layout: &Layout, array: &Array, file_length: u64, report: Report) -> Result<(Coding, u64, u64), Error> {
    let tag = &array.tag;
    // Without any, the check of the length tells what is missing.
    let inline = array.text.map_or((0, 0), |text| (text.start, text.length));
    match tag.get("format").unwrap_or("ascii") {
        "ascii" => Ok((Coding::Text, inline.0, inline.1)),
        "binary" => Ok((Coding::Base64, inline.0, inline.1)),
        "appended" => {
            let Some(appended) = &layout.appended else {
                return Err(report.invalid(
                    tag.place(),
                    "the array's data is appended, and there is no `AppendedData`",
                    "get the whole file",
                ));
            };
            let coding = match appended.tag.get("encoding") {
                Some("raw") => Coding::Raw,
                Some("base64") => Coding::Base64,
                other => {
                    return Err(report.invalid(
                        appended.tag.place(),
                        format!("the encoding `{}` is neither raw nor base64", clip(other.unwrap_or_default())),
                        "use one of the two",
                    ));
                }
            };
            let [offset] = numbers::<u64, 1>(report, tag, "offset", None)?;
            let start = appended.start.saturating_add(offset);
            Ok((coding, start, file_length.saturating_sub(start)))
        }
        other => Err(report.invalid(
            tag.place(),
            format!("the format `{}` is none of ascii, binary, appended", clip(other)),
            "use one of the three",
        )),
    }
}

fn compressed(report: Report, file: &Tag) -> Result<bool, Error> {
    match file.get("compressor") {
        None | Some("") => Ok(false),
        Some("vtkZLibDataCompressor") => Ok(true),
        Some(other) => Err(report.unsupported(
            file.place(),
            format!("the compressor `{}` is not vtkZLibDataCompressor", clip(other)),
            "write the file with ZLib compression, or with none",
        )),
    }
}

fn endian(report: Report, file: &Tag, assumptions: &mut Assumptions) -> Result<Endian, Error> {
    match file.get("byte_order") {
        Some("LittleEndian") => Ok(Endian::Little),
        Some("BigEndian") => Ok(Endian::Big),
        None => {
            assumptions.push("the file says no byte order: little-endian was taken".to_owned());
            Ok(Endian::Little)
        }
        Some(other) => Err(report.invalid(
            file.place(),
            format!("`byte_order` is `{}`, neither LittleEndian nor BigEndian", clip(other)),
            "use one of the two",
        )),
    }
}

fn grid(
    report: Report,
    image: &Tag,
    association: Association,
    options: &OpenOptions,
    assumptions: &mut Assumptions,
) -> Result<([u32; 3], Placement), Error> {
    let extent = numbers::<i32, 6>(report, image, "WholeExtent", None)?.map(i64::from);
    let [low, high] = [0, 1].map(|end| [extent[end], extent[end + 2], extent[end + 4]]);
    let mut dimensions = [0; 3];
    for axis in 0..3 {
        let points = high[axis] - low[axis] + 1;
        // A flat image has cells that are flat.
        let count = if association == Association::Cell && points > 1 { points - 1 } else { points };
        dimensions[axis] = u32::try_from(count).ok().filter(|&count| count > 0).ok_or_else(|| {
            report.invalid(
                image.place(),
                format!("`WholeExtent` from {} to {} along an axis has no voxels", low[axis], high[axis]),
                "write two ends for each axis, the lower one first",
            )
        })?;
    }
    assumptions.note_origin("spacing", "`Spacing` of the image");
    let stated = numbers(report, image, "Spacing", Some([1.0; 3]));
    let spacing = tolerance::steps(tolerance::replaceable(stated, [1.0; 3], options)?, 1.0, options, assumptions);
    let stated = !image.get("Direction").is_none_or(numbers_are_identity);
    let orientation = if stated { Orientation::World } else { Orientation::Unknown };
    assumptions.extend((!stated).then(unoriented));
    if image.get("Spacing").is_none() {
        tolerance::note_unspaced(options, assumptions);
    }
    let direction = numbers(report, image, "Direction", Some([1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]))?;
    let columns: [[f64; 3]; 3] =
        [0, 1, 2].map(|axis| [0, 1, 2].map(|component| direction[3 * component + axis] * spacing[axis]));
    let mut first = low.map(|low| low as f64);
    if association == Association::Cell {
        assumptions.push("the values of the cells were taken at their centres".to_owned());
        (0..3).filter(|&axis| high[axis] > low[axis]).for_each(|axis| first[axis] += 0.5);
    }
    let origin = image.get("Origin").map(|_| numbers(report, image, "Origin", None)).transpose()?;
    let origin = origin.map(|origin: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|component| {
            origin[component] + (0..3).map(|axis| first[axis] * columns[axis][component]).sum::<f64>()
        })
    });
    let placement = Placement::mended(columns, origin, orientation, options, assumptions)
        .map_err(|problem| report.invalid(image.place(), problem, "correct `Direction` or `Origin`"))?;
    Ok((dimensions, placement))
}

/// Whether a direction matrix is the identity, which VTK also writes for an image of unknown orientation.
fn numbers_are_identity(text: &str) -> bool {
    text.split_whitespace().map(str::parse::<f64>).eq([1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0].map(Ok))
}

/// An attribute of exactly `COUNT` numbers.
fn numbers<T: FromStr, const COUNT: usize>(
    report: Report,
    tag: &Tag,
    name: &str,
    default: Option<[T; COUNT]>,
) -> Result<[T; COUNT], Error> {
    let text = match (tag.get(name), default) {
        (None, Some(default)) => return Ok(default),
        (text, _) => text.unwrap_or_default(),
    };
    let parsed = text.split_whitespace().map(str::parse).collect::<Result<Vec<T>, _>>();
    parsed.ok().and_then(|values| values.try_into().ok()).ok_or_else(|| {
        // The types in use are f64 and the integers.
        let whole = if std::any::type_name::<T>().starts_with('f') { "" } else { "whole " };
        let expected = if COUNT == 1 { format!("a {whole}number") } else { format!("{COUNT} {whole}numbers") };
        report.invalid(
            tag.place(),
            format!("`{name}` of `{}` is `{}`, not {expected} in range", tag.name, clip(text)),
            format!("write {expected}"),
        )
    })
}

//! The lines in front of a PLY file's data.

use crate::error::{Error, Place, Report};
use crate::mesh::words::show;
use crate::tolerance::{LeftOut, name};

/// Longest header that is read; real ones are a few hundred bytes.
const MAX_BYTES: usize = 1 << 20;

/// Coding of the data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    Little,
    Big,
}

impl Encoding {
    pub fn describe(self) -> &'static str {
        match self {
            Self::Ascii => "ascii",
            Self::Little => "binary, little-endian",
            Self::Big => "binary, big-endian",
        }
    }
}

/// The type of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn parse(word: &[u8]) -> Option<Self> {
        Some(match word {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::I8 => "char",
            Self::U8 => "uchar",
            Self::I16 => "short",
            Self::U16 => "ushort",
            Self::I32 => "int",
            Self::U32 => "uint",
            Self::F32 => "float",
            Self::F64 => "double",
        }
    }

    /// Size of a number of the type in bytes.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub fn is_float(self) -> bool {
        matches!(self, Self::F32 | Self::F64)
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Scalar(Scalar),
    List { count: Scalar, item: Scalar },
}

#[derive(Debug)]
pub(super) struct Property {
    pub name: String,
    pub kind: Kind,
}

#[derive(Debug)]
pub(super) struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
    /// The header's line that names it.
    pub line: usize,
    /// Why it cannot be read, of an element that no triangle needs.
    pub fault: Option<Error>,
}

impl Element {
    /// Whether triangles are made of it.
    pub fn is_needed(&self) -> bool {
        matches!(self.name.as_str(), "vertex" | "face" | "tristrips")
    }
}

/// A header understood.
#[derive(Debug)]
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Length of the header in bytes.
    pub length: usize,
    pub lines: usize,
    /// Lines without a meaning.
    pub left_out: LeftOut,
}

impl Header {
    pub fn read(bytes: &[u8], report: Report) -> Result<Self, Error> {
        let head = &bytes[..bytes.len().min(MAX_BYTES)];
        // The first line tells how lines end, which matters where bytes follow the last one.
        let end: &[u8] = match head.get(3..5) {
            Some(b"\r\n") => b"\r\n",
            Some([b'\r', _]) => b"\r",
            _ => b"\n",
        };
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        let mut left_out = LeftOut::default();
        let (mut position, mut number) = (0, 0);
        while let Some(length) = find(&head[position..], end) {
            let line = head[position..position + length].trim_ascii();
            position += length + end.len();
            number += 1;
            let place = Place::Line(number);
            let words: Vec<&[u8]> = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).collect();
            match *words {
                [b"ply"] if number == 1 => {}
                [] | [b"comment" | b"obj_info", ..] => {}
                [b"format", kind, _] if encoding.is_none() => encoding = Some(parse_encoding(report, place, kind)?),
                [b"element", element, count] => {
                    elements.push(parse_element(report, number, &elements, element, count)?);
                }
                [b"property", ref rest @ .., property] => {
                    let added = add_property(report, place, elements.last_mut(), rest, property);
                    match (added, elements.last_mut().filter(|element| !element.is_needed())) {
                        (Err(error), Some(element)) => element.fault = element.fault.take().or(Some(error)),
                        (added, _) => added?,
                    }
                }
                [b"end_header"] => {
                    let advice = "add a line such as `format ascii 1.0`";
                    let encoding =
                        encoding.ok_or_else(|| report.invalid(Place::File, "the header has no `format`", advice))?;
                    return Ok(Self { encoding, elements, length: position, lines: number, left_out });
                }
                // A line that begins like one that matters has to be one.
                [b"format" | b"element" | b"property", ..] => {
                    let problem = format!("`{}` is not a line of a PLY header", show(line));
                    return Err(report.invalid(place, problem, "correct the line"));
                }
                _ if number == 1 => {
                    let problem = format!("`{}` is not `ply`", show(line));
                    return Err(report.invalid(place, problem, "check that this is a PLY file"));
                }
                // A comment without its keyword.
                _ => left_out.add("lines of the header without a keyword"),
            }
        }
        let problem = match bytes.len() > MAX_BYTES {
            true => format!("the header goes on beyond {MAX_BYTES} bytes"),
            false => "the header ends without `end_header`".to_owned(),
        };
        Err(report.invalid(Place::Line(number + 1), problem, "check that this is a PLY file, and get the whole of it"))
    }
}

fn find(bytes: &[u8], end: &[u8]) -> Option<usize> {
    bytes.windows(end.len()).position(|window| window == end)
}

fn parse_encoding(report: Report, place: Place, kind: &[u8]) -> Result<Encoding, Error> {
    match kind {
        b"ascii" => Ok(Encoding::Ascii),
        b"binary_little_endian" => Ok(Encoding::Little),
        b"binary_big_endian" => Ok(Encoding::Big),
        _ => {
            let problem = format!("`{}` is not a format", show(kind));
            Err(report.invalid(place, problem, "use one of ascii, binary_little_endian, binary_big_endian"))
        }
    }
}

fn parse_element(
    report: Report,
    line: usize,
    before: &[Element],
    element: &[u8],
    count: &[u8],
) -> Result<Element, Error> {
    let place = Place::Line(line);
    let name = name(element);
    let parsed = std::str::from_utf8(count).ok().and_then(|count| count.parse().ok());
    let Some(count) = parsed else {
        let problem = format!("the count of the element `{}` is `{}`, not a whole number", show(element), show(count));
        return Err(report.invalid(place, problem, "give a whole number from 0 on"));
    };
    if let Some(first) = before.iter().find(|other| other.name == name) {
        let problem = format!("the element `{}` was given in line {} already", show(element), first.line);
        return Err(report.invalid(place, problem, "keep one of the two"));
    }
    Ok(Element { name, count, properties: Vec::new(), line, fault: None })
}

/// `rest` stands between `property` and the name.
fn add_property(
    report: Report,
    place: Place,
    element: Option<&mut Element>,
    rest: &[&[u8]],
    property: &[u8],
) -> Result<(), Error> {
    let Some(element) = element else {
        return Err(report.invalid(place, "a property before the first element", "put an `element` line before it"));
    };
    let scalar = |word: &[u8]| {
        Scalar::parse(word).ok_or_else(|| {
            let problem = format!("`{}` is not a type of a property", show(word));
            let advice = "use one of char, uchar, short, ushort, int, uint, float, double";
            report.invalid(place, problem, advice)
        })
    };
    let kind = match *rest {
        [b"list", count, item] => {
            let (count, item) = (scalar(count)?, scalar(item)?);
            if count.is_float() {
                let problem = format!("a list counted by `{}` numbers", count.name());
                return Err(report.invalid(place, problem, "count it by a type of whole numbers"));
            }
            Kind::List { count, item }
        }
        [kind] => Kind::Scalar(scalar(kind)?),
        _ => {
            let problem = format!("the property `{}` has {} words for its type", show(property), rest.len());
            return Err(report.invalid(place, problem, "write `property TYPE NAME` or `property list TYPE TYPE NAME`"));
        }
    };
    let name = name(property);
    if element.properties.iter().any(|other| other.name == name) {
        let problem = format!("the element `{}` has the property `{name}` already", element.name);
        return Err(report.invalid(place, problem, "keep one of the two"));
    }
    element.properties.push(Property { name, kind });
    Ok(())
}

//! The blocks of data in a legacy VTK file: what each is, and how much room it takes.

use crate::error::{Error, Place, Report, clip};
use crate::samples::SampleType;

/// A row of numbers behind a keyword's line.
#[derive(Debug, Clone)]
pub(super) struct Block {
    /// Empty where it is no array, such as a table of colours.
    pub name: String,
    /// `None` where the type is one that is not read.
    pub sample: Option<SampleType>,
    /// The type as the file calls it.
    pub kind: String,
    /// Values a point.
    pub components: u64,
    /// Whether these are red, green, blue and perhaps opacity, by the keyword.
    pub colors: bool,
    /// Points, or cells.
    pub count: u64,
    /// The line that describes it.
    pub line: usize,
}

impl Block {
    pub fn new(name: &str, kind: &str, components: u64, count: u64, line: usize) -> Self {
        Self {
            name: name.to_owned(),
            sample: sample_type(kind),
            kind: kind.to_owned(),
            components,
            colors: false,
            count,
            line,
        }
    }

    /// Count of its numbers.
    pub fn numbers(&self) -> u64 {
        self.components.saturating_mul(self.count)
    }

    /// Bytes that the numbers take, where that is known.
    pub fn bytes(&self) -> Option<u64> {
        match (self.sample, self.kind.to_ascii_lowercase().as_str()) {
            (Some(sample), _) => self.numbers().checked_mul(sample.size() as u64),
            (None, "bit") => Some(self.numbers().div_ceil(8)),
            // Written as a 32-bit integer.
            (None, "vtkidtype") => self.numbers().checked_mul(4),
            (None, _) => None,
        }
    }

    /// The type of its samples; an error where it is no array of numbers.
    pub fn sample(&self, report: Report) -> Result<SampleType, Error> {
        let place = Place::Line(self.line);
        self.sample.ok_or_else(|| {
            report.unsupported(
                place,
                format!("the type `{}` is not read", clip(&self.kind)),
                "use one of char, unsigned_char, short, unsigned_short, int, unsigned_int, long, unsigned_long, float, \
                 double",
            )
        })
    }
}

fn sample_type(name: &str) -> Option<SampleType> {
    match name.to_ascii_lowercase().as_str() {
        "char" | "signed_char" => Some(SampleType::I8),
        "unsigned_char" => Some(SampleType::U8),
        "short" => Some(SampleType::I16),
        "unsigned_short" => Some(SampleType::U16),
        "int" => Some(SampleType::I32),
        "unsigned_int" => Some(SampleType::U32),
        "long" | "vtktypeint64" => Some(SampleType::I64),
        "unsigned_long" | "vtktypeuint64" => Some(SampleType::U64),
        "float" => Some(SampleType::F32),
        "double" => Some(SampleType::F64),
        _ => None,
    }
}

/// `%20` and the like, by which VTK writes names.
pub(super) fn decoded(name: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = name.as_bytes();
    while let [first, after @ ..] = rest {
        let code = after.get(..2).filter(|_| *first == b'%').and_then(|digits| std::str::from_utf8(digits).ok());
        match code.and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = &after[2..];
            }
            None => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

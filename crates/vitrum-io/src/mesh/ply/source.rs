//! The numbers behind a PLY header, text or bytes.

use super::header::{Encoding, Header, Kind, Scalar};
use crate::error::{Error, Place, Report};
use crate::mesh::words::{Words, show};

/// The position that reading has come to.
#[derive(Debug, Clone)]
pub(super) enum Source<'a> {
    Text { words: Words<'a>, length: usize },
    Bytes { bytes: &'a [u8], position: usize, big: bool },
}

impl<'a> Source<'a> {
    pub fn new(bytes: &'a [u8], header: &Header) -> Self {
        match header.encoding {
            Encoding::Ascii => {
                Self::Text { words: Words::new(bytes, header.length, header.lines + 1), length: bytes.len() }
            }
            encoding => Self::Bytes { bytes, position: header.length, big: encoding == Encoding::Big },
        }
    }

    pub fn place(&self) -> Place {
        match self {
            Self::Text { words, .. } => words.place(),
            Self::Bytes { position, .. } => Place::Byte(*position as u64),
        }
    }

    pub fn bytes_left(&self) -> u64 {
        match self {
            Self::Text { words, length } => (length - words.position()) as u64,
            Self::Bytes { bytes, position, .. } => (bytes.len() - position) as u64,
        }
    }

    /// Bytes that [`Self::least_bytes`] may take: the last word of a text has no separator.
    pub fn left(&self) -> u64 {
        self.bytes_left() + u64::from(matches!(self, Self::Text { .. }))
    }

    /// Fewest bytes of a property: a digit and a separator for each word.
    pub fn least_bytes(&self, kind: Kind) -> u64 {
        match (self, kind) {
            (Self::Text { .. }, _) => 2,
            (Self::Bytes { .. }, Kind::Scalar(scalar) | Kind::List { count: scalar, .. }) => scalar.size() as u64,
        }
    }

    pub fn value(&mut self, report: Report, scalar: Scalar) -> Result<f64, Error> {
        let place = self.place();
        match self {
            Self::Text { words, .. } => {
                let word = words.next().ok_or_else(|| truncated(report, words.place()))?;
                parse(word, scalar).ok_or_else(|| {
                    let problem = format!("`{}` is not a {}", show(word), scalar.name());
                    report.invalid(words.place(), problem, "correct the number, or the type in the header")
                })
            }
            Self::Bytes { bytes, position, big } => {
                let size = scalar.size();
                let found = bytes.get(*position..*position + size).ok_or_else(|| truncated(report, place))?;
                let mut number = [0; 8];
                number[..size].copy_from_slice(found);
                if *big {
                    number[..size].reverse();
                }
                *position += size;
                Ok(decode(number, scalar))
            }
        }
    }

    /// Length of a list, whose items are there as far as sizes tell.
    pub fn list_length(&mut self, report: Report, count: Scalar, item: Scalar) -> Result<u64, Error> {
        let place = self.place();
        let value = self.value(report, count)?;
        // The line of a word is known once it is read.
        let place = if matches!(self, Self::Text { .. }) { self.place() } else { place };
        if value < 0.0 {
            let problem = format!("a list of {value} items");
            return Err(report.invalid(place, problem, "correct the count of the list"));
        }
        // At most 32 bits.
        let length = value as u64;
        if length * self.least_bytes(Kind::Scalar(item)) > self.left() {
            let problem = format!("a list of {length} items, and {} bytes are left", self.bytes_left());
            return Err(report.invalid(place, problem, "correct the count of the list, or get the whole file"));
        }
        Ok(length)
    }

    /// The assumption about bytes behind the last element.
    pub fn surplus_note(&mut self) -> Option<String> {
        let left = self.bytes_left();
        match self {
            Self::Text { words, .. } => {
                let word = words.next()?;
                Some(format!("what follows the last element, from `{}` on, was left unread", show(word)))
            }
            Self::Bytes { .. } => (left > 0).then(|| format!("{left} bytes behind the last element were left unread")),
        }
    }
}

fn truncated(report: Report, place: Place) -> Error {
    report.invalid(place, "the file ends before the last element that its header promises", "get the whole file")
}

fn parse(word: &[u8], scalar: Scalar) -> Option<f64> {
    let word = std::str::from_utf8(word).ok()?;
    match scalar {
        Scalar::I8 => word.parse::<i8>().ok().map(f64::from),
        Scalar::U8 => word.parse::<u8>().ok().map(f64::from),
        Scalar::I16 => word.parse::<i16>().ok().map(f64::from),
        Scalar::U16 => word.parse::<u16>().ok().map(f64::from),
        Scalar::I32 => word.parse::<i32>().ok().map(f64::from),
        Scalar::U32 => word.parse::<u32>().ok().map(f64::from),
        Scalar::F32 => word.parse::<f32>().ok().map(f64::from),
        Scalar::F64 => word.parse::<f64>().ok(),
    }
}

/// A number from its bytes, the lowest first.
fn decode(bytes: [u8; 8], scalar: Scalar) -> f64 {
    let [a, b, c, d, ..] = bytes;
    match scalar {
        Scalar::I8 => f64::from(a as i8),
        Scalar::U8 => f64::from(a),
        Scalar::I16 => f64::from(i16::from_le_bytes([a, b])),
        Scalar::U16 => f64::from(u16::from_le_bytes([a, b])),
        Scalar::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
        Scalar::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
        Scalar::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
        Scalar::F64 => f64::from_le_bytes(bytes),
    }
}

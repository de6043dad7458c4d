//! The lengths that a file's elements say to have, held against the file before anything believes them.
//!
//! The library that reads the elements takes as much memory as they say, up to 4 GiB each.

use std::io::{self, Read, Seek};

use dicom_core::dictionary::{DataDictionary, DataDictionaryEntry};
use dicom_object::{StandardDataDictionary, Tag};

use super::attributes::{DOUBLE_PIXEL_DATA, FLOAT_PIXEL_DATA, PIXEL_DATA};
use super::syntax::{BIG_ENDIAN, IMPLICIT};
use crate::storage::ByteReader;

/// Sequences that lie deeper are no image's.
const MAX_DEPTH: u32 = 32;

/// The length of what ends by a delimiter.
const UNDEFINED: u32 = u32::MAX;

const ITEM: [u16; 2] = [0xfffe, 0xe000];
const ITEM_END: [u16; 2] = [0xfffe, 0xe00d];
const SEQUENCE_END: [u16; 2] = [0xfffe, 0xe0dd];

/// Kinds of values with a length of 16 bits.
#[rustfmt::skip]
const SHORT: [&[u8; 2]; 21] = [
    b"AE", b"AS", b"AT", b"CS", b"DA", b"DS", b"DT", b"FL", b"FD", b"IS", b"LO", b"LT", b"PN", b"SH", b"SL", b"SS", b"ST",
    b"TM", b"UI", b"UL", b"US",
];

/// Kinds of values with a length of 32 bits.
const LONG: [&[u8; 2]; 13] =
    [b"OB", b"OD", b"OF", b"OL", b"OV", b"OW", b"SQ", b"SV", b"UC", b"UN", b"UR", b"UT", b"UV"];

/// Bytes of a number of a value representation; 1 for text and for representations of single bytes.
fn unit(vr: [u8; 2]) -> u32 {
    match &vr {
        b"OW" | b"SS" | b"US" => 2,
        b"AT" | b"FL" | b"OF" | b"OL" | b"SL" | b"UL" => 4,
        b"FD" | b"OD" | b"OV" | b"SV" | b"UV" => 8,
        _ => 1,
    }
}

/// The kind of an element that is not written beside it, as the library that reads it finds it.
fn known_kind([group, element]: [u16; 2]) -> [u8; 2] {
    let tag = Tag(group, element);
    if tag == PIXEL_DATA || (group >> 8 == 0x60 && element == 0x3000) {
        return *b"OW";
    }
    let kind = StandardDataDictionary.by_tag(tag).map(|entry| entry.vr().relaxed().to_bytes());
    kind.unwrap_or(*b"UN")
}

/// Coding of elements.
#[derive(Clone, Copy)]
struct Coding {
    explicit: bool,
    big: bool,
}

/// The elements of pixels in a data set.
#[derive(Debug, Default, Clone, Copy)]
pub(super) struct Found {
    /// Tag and kind of the first that holds pixels: of whole numbers, floats or doubles.
    pub pixels: Option<(Tag, [u8; 2])>,
}

/// Whether two bytes name a kind of value.
pub(super) fn is_kind(bytes: &[u8]) -> bool {
    SHORT.iter().chain(&LONG).any(|kind| kind.as_slice() == bytes)
}

/// Walks through all elements from `start` to `end`; what it found, or the problem, and the byte where it is.
pub(super) fn check(file: ByteReader, start: u64, end: u64, syntax: &str) -> Result<Found, (u64, String)> {
    let mut walk = Walk { file, position: 0, found: Found::default() };
    let coding = Coding { explicit: syntax != IMPLICIT, big: syntax == BIG_ENDIAN };
    let outcome = walk.seek(start).and_then(|()| walk.elements(end, coding, 0, Within::Length));
    outcome.map_err(|problem| (walk.position, problem.0))?;
    Ok(walk.found)
}

/// End of a row of elements.
#[derive(Clone, Copy, PartialEq)]
enum Within {
    /// The length of the items.
    Length,
    /// A delimiter.
    Item,
}

/// A fault of the file.
struct Problem(String);

impl From<io::Error> for Problem {
    fn from(error: io::Error) -> Self {
        Self(error.to_string())
    }
}

struct Walk<'a> {
    file: ByteReader<'a>,
    position: u64,
    found: Found,
}

impl Walk<'_> {
    /// Elements up to `end`, or what ends them before.
    fn elements(&mut self, end: u64, coding: Coding, depth: u32, within: Within) -> Result<(), Problem> {
        if depth > MAX_DEPTH {
            return Err(Problem(format!("sequences lie more than {MAX_DEPTH} deep")));
        }
        // Less than a tag and a length is padding.
        while self.position + 8 <= end {
            let tag = self.tag(coding.big)?;
            if [ITEM_END, SEQUENCE_END].contains(&tag) {
                self.word(coding.big)?;
                if within == Within::Item && tag == ITEM_END {
                    return Ok(());
                }
                return Err(Problem(format!("({:04x},{:04x}) ends what has not begun", tag[0], tag[1])));
            }
            if tag[0] == ITEM[0] {
                return Err(Problem(format!("({:04x},{:04x}) stands in place of an element", tag[0], tag[1])));
            }
            let (vr, length) = self.head(coding, tag)?;
            let of_pixels = [PIXEL_DATA, FLOAT_PIXEL_DATA, DOUBLE_PIXEL_DATA];
            let pixels = of_pixels.contains(&Tag(tag[0], tag[1]));
            if pixels && depth == 0 && self.found.pixels.is_none() {
                self.found.pixels = Some((Tag(tag[0], tag[1]), vr));
            }
            // Items of an unknown value representation are written in implicit VR inside.
            let inside = if vr == *b"UN" { Coding { explicit: false, big: false } } else { coding };
            if length == UNDEFINED {
                self.items(end, inside, depth, pixels, true)?;
                continue;
            }
            let last = self.fits(u64::from(length), end)?;
            // The library takes whole numbers, and what is left over for the next element.
            if length % unit(vr) != 0 {
                let (kind, unit) = (vr.escape_ascii(), unit(vr));
                return Err(Problem(format!("the `{kind}` here has {length} bytes, which are no numbers of {unit}")));
            }
            if !pixels && (vr == *b"SQ" || self.starts_an_item(coding, last)?) {
                self.items(last, inside, depth, false, false)?;
            }
            self.seek(last)?;
        }
        // The library would read on, as if what is around had no end.
        if within == Within::Item || (depth > 0 && self.position < end) {
            return Err(Problem("an item does not end where it should".to_owned()));
        }
        Ok(())
    }

    /// The items of a sequence, or the fragments of compressed pixels, up to `end`, or to their delimiter where they are `delimited`.
    fn items(&mut self, end: u64, coding: Coding, depth: u32, pixels: bool, delimited: bool) -> Result<(), Problem> {
        while self.position + 8 <= end {
            let tag = self.tag(coding.big)?;
            let length = self.word(coding.big)?;
            if tag == SEQUENCE_END {
                return Ok(());
            }
            if tag != ITEM {
                return Err(Problem(format!("({:04x},{:04x}) stands in place of an item", tag[0], tag[1])));
            }
            if length == UNDEFINED {
                self.elements(end, coding, depth + 1, Within::Item)?;
                continue;
            }
            let last = self.fits(u64::from(length), end)?;
            if !pixels {
                self.elements(last, coding, depth + 1, Within::Length)?;
            }
            self.seek(last)?;
        }
        // Pixels may just stop with the file.
        if (delimited && !pixels) || (!delimited && self.position < end) {
            return Err(Problem("a sequence does not end where it should".to_owned()));
        }
        Ok(())
    }

    /// The kind of an element and its length.
    fn head(&mut self, coding: Coding, tag: [u16; 2]) -> Result<([u8; 2], u32), Problem> {
        if !coding.explicit {
            return Ok((known_kind(tag), self.word(coding.big)?));
        }
        let vr: [u8; 2] = self.bytes()?;
        if !vr.iter().all(u8::is_ascii_uppercase) {
            return Err(Problem(format!("`{}` is no kind of value", vr.escape_ascii())));
        }
        if SHORT.contains(&&vr) {
            return Ok((vr, u32::from(self.short(coding.big)?)));
        }
        // All others, those that nobody knows among them.
        self.bytes::<2>()?;
        Ok((if LONG.contains(&&vr) { vr } else { *b"UN" }, self.word(coding.big)?))
    }

    /// The end of a value of `length` bytes, if it is not behind `end`.
    fn fits(&self, length: u64, end: u64) -> Result<u64, Problem> {
        let there = end.saturating_sub(self.position);
        if length > there {
            return Err(Problem(format!("the element here says to have {length} bytes, and {there} are there")));
        }
        Ok(self.position + length)
    }

    /// Whether a value is a sequence that does not say so.
    fn starts_an_item(&mut self, coding: Coding, last: u64) -> Result<bool, Problem> {
        if coding.explicit || self.position + 8 > last {
            return Ok(false);
        }
        let before = self.position;
        let tag = self.tag(coding.big)?;
        self.seek(before)?;
        Ok(tag == ITEM)
    }

    fn seek(&mut self, to: u64) -> Result<(), Problem> {
        let here = self.file.stream_position()?;
        // Both are at most a file's length.
        self.file.seek_relative(to as i64 - here as i64)?;
        self.position = to;
        Ok(())
    }

    fn tag(&mut self, big: bool) -> Result<[u16; 2], Problem> {
        Ok([self.short(big)?, self.short(big)?])
    }

    fn short(&mut self, big: bool) -> Result<u16, Problem> {
        let bytes = self.bytes()?;
        Ok(if big { u16::from_be_bytes(bytes) } else { u16::from_le_bytes(bytes) })
    }

    fn word(&mut self, big: bool) -> Result<u32, Problem> {
        let bytes = self.bytes()?;
        Ok(if big { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) })
    }

    fn bytes<const SIZE: usize>(&mut self) -> Result<[u8; SIZE], Problem> {
        let mut bytes = [0; SIZE];
        self.file.read_exact(&mut bytes)?;
        self.position += SIZE as u64;
        Ok(bytes)
    }
}

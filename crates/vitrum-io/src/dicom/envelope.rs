//! The envelope of a DICOM file: where its data set begins, and how that is written. Files without a preamble, without the letters
//! `DICM` or without the first group are common, as are mistakes in that group, which decides nothing but the transfer syntax.

use std::io::{self, Cursor, Read, Seek, SeekFrom};

use dicom_object::{DefaultDicomObject, OpenFileOptions, Tag};
use flate2::read::DeflateDecoder;

use super::header::damaged;
use super::lengths::{self, Found};
use super::search::MAGIC;
use super::syntax::{BIG_ENDIAN, DEFLATED, EXPLICIT, IMPLICIT};
use crate::error::{Error, Place, Report};
use crate::memory;
use crate::samples::read_up_to;
use crate::storage::{ByteReader, Storage};
use crate::stream;

/// The last of the tags before those of pixels, at which the reading of a header ends.
const BEFORE_PIXELS: Tag = Tag(0x7fe0, 0x0001);

/// The data set of a file.
pub(super) struct Envelope<'a> {
    storage: Storage<'a>,
    /// The data set, where it was deflated.
    inflated: Option<Vec<u8>>,
    /// First byte of the data set, and its end.
    start: u64,
    end: u64,
    /// The transfer syntax in which the data set is written here.
    pub syntax: String,
    /// The transfer syntax that the file says to have, or that its elements show.
    pub stated: String,
    /// The pixels that were found.
    pub found: Found,
}

impl<'a> Envelope<'a> {
    /// Finds the data set, and holds its lengths against the file.
    pub fn open(storage: &Storage<'a>, length: u64, report: Report) -> Result<Self, Error> {
        let unreadable = |error| report.unreadable(error);
        let broken = |(byte, problem): (u64, String)| {
            report.invalid(Place::Byte(byte), problem, "get the whole file, or write it anew")
        };
        let mut file = storage.open().map_err(unreadable)?;
        let (start, stated) = first_group(&mut file, length).map_err(unreadable)?;
        let mut envelope = Self {
            storage: storage.clone(),
            inflated: None,
            start,
            end: length,
            syntax: stated.clone(),
            stated,
            found: Found::default(),
        };
        if envelope.stated == DEFLATED {
            envelope.inflate(report)?;
            envelope.syntax = EXPLICIT.to_owned();
        }
        let seen = seen(&mut envelope.data(report)?).map_err(unreadable)?;
        let is_raw = [IMPLICIT, EXPLICIT, BIG_ENDIAN].contains(&envelope.syntax.as_str());
        // What is there goes before what is said.
        if let Some(seen) = seen.filter(|seen| envelope.syntax.is_empty() || is_raw && envelope.syntax != *seen) {
            envelope.syntax = seen.to_owned();
            if envelope.stated != DEFLATED {
                envelope.stated = seen.to_owned();
            }
        }
        let (start, end) = (envelope.start, envelope.end);
        envelope.found = lengths::check(envelope.reader(report)?, start, end, &envelope.syntax).map_err(broken)?;
        Ok(envelope)
    }

    /// Takes the data set out of its deflated stream, as far as memory allows.
    fn inflate(&mut self, report: Report) -> Result<(), Error> {
        let limit = memory::available();
        let mut bytes = Vec::new();
        let mut stream = DeflateDecoder::new(self.data(report)?);
        let mut chunk = vec![0; 64 * 1024];
        loop {
            let (count, outcome) = read_up_to(&mut stream, &mut chunk);
            outcome.map_err(|error| stream::broken(report, bytes.len() as u64, error))?;
            let needed = (bytes.len() + count) as u64;
            let refuse = || report.too_large(needed, limit, "that is the memory available now: free some first");
            if needed > limit {
                return Err(refuse());
            }
            bytes.try_reserve(count).map_err(|_| refuse())?;
            bytes.extend_from_slice(&chunk[..count]);
            if count < chunk.len() {
                break;
            }
        }
        (self.start, self.end) = (0, bytes.len() as u64);
        self.inflated = Some(bytes);
        Ok(())
    }

    /// All bytes around the data set.
    fn reader(&self, report: Report) -> Result<ByteReader<'_>, Error> {
        match &self.inflated {
            Some(bytes) => Ok(ByteReader::Memory(Cursor::new(bytes.as_slice()))),
            None => self.storage.open().map_err(|error| report.unreadable(error)),
        }
    }

    /// The bytes of the data set.
    fn data(&self, report: Report) -> Result<ByteReader<'_>, Error> {
        let mut reader = self.reader(report)?;
        reader.seek(SeekFrom::Start(self.start)).map_err(|error| report.unreadable(error))?;
        Ok(reader)
    }

    /// The elements before those of pixels, or all of them.
    pub fn object(&self, report: Report, with_pixels: bool) -> Result<DefaultDicomObject, Error> {
        let options = OpenFileOptions::new();
        let options = if with_pixels { options } else { options.read_until(BEFORE_PIXELS) };
        let reader = Cursor::new(first_bytes(&self.syntax)).chain(self.data(report)?);
        options.from_reader(reader).map_err(|error| damaged(report, &error))
    }
}

/// A preamble and a first group for the library that reads the data set behind them.
fn first_bytes(syntax: &str) -> Vec<u8> {
    let mut name = syntax.as_bytes().to_vec();
    name.resize(name.len().next_multiple_of(2), 0);
    let mut bytes = vec![0; MAGIC.start];
    bytes.extend(b"DICM");
    // Fewer bytes than 16 bits count: a syntax comes from an element of such a length.
    bytes.extend([2, 0, 0, 0, b'U', b'L', 4, 0]);
    bytes.extend((name.len() as u32 + 8).to_le_bytes());
    bytes.extend([2, 0, 0x10, 0, b'U', b'I']);
    bytes.extend((name.len() as u16).to_le_bytes());
    bytes.extend(name);
    bytes
}

/// The first byte of the data set, and the transfer syntax, empty where the file says none.
fn first_group(file: &mut ByteReader, length: u64) -> io::Result<(u64, String)> {
    let mut head = [0; MAGIC.end];
    let (count, outcome) = read_up_to(file, &mut head);
    outcome?;
    let head = &head[..count];
    let mut position = match head {
        head if head.get(MAGIC) == Some(b"DICM") => MAGIC.end as u64,
        [b'D', b'I', b'C', b'M', ..] => 4,
        _ => 0,
    };
    let mut syntax = String::new();
    loop {
        file.seek(SeekFrom::Start(position))?;
        let mut element = [0; 12];
        let (count, outcome) = read_up_to(file, &mut element);
        outcome?;
        // The group is written in explicit VR, little-endian, whatever follows it.
        if count < 8 || element[..2] != [2, 0] || !element[4..6].iter().all(u8::is_ascii_uppercase) {
            return Ok((position, syntax));
        }
        let (start, size) = if matches!(&element[4..6], b"OB" | b"OW" | b"UN" | b"UT" | b"SQ") {
            (12, u64::from(u32::from_le_bytes([element[8], element[9], element[10], element[11]])))
        } else {
            (8, u64::from(u16::from_le_bytes([element[6], element[7]])))
        };
        let value = position + start;
        if value + size > length {
            return Ok((length, syntax));
        }
        if element[2..4] == [0x10, 0] {
            let mut text = vec![0; usize::try_from(size).unwrap_or(0).min(64)];
            file.seek(SeekFrom::Start(value))?;
            let (count, outcome) = read_up_to(file, &mut text);
            outcome?;
            syntax = String::from_utf8_lossy(&text[..count]).trim_matches(['\0', ' ']).to_owned();
        }
        position = value + size;
    }
}

/// The uncompressed transfer syntax that the first element of a data set shows; `None` where it shows none.
fn seen(data: &mut ByteReader) -> io::Result<Option<&'static str>> {
    let mut element = [0; 8];
    let (count, outcome) = read_up_to(data, &mut element);
    outcome?;
    Ok(if count < element.len() { None } else { coding(&element) })
}

/// The transfer syntax of an element of one of the first groups.
pub(super) fn coding(element: &[u8]) -> Option<&'static str> {
    let [low, high, ..] = *element else { return None };
    let kind = element.get(4..6)?;
    let explicit = lengths::is_kind(kind);
    match (low, high, explicit) {
        (1..=0x40, 0, true) => Some(EXPLICIT),
        (1..=0x40, 0, false) => Some(IMPLICIT),
        (0, 1..=0x40, true) => Some(BIG_ENDIAN),
        _ => None,
    }
}

/// Whether a file without preamble and letters begins as a data set does: two elements in their order, of short values.
pub(super) fn begins_data_set(head: &[u8]) -> bool {
    let tag = |at: usize| -> Option<[u16; 2]> {
        let bytes = head.get(at..at + 4)?;
        Some([u16::from_le_bytes([bytes[0], bytes[1]]), u16::from_le_bytes([bytes[2], bytes[3]])])
    };
    let Some(first @ [2 | 8, 0..=0x60]) = tag(0) else { return false };
    let length = match coding(head) {
        Some(EXPLICIT) => head.get(6..8).map(|bytes| u32::from(u16::from_le_bytes([bytes[0], bytes[1]]))),
        Some(IMPLICIT) => head.get(4..8).map(|bytes| u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
        _ => None,
    };
    let Some(length @ 0..=100) = length else { return false };
    let second = 8 + length as usize;
    let same = head.get(second..).and_then(coding) == coding(head);
    length % 2 == 0 && same && tag(second).is_some_and(|next| next > first && next[0] <= 0x20)
}

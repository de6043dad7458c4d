//! XML read event by event, with bounds: no entities, little depth, and a limit to all but the data.

use std::io::{self, BufRead, Read};

use quick_xml::Reader;
use quick_xml::XmlVersion;
use quick_xml::events::{BytesStart, Event};

use crate::error::clip;
use crate::error::{Error, Place, Report};
use crate::tolerance::BYTE_ORDER_MARK;

/// Largest size of the markup in bytes, without the data; real files have a few thousand.
const MAX_BYTES: u64 = 4 << 20;

/// Real files nest 7 elements.
const MAX_DEPTH: usize = 32;

/// An element's start.
#[derive(Debug, Clone)]
pub(super) struct Tag {
    pub name: String,
    attributes: Vec<(String, String)>,
    pub line: usize,
}

impl Tag {
    pub fn get(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(other, _)| other == name).map(|(_, value)| value.as_str())
    }

    pub fn place(&self) -> Place {
        Place::Line(self.line)
    }
}

/// Place of an element's text in the file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Text {
    pub start: u64,
    pub length: u64,
    /// Whether the text is white space alone.
    pub blank: bool,
}

/// Next tag of the document; text is skipped.
pub(super) enum Step {
    Start(Tag),
    End,
    /// The end of the document.
    Done,
}

/// Steps through a document's elements.
pub(super) struct Document<'a, R> {
    reader: Reader<Metered<R>>,
    report: Report<'a>,
    open: Vec<String>,
    /// An element without content ends before anything else is read.
    empty: bool,
    /// Bytes of a mark in front.
    before: u64,
}

impl<'a, R: BufRead> Document<'a, R> {
    pub fn new(mut reader: R, report: Report<'a>) -> Self {
        // The library leaves a mark out of its positions.
        let mark = reader.fill_buf().is_ok_and(|bytes| bytes.starts_with(BYTE_ORDER_MARK));
        let before = if mark { BYTE_ORDER_MARK.len() } else { 0 };
        reader.consume(before);
        let reader = Metered { inner: reader, line: 1, allowance: Some(MAX_BYTES), checked: 0, mended: Vec::new() };
        Self { reader: Reader::from_reader(reader), report, open: vec![], empty: false, before: before as u64 }
    }

    /// Names of the elements around the current place, outermost first.
    pub fn open(&self) -> &[String] {
        &self.open
    }

    pub fn next(&mut self) -> Result<Step, Error> {
        if self.empty {
            self.empty = false;
            self.open.pop();
            return Ok(Step::End);
        }
        let mut buffer = Vec::new();
        loop {
            buffer.clear();
            let line = self.reader.get_ref().line;
            let event = self.reader.read_event_into(&mut buffer).map_err(|error| self.report_of(line, error))?;
            let (start, empty) = match event {
                Event::Start(start) => (start, false),
                Event::Empty(start) => (start, true),
                Event::End(_) => {
                    self.open.pop();
                    return Ok(Step::End);
                }
                Event::Eof => {
                    return match self.open.last() {
                        None => Ok(Step::Done),
                        Some(name) => Err(self.report.invalid(
                            Place::Line(line),
                            format!("the file ends inside of `{}`", clip(name)),
                            "get the whole file",
                        )),
                    };
                }
                Event::DocType(_) | Event::GeneralRef(_) => {
                    return Err(self.report.unsupported(
                        Place::Line(line),
                        "document types and entities are not read",
                        "write the file by VTK, which uses neither",
                    ));
                }
                _ => continue,
            };
            let tag = tag(self.report, &start, line)?;
            if self.open.len() == MAX_DEPTH {
                return Err(self.report.invalid(
                    Place::Line(line),
                    format!("elements lie more than {MAX_DEPTH} deep"),
                    "write the file by VTK, which nests 7",
                ));
            }
            self.open.push(tag.name.clone());
            self.empty = empty;
            return Ok(Step::Start(tag));
        }
    }

    /// Skips to the next markup, however far that is.
    pub fn skip_text(&mut self) -> Result<Text, Error> {
        let start = self.before + self.reader.buffer_position();
        let mut text = Text { start, length: 0, blank: true };
        if self.empty {
            return Ok(text);
        }
        let report = self.report;
        let mut stream = self.reader.stream();
        let allowance = stream.get_mut().allowance.take();
        loop {
            let bytes = match stream.fill_buf() {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                other => other.map_err(|error| report.unreadable(error))?,
            };
            let end = bytes.iter().position(|&byte| byte == b'<');
            let count = end.unwrap_or(bytes.len());
            text.blank = text.blank && bytes[..count].iter().all(u8::is_ascii_whitespace);
            text.length += count as u64;
            stream.consume(count);
            if end.is_some() || count == 0 {
                break;
            }
        }
        stream.get_mut().allowance = allowance;
        Ok(text)
    }

    /// The position behind the next byte that is no white space, where that is `expected`.
    pub fn find(&mut self, expected: u8) -> Result<Option<u64>, Error> {
        let (report, before) = (self.report, self.before);
        let mut stream = self.reader.stream();
        for byte in stream.by_ref().bytes() {
            let byte = byte.map_err(|error| report.unreadable(error))?;
            if !byte.is_ascii_whitespace() {
                return Ok((byte == expected).then_some(before + stream.offset()));
            }
        }
        Ok(None)
    }

    fn report_of(&self, line: usize, error: quick_xml::Error) -> Error {
        match error {
            quick_xml::Error::Io(error) if error.kind() != io::ErrorKind::InvalidData => {
                self.report.unreadable(io::Error::new(error.kind(), error.to_string()))
            }
            error => self.report.invalid(
                Place::Line(line),
                format!("this is not well-formed XML: {}", clip(&error.to_string())),
                "get the whole file, or write it anew",
            ),
        }
    }
}

fn tag(report: Report, start: &BytesStart, line: usize) -> Result<Tag, Error> {
    let invalid = |problem: String| {
        report.invalid(
            Place::Line(line),
            format!("an attribute is not well-formed: {}", clip(&problem)),
            "write it as name=\"value\"",
        )
    };
    let mut attributes = Vec::new();
    // The crate compares each name with all before it, which takes too long for a million of them.
    for attribute in start.attributes().with_checks(false) {
        let attribute = attribute.map_err(|error| invalid(error.to_string()))?;
        let value = attribute.normalized_value(XmlVersion::Implicit1_0).map_err(|error| invalid(error.to_string()))?;
        attributes.push((attribute.key.as_ref().to_owned(), value.into_owned()));
    }
    Ok(Tag { name: start.name().as_ref().to_owned(), attributes, line })
}

/// Counts lines, and ends in an error behind `allowance` bytes.
struct Metered<R> {
    inner: R,
    line: usize,
    /// `None` while data is skipped.
    allowance: Option<u64>,
    /// How many of the buffered bytes were looked at.
    checked: usize,
    /// These bytes, where some of them are not UTF-8.
    mended: Vec<u8>,
}

/// The place of the next byte that is no part of a letter in UTF-8; letters may begin before the bytes and end behind them.
fn not_utf8(bytes: &[u8], from: usize) -> Option<usize> {
    const CONTINUED: std::ops::Range<u8> = 0x80..0xc0;
    // Of a letter that begins before, at most three bytes.
    let begun = bytes.iter().take(3).take_while(|byte| CONTINUED.contains(byte)).count();
    let from = from.max(begun);
    let wrong = std::str::from_utf8(bytes.get(from..)?).err()?;
    wrong.error_len().map(|_| from + wrong.valid_up_to())
}

impl<R: BufRead> BufRead for Metered<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.allowance == Some(0) {
            let problem = format!("the markup goes on beyond {MAX_BYTES} bytes");
            return Err(io::Error::new(io::ErrorKind::InvalidData, problem));
        }
        // A source in memory has all of its bytes buffered.
        const WINDOW: usize = 1 << 16;
        let bytes = self.inner.fill_buf()?;
        let Some(most) = self.allowance else { return Ok(bytes) };
        if self.checked == 0 {
            let window = &bytes[..bytes.len().min(WINDOW)];
            self.checked = window.len();
            let mut wrong = not_utf8(window, 0);
            if wrong.is_some() {
                self.mended.extend_from_slice(window);
            }
            // Comments and names of people are in any encoding; places in the file stay as they are.
            while let Some(at) = wrong {
                self.mended[at] = b'?';
                wrong = not_utf8(&self.mended, at + 1);
            }
        }
        // The bytes that are left of those that were looked at.
        let left = if self.mended.is_empty() {
            &bytes[..self.checked.min(bytes.len())]
        } else {
            &self.mended[self.mended.len() - self.checked..]
        };
        Ok(&left[..left.len().min(usize::try_from(most).unwrap_or(usize::MAX))])
    }

    fn consume(&mut self, count: usize) {
        // The consumed bytes were buffered before, so that nothing is read here.
        if let Ok(bytes) = self.inner.fill_buf() {
            self.line += bytes.iter().take(count).filter(|&&byte| byte == b'\n').count();
        }
        if let Some(allowance) = &mut self.allowance {
            *allowance = allowance.saturating_sub(count as u64);
        }
        self.checked = self.checked.saturating_sub(count);
        if self.checked == 0 {
            self.mended.clear();
        }
        self.inner.consume(count);
    }
}

impl<R: BufRead> Read for Metered<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}

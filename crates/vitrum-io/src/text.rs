//! Text in files: header lines and lists of numbers.

use std::io::{self, BufRead, Take};

use crate::error::{Error, Place, Report, clip};
use crate::samples::{SampleType, VoxelBuffer};
use crate::tolerance::BYTE_ORDER_MARK;

/// A header's lines without their ends, LF or CRLF.
pub(crate) struct Lines<'a, R> {
    reader: Take<R>,
    report: Report<'a>,
    most: u64,
    advice: &'static str,
    /// The last line's number, counted from 1.
    pub number: usize,
    /// Bytes read, line ends included.
    pub length: u64,
}

impl<'a, R: BufRead> Lines<'a, R> {
    /// A reader of lines that together have at most `most` bytes; `advice` is the advice for a longer file.
    pub fn new(reader: R, report: Report<'a>, most: u64, advice: &'static str) -> Self {
        Self { reader: reader.take(most), report, most, advice, number: 0, length: 0 }
    }

    pub fn next(&mut self) -> Result<Option<String>, Error> {
        let mut bytes = Vec::new();
        let read = self.reader.read_until(b'\n', &mut bytes);
        let count = read.map_err(|error| self.report.unreadable(error))?;
        self.number += 1;
        self.length += count as u64;
        if count == 0 && self.length == self.most {
            let problem = format!("the header goes on beyond {} bytes", self.most);
            return Err(self.report.invalid(Place::Line(self.number), problem, self.advice));
        }
        if bytes.last() == Some(&b'\n') {
            bytes.pop();
            if bytes.last() == Some(&b'\r') {
                bytes.pop();
            }
        }
        if self.number == 1 && bytes.starts_with(BYTE_ORDER_MARK) {
            bytes.drain(..BYTE_ORDER_MARK.len());
        }
        // Comments are in any encoding; everything that matters is ASCII.
        Ok((count > 0).then(|| String::from_utf8_lossy(&bytes).into_owned()))
    }
}

/// Fails where `available` bytes cannot hold `count` numbers: a digit each, and separators between.
pub(crate) fn check_text_length(report: Report, count: u64, start: u64, available: u64) -> Result<(), Error> {
    if available < count.saturating_mul(2).saturating_sub(1) {
        return Err(report.invalid(
            Place::Byte(start),
            format!("the header promises {count} numbers from here, and {available} bytes are there"),
            "correct the sizes in the header, or get the whole file",
        ));
    }
    Ok(())
}

/// The error of a word behind the last expected number.
pub(crate) fn surplus(report: Report, word: &str, count: usize) -> Error {
    report.invalid(
        Place::File,
        format!("`{}` follows the {count} numbers that the header promises", clip(word)),
        "correct the sizes in the header",
    )
}

/// Decodes `count` decimal numbers, separated by white space or commas, and leaves what follows them unread.
pub(crate) fn read_numbers(
    report: Report,
    voxels: &mut VoxelBuffer,
    reader: &mut impl BufRead,
    count: usize,
    sample: SampleType,
) -> Result<(), Error> {
    for index in 0..count {
        let Some(word) = next_word(reader).map_err(|error| report.unreadable(error))? else {
            return Err(too_few(report, count, index));
        };
        voxels.append_text(&word).ok_or_else(|| no_number(report, index, &word, sample))?;
    }
    Ok(())
}

/// The error of numbers that end before their end.
pub(crate) fn too_few(report: Report, count: usize, found: usize) -> Error {
    report.invalid(
        Place::File,
        format!("the header promises {count} numbers, {found} were found"),
        "correct the sizes in the header, or get the whole file",
    )
}

/// The error of a word that is no number of its type.
pub(crate) fn no_number(report: Report, index: usize, word: &str, sample: SampleType) -> Error {
    report.invalid(
        Place::File,
        format!("number {} of the data, `{}`, is not a {}", index + 1, clip(word), sample.name()),
        "correct it, or the type in the header",
    )
}

/// Passes over `count` words.
pub(crate) fn skip_numbers(report: Report, reader: &mut impl BufRead, count: u64) -> Result<(), Error> {
    for index in 0..count {
        if next_word(reader).map_err(|error| report.unreadable(error))?.is_none() {
            return Err(report.invalid(
                Place::File,
                format!("{count} numbers are to be skipped, {index} were found"),
                "correct the sizes in the header, or get the whole file",
            ));
        }
    }
    Ok(())
}

/// The next word; `None` at the end. Cut off behind 64 bytes: no number is longer.
pub(crate) fn next_word(reader: &mut impl BufRead) -> io::Result<Option<String>> {
    const LONGEST: usize = 64;
    let mut word = Vec::new();
    loop {
        let buffer = match reader.fill_buf() {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            other => other?,
        };
        let Some(&byte) = buffer.first() else { break };
        let separates = byte.is_ascii_whitespace() || byte == b',';
        if separates && !word.is_empty() || word.len() >= LONGEST {
            break;
        }
        if !separates {
            word.push(byte);
        }
        reader.consume(1);
    }
    Ok((!word.is_empty()).then(|| String::from_utf8_lossy(&word).into_owned()))
}

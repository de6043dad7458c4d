//! Text in words, with the line that each stands in.

use crate::error::{Error, Place, Report, clip};

/// The words of a text, in which any white space separates.
#[derive(Debug, Clone)]
pub(super) struct Words<'a> {
    bytes: &'a [u8],
    position: usize,
    /// The line of the last word, counted from 1.
    pub line: usize,
}

impl<'a> Words<'a> {
    /// The words from a position on, which stands in `line`.
    pub fn new(bytes: &'a [u8], position: usize, line: usize) -> Self {
        Self { bytes, position, line }
    }

    pub fn place(&self) -> Place {
        Place::Line(self.line)
    }

    /// Count of the bytes that were read.
    pub fn position(&self) -> usize {
        self.position
    }

    /// The next word; `None` at the end.
    pub fn next(&mut self) -> Option<&'a [u8]> {
        loop {
            let byte = *self.bytes.get(self.position)?;
            if !byte.is_ascii_whitespace() {
                break;
            }
            self.position += 1;
            // A carriage return ends a line of its own unless a line feed follows.
            if byte == b'\n' || byte == b'\r' && self.bytes.get(self.position) != Some(&b'\n') {
                self.line += 1;
            }
        }
        let rest = &self.bytes[self.position..];
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        self.position += length;
        Some(&rest[..length])
    }

    /// Leaves out the rest of the line.
    pub fn skip_line(&mut self) {
        let rest = &self.bytes[self.position..];
        self.position += rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
    }
}

/// A word of a file for a message.
pub(super) fn show(word: &[u8]) -> String {
    // No message shows more, and a character takes 4 bytes at most.
    clip(&String::from_utf8_lossy(&word[..word.len().min(400)]))
}

/// A float32, which may be NaN where the word says so, or is infinite; `None` where it is no number.
pub(super) fn any_number(word: &[u8]) -> Option<f32> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// A finite float32.
pub(super) fn number(report: Report, place: Place, word: &[u8]) -> Result<f32, Error> {
    any_number(word).filter(|value| value.is_finite()).ok_or_else(|| {
        let problem = format!("`{}` is not a finite number within float32", show(word));
        report.invalid(place, problem, "correct the number")
    })
}

//! Lines of OBJ and MTL files: a keyword, and what follows it.

use std::borrow::Cow;

use crate::error::{Error, Place, Report};
use crate::mesh::words::{any_number, number, show};

/// The statements of a file. Not an iterator, as each lives until the next: lines may have to be joined.
pub(super) struct Statements<'a> {
    rest: &'a [u8],
    lines: usize,
    current: Cow<'a, [u8]>,
}

/// One line, or several that end in a backslash but for the last.
pub(super) struct Statement<'a> {
    pub keyword: &'a [u8],
    /// Arguments of the statement, without white space at the ends.
    pub rest: &'a [u8],
    /// The number of its first line, counted from 1.
    pub line: usize,
}

impl<'a> Statements<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        // The mark that some editors put in front of UTF-8.
        Self { rest: bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes), lines: 0, current: Cow::Borrowed(&[]) }
    }

    /// The next line that is neither empty nor a comment.
    pub fn next(&mut self) -> Option<Statement<'_>> {
        let line = loop {
            let line = self.lines + 1;
            self.current = self.logical_line()?;
            let text = self.current.trim_ascii();
            if !text.is_empty() && text[0] != b'#' {
                break line;
            }
        };
        let text = self.current.trim_ascii();
        let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
        Some(Statement { keyword: &text[..end], rest: text[end..].trim_ascii(), line })
    }

    fn logical_line(&mut self) -> Option<Cow<'a, [u8]>> {
        let first = self.line()?;
        let Some(mut part) = first.trim_ascii_end().strip_suffix(b"\\") else {
            return Some(Cow::Borrowed(first));
        };
        let mut joined = Vec::new();
        loop {
            joined.extend_from_slice(part);
            joined.push(b' ');
            let Some(line) = self.line() else { break };
            match line.trim_ascii_end().strip_suffix(b"\\") {
                Some(more) => part = more,
                None => {
                    joined.extend_from_slice(line);
                    break;
                }
            }
        }
        Some(Cow::Owned(joined))
    }

    fn line(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        let length = self.rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(self.rest.len());
        let (line, rest) = self.rest.split_at(length);
        let end = if rest.starts_with(b"\r\n") { 2 } else { rest.len().min(1) };
        self.rest = &rest[end..];
        self.lines += 1;
        Some(line)
    }
}

impl<'a> Statement<'a> {
    pub fn place(&self) -> Place {
        Place::Line(self.line)
    }

    /// The words behind the keyword, up to a comment.
    pub fn words(&self) -> impl Iterator<Item = &'a [u8]> + use<'a> {
        let words = self.rest.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        words.take_while(|word| word[0] != b'#')
    }

    /// The numbers of a position, which may be NaN, as long as no face needs it, and of what follows it; their count is 8 at most.
    pub fn position(&self, report: Report) -> Result<([f32; 8], usize), Error> {
        let mut numbers = [f32::NAN; 8];
        let mut count = 0;
        for word in self.words().take(8) {
            match any_number(word) {
                Some(value) => numbers[count] = value,
                None if count < 3 => {
                    return Err(number(report, self.place(), word).err().unwrap_or_else(|| self.short(report, count)));
                }
                // A comment without its mark, or the like.
                None => break,
            }
            count += 1;
        }
        if count < 3 { Err(self.short(report, count)) } else { Ok((numbers, count)) }
    }

    fn short(&self, report: Report, count: usize) -> Error {
        let problem = format!("`{}` has {count} numbers, not 3 and more", show(self.keyword));
        report.invalid(self.place(), problem, "correct the line, or get the whole file")
    }
}

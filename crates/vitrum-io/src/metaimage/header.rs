//! The lines of a MetaImage header, without their meaning.

use std::io::BufRead;

use super::description::KNOWN;
use crate::detached::List;
use crate::error::{Error, Place, Report, clip};
use crate::fields::{Field, Fields, MAX_BYTES};
use crate::text::Lines;
use crate::tolerance::LeftOut;

/// The fields of a header, up to `ElementDataFile`, which is the last.
#[derive(Debug)]
pub(super) struct Header {
    pub fields: Fields,
    pub data_file: Field,
    /// The lines behind `ElementDataFile = LIST`.
    pub listed_files: Vec<String>,
    /// Bytes that the header takes, its last line end included.
    pub length: u64,
    /// Lines without a meaning.
    pub left_out: LeftOut,
}

impl Header {
    pub fn read(reader: impl BufRead, report: Report) -> Result<Self, Error> {
        let mut lines =
            Lines::new(reader, report, MAX_BYTES, "end it by a line `ElementDataFile = LOCAL` or the data file's name");
        let mut fields = Fields::default();
        let mut left_out = LeftOut::default();
        while let Some(line) = lines.next()? {
            if line.trim().is_empty() {
                continue;
            }
            let Some(field) = field(&line, lines.number) else {
                // A line that begins like one that matters has to be one.
                let first = line.split_whitespace().next().unwrap_or_default();
                if KNOWN.iter().any(|known| known.eq_ignore_ascii_case(first)) {
                    return Err(report.invalid(
                        Place::Line(lines.number),
                        format!("`{}` is not `Name = value`", clip(&line)),
                        "correct the line, or make it a `Comment = ...`",
                    ));
                }
                left_out.add("lines of the header that are not `Name = value`");
                continue;
            };
            if field.name.eq_ignore_ascii_case("ElementDataFile") {
                let length = lines.length;
                let mut listed_files = vec![];
                while List::begins(&field)
                    && let Some(line) = lines.next()?
                {
                    listed_files.extend(Some(line.trim().to_owned()).filter(|name| !name.is_empty()));
                }
                return Ok(Self { fields, data_file: field, listed_files, length, left_out });
            }
            if !field.name.eq_ignore_ascii_case("Comment") {
                fields.add(report, field)?;
            }
        }
        Err(report.invalid(
            Place::File,
            "the header has no `ElementDataFile`",
            "end it by `ElementDataFile = LOCAL` and the data, or by the data file's name",
        ))
    }

    /// Whether the data is named by a list or by a pattern with a number.
    pub fn several_files(&self) -> bool {
        !self.listed_files.is_empty() || self.data_file.text.contains('%')
    }
}

/// `Name = value`; some writers have a colon for the equals sign.
fn field(line: &str, number: usize) -> Option<Field> {
    let (name, text) = line.split_once('=').or_else(|| line.split_once(':'))?;
    Some(Field { name: name.trim().to_owned(), text: text.trim().to_owned(), line: number })
}

/// Whether a file starts as a MetaImage header does: with one of its fields, and `NDims` among the first.
pub(super) fn recognises(head: &[u8]) -> bool {
    const FIRST: [&str; 7] = ["ObjectType", "ObjectSubType", "Comment", "TransformType", "NDims", "Name", "ID"];
    let text = String::from_utf8_lossy(head);
    let mut names = text
        .lines()
        .filter(|line| !line.trim().is_empty())
        .map_while(|line| line.split_once('='))
        .map(|(name, _)| name.trim());
    let first = names.next().unwrap_or_default();
    FIRST.iter().any(|name| name.eq_ignore_ascii_case(first))
        && (first.eq_ignore_ascii_case("NDims") || names.any(|name| name.eq_ignore_ascii_case("NDims")))
}

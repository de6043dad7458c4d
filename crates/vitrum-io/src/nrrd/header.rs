//! The lines of a NRRD header, without their meaning.

use std::io::BufRead;

use super::description::KNOWN;
use super::segments::Segments;
use crate::detached::List;
use crate::error::{Error, Place, Report, clip};
use crate::fields::{Field, Fields, MAX_BYTES};
use crate::text::Lines;
use crate::tolerance::LeftOut;

/// The fields of a header, with the list of data files that may follow the last.
#[derive(Debug)]
pub(super) struct Header {
    /// Their names are in lower case and without spaces: the format writes `data file` and `datafile` alike.
    pub fields: Fields,
    /// The lines behind `data file: LIST`.
    pub listed_files: Vec<String>,
    /// Bytes that the header takes, its closing blank line included.
    pub length: u64,
    /// Whether a blank line closed it; without one, no data can be attached.
    pub closed: bool,
    /// What is said of labels.
    pub segments: Segments,
    /// Lines without a meaning.
    pub left_out: LeftOut,
}

impl Header {
    pub fn read(reader: impl BufRead, report: Report) -> Result<Self, Error> {
        let mut lines = Lines::new(reader, report, MAX_BYTES, "end it by a blank line");
        check_magic(report, lines.next()?.as_deref().unwrap_or_default())?;
        let mut header = Self {
            fields: Fields::default(),
            listed_files: vec![],
            length: 0,
            closed: false,
            segments: Segments::default(),
            left_out: LeftOut::default(),
        };
        let mut listing = false;
        while let Some(line) = lines.next()? {
            if line.is_empty() {
                header.closed = true;
                break;
            }
            if listing {
                header.listed_files.push(line);
                continue;
            }
            if line.starts_with('#') {
                continue;
            }
            let Some((name, text)) = line.split_once(':') else {
                // A line that begins like one that matters has to be one.
                let first = line.split_whitespace().next().unwrap_or_default().to_ascii_lowercase();
                if KNOWN.contains(&first.as_str()) {
                    return Err(report.invalid(
                        Place::Line(lines.number),
                        format!("`{}` is neither `field: value` nor `key:=value`", clip(&line)),
                        "correct the line, or start it with # to make it a comment",
                    ));
                }
                header.left_out.add("lines of the header that are neither `field: value` nor `key:=value`");
                continue;
            };
            // A key/value pair, for people and other programs; those of segmentations are told.
            if let Some(value) = text.strip_prefix('=') {
                header.segments.add(name, value);
                continue;
            }
            let name = name.replace(' ', "").to_ascii_lowercase();
            let text = text.trim().to_owned();
            let field = Field { name, text, line: lines.number };
            listing = field.name == "datafile" && List::begins(&field);
            header.fields.add(report, field)?;
        }
        header.length = lines.length;
        Ok(header)
    }

    /// Whether the data is named by a list or by a pattern with a number.
    pub fn several_files(&self) -> bool {
        !self.listed_files.is_empty() || self.get("datafile").is_some_and(|field| field.text.contains('%'))
    }

    /// The field of a name, given in lower case and without spaces.
    pub fn get(&self, name: &str) -> Option<&Field> {
        self.fields.get(name)
    }

    /// The field of a name; if it is missing, an error that shows the expected form by an example.
    pub fn require(&self, report: Report, name: &str, example: &str) -> Result<&Field, Error> {
        self.fields.require(report, name, example)
    }
}

fn check_magic(report: Report, line: &str) -> Result<(), Error> {
    match line.trim_end().strip_prefix("NRRD") {
        Some("0001" | "0002" | "0003" | "0004" | "0005" | "00.01") => Ok(()),
        Some(version) => Err(report.unsupported(
            Place::Line(1),
            format!("NRRD version `{}` is not one of 0001 to 0005", clip(version)),
            "write the file as NRRD0005 or older",
        )),
        None => Err(report.invalid(
            Place::Line(1),
            format!("`{}` is not `NRRD` and a version", clip(line)),
            "check that this is a NRRD file",
        )),
    }
}

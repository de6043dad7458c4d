//! The lines of a NRRD header, before anybody asks what they mean.

use std::io::BufRead;

use crate::error::{Error, Place, Report};
use crate::text::Lines;
pub(super) use crate::text::clip;

/// Longest header that is read; real ones are a few hundred bytes, and those that list a data
/// file for each slice a few hundred kilobytes.
const MAX_BYTES: u64 = 16 << 20;

/// One `field: description` line.
#[derive(Debug, Clone)]
pub(super) struct Field {
    /// Lower case and without spaces: the format writes `data file` and `datafile` alike.
    name: String,
    pub text: String,
    pub line: usize,
}

impl Field {
    pub fn place(&self) -> Place {
        Place::Line(self.line)
    }
}

/// All fields, with the list of data files that may follow the last.
#[derive(Debug)]
pub(super) struct Header {
    fields: Vec<Field>,
    /// The lines behind `data file: LIST`.
    pub listed_files: Vec<String>,
    /// Bytes that the header takes, its closing blank line included.
    pub length: u64,
    /// Whether a blank line closed it; without one, no data can be attached.
    pub closed: bool,
}

impl Header {
    pub fn read(reader: impl BufRead, report: Report) -> Result<Self, Error> {
        let mut lines = Lines::new(reader, report, MAX_BYTES, "end it by a blank line");
        check_magic(report, lines.next()?.as_deref().unwrap_or_default())?;
        let mut header = Self { fields: vec![], listed_files: vec![], length: 0, closed: false };
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
                return Err(report.invalid(
                    Place::Line(lines.number),
                    format!("`{}` is neither `field: value` nor `key:=value`", clip(&line)),
                    "correct the line, or start it with # to make it a comment",
                ));
            };
            // A key/value pair, for people and other programs.
            if text.starts_with('=') {
                continue;
            }
            let name = name.replace(' ', "").to_ascii_lowercase();
            let text = text.trim().to_owned();
            listing = name == "datafile" && text.split_whitespace().next() == Some("LIST");
            header.add(report, Field { name, text, line: lines.number })?;
        }
        header.length = lines.length;
        Ok(header)
    }

    fn add(&mut self, report: Report, field: Field) -> Result<(), Error> {
        if let Some(first) = self.get(&field.name) {
            return Err(report.invalid(
                field.place(),
                format!("`{}` was given in line {} already", field.name, first.line),
                "keep one of the two",
            ));
        }
        self.fields.push(field);
        Ok(())
    }

    /// The field of a name, given in lower case and without spaces.
    pub fn get(&self, name: &str) -> Option<&Field> {
        self.fields.iter().find(|field| field.name == name)
    }

    /// The field, or an error that says what it should look like.
    pub fn require(&self, report: Report, name: &str, example: &str) -> Result<&Field, Error> {
        self.get(name).ok_or_else(|| {
            report.invalid(
                Place::File,
                format!("the header has no `{name}`"),
                format!("add a line such as `{example}`"),
            )
        })
    }

    /// Names of the fields that are not among `known`.
    pub fn unknown<'a>(&'a self, known: &'a [&str]) -> impl Iterator<Item = &'a str> {
        let names = self.fields.iter().map(|field| field.name.as_str());
        names.filter(|name| !known.contains(name))
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

//! The header of a legacy VTK file: the description of all its arrays.

use std::io::{BufRead, Seek, SeekFrom};

use super::blocks::Block;
use super::fields::{Attributes, Fields};
use crate::arrays;
use crate::components::Components;
use crate::error::{Error, Place, Report, clip};
use crate::options::OpenOptions;
use crate::placement::Placement;
use crate::samples::SampleType;
use crate::source::Assumptions;
use crate::stream;
use crate::text::{self, Lines};

/// Longest header that is read; real ones are a few hundred bytes.
const MAX_BYTES: u64 = 1 << 20;

const ADVICE: &str = "put the arrays before that";

/// Largest number of arrays of a file; real files have a few.
const MOST_BLOCKS: usize = 10_000;

/// A header understood: all that reading the data takes.
#[derive(Debug)]
pub(super) struct Header {
    pub binary: bool,
    pub sample: SampleType,
    pub components: Option<Components>,
    pub dimensions: [u32; 3],
    /// Bytes of data, decoded to the file's sample type.
    pub data_bytes: u64,
    /// First byte of the data.
    pub length: u64,
    pub placement: Placement,
    pub assumptions: Assumptions,
}

impl Header {
    /// Looks at all arrays of a file of so many bytes, and takes the one that is asked for, else the first scalars, else the first array with
    /// one component, else the first.
    pub fn read<R: BufRead + Seek>(
        mut reader: R,
        file_length: u64,
        options: &OpenOptions,
        report: Report,
    ) -> Result<Self, Error> {
        let asked = options.array.as_deref();
        let mut lines = Lines::new(&mut reader, report, MAX_BYTES, ADVICE);
        let magic = lines.next()?.unwrap_or_default();
        if !magic.to_ascii_lowercase().starts_with("# vtk datafile") {
            return Err(report.invalid(
                Place::Line(1),
                format!("`{}` is not `# vtk DataFile Version` and a version", clip(&magic)),
                "check that this is a VTK file",
            ));
        }
        // A title, for people.
        lines.next()?;
        // Blank lines may follow it.
        let kind = loop {
            match lines.next()? {
                Some(line) if line.trim().is_empty() => {}
                other => break other.unwrap_or_default(),
            }
        };
        let binary = match kind.trim().to_ascii_lowercase().as_str() {
            "ascii" => false,
            "binary" => true,
            _ => {
                let problem = format!("`{}` is neither ASCII nor BINARY", clip(&kind));
                return Err(report.invalid(Place::Line(lines.number), problem, "write one of the two"));
            }
        };
        let mut number = lines.number;
        let mut fields = Fields { binary, ..Fields::default() };
        let mut arrays = Arrays::default();
        for _ in 0..MOST_BLOCKS {
            let mut lines = Lines::new(&mut reader, report, MAX_BYTES, ADVICE);
            lines.number = number;
            let block = match fields.next_block(report, &mut lines) {
                Err(error) if arrays.chosen.is_some() => {
                    // It is no part of what is read.
                    arrays.unread = Some(error);
                    break;
                }
                other => other?,
            };
            number = lines.number;
            let Some(block) = block else { break };
            let start = reader.stream_position().map_err(|error| report.unreadable(error))?;
            arrays.add(report, &block, start, &fields, asked);
            let skipped = skip(report, &mut reader, &block, binary, start, file_length);
            if skipped.is_err() && arrays.chosen.is_some() {
                // The reader of the data tells what is missing there, and does not care for what is behind.
                break;
            }
            if let Err(error) = skipped {
                return Err(arrays.refusal.unwrap_or(error));
            }
        }
        arrays.finish(report, fields, number, options)
    }
}

/// Leaves a block's data behind.
fn skip<R: BufRead + Seek>(
    report: Report,
    reader: &mut R,
    block: &Block,
    binary: bool,
    start: u64,
    file_length: u64,
) -> Result<(), Error> {
    if !binary {
        return text::skip_numbers(report, reader, block.numbers());
    }
    let Some(bytes) = block.bytes() else {
        return block.sample(report).map(drop);
    };
    stream::check_length(report, bytes, start, file_length.saturating_sub(start))?;
    reader.seek(SeekFrom::Start(start + bytes)).map(drop).map_err(|error| report.unreadable(error))
}

/// Arrays that were found so far.
#[derive(Default)]
struct Arrays {
    names: Vec<String>,
    chosen: Option<Chosen>,
    /// Why the first that would have been chosen was not.
    refusal: Option<Error>,
    /// Reason for which the search for more ended.
    unread: Option<Error>,
}

/// The array that is read, as far as the file was looked at.
struct Chosen {
    block: Block,
    start: u64,
    attributes: Attributes,
    /// What is asked for of its components.
    part: Option<String>,
    /// How well it fits: see [`fit`].
    fit: u32,
}

/// How well an array is what is wanted, and the part of its components that is asked for; `None` where it is not.
fn fit<'a>(block: &Block, scalars: bool, asked: Option<&'a str>) -> Option<(u32, Option<&'a str>)> {
    let several = block.components > 1;
    match asked.map(|asked| (asked, asked.rsplit_once(':'))) {
        None if several => Some((if scalars { 1 } else { 0 }, None)),
        None => Some((if scalars { 3 } else { 2 }, None)),
        Some((asked, _)) if asked == block.name => Some((2, None)),
        Some((_, Some((name, part)))) if name == block.name => Some((1, Some(part))),
        Some((asked, _)) if several && Components::is_part(asked) => Some((0, Some(asked))),
        Some(_) => None,
    }
}

impl Arrays {
    fn add(&mut self, report: Report, block: &Block, start: u64, fields: &Fields, asked: Option<&str>) {
        let Some(attributes) = fields.attributes.filter(|_| !block.name.is_empty()) else { return };
        self.names.push(block.name.clone());
        let Some((fit, part)) = fit(block, fields.scalars, asked) else { return };
        if self.chosen.as_ref().is_some_and(|chosen| chosen.fit >= fit) {
            return;
        }
        match block.sample(report) {
            Ok(_) => {
                let part = part.map(str::to_owned);
                self.chosen = Some(Chosen { block: block.clone(), start, attributes, part, fit });
            }
            Err(error) => self.refusal = self.refusal.take().or(Some(error)),
        }
    }

    fn finish(self, report: Report, fields: Fields, line: usize, options: &OpenOptions) -> Result<Header, Error> {
        let asked = options.array.as_deref();
        let names = self.names.iter().map(String::as_str);
        let Some(Chosen { block, start, attributes, part, .. }) = self.chosen else {
            return Err(match (self.refusal, asked) {
                (Some(error), _) => error,
                (None, Some(asked)) if !self.names.is_empty() => arrays::unknown(report, asked, names),
                _ => report.invalid(
                    Place::Line(line),
                    "the header ends without SCALARS and their LOOKUP_TABLE",
                    "get the whole file, or write a scalar field into it",
                ),
            });
        };
        let mut others = self.names.iter().map(String::as_str).collect::<Vec<_>>();
        if let Some(index) = others.iter().position(|name| *name == block.name) {
            others.remove(index);
        }
        let mut header = fields.finish(report, &block, start, attributes, part.as_deref(), options)?;
        if asked.is_none() {
            header.assumptions.extend(arrays::others_note(&block.name, others.into_iter()));
        }
        if let Some(Error::Unsupported { problem, .. } | Error::Invalid { problem, .. }) = self.unread {
            header.assumptions.push(format!("what stands behind the arrays was left unread: {problem}"));
        }
        Ok(header)
    }
}

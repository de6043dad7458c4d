//! The header of a legacy VTK file: the description of all its arrays.

use std::io::{BufRead, Seek, SeekFrom};

use super::blocks::Block;
use super::fields::{Attributes, Fields};
use crate::arrays;
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
    pub dimensions: [u32; 3],
    /// Bytes of data, decoded to the file's sample type.
    pub data_bytes: u64,
    /// First byte of the data.
    pub length: u64,
    pub placement: Placement,
    pub assumptions: Assumptions,
}

impl Header {
    /// Looks at all arrays of a file of so many bytes, and takes the one of the name `asked`, else the first scalars, else
    /// the first array with one component.
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
                Err(error) if arrays.settled(asked) => {
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
            if skipped.is_err() && arrays.settled(asked) {
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
        return block.scalar(report).map(drop);
    };
    stream::check_length(report, bytes, start, file_length.saturating_sub(start))?;
    reader.seek(SeekFrom::Start(start + bytes)).map(drop).map_err(|error| report.unreadable(error))
}

/// Arrays that were found so far.
#[derive(Default)]
struct Arrays {
    names: Vec<String>,
    chosen: Option<(Block, u64, Attributes)>,
    /// Whether that are scalars, which go before other arrays.
    scalars: bool,
    /// Why the first that would have been chosen was not.
    refusal: Option<Error>,
    /// Reason for which the search for more ended.
    unread: Option<Error>,
}

impl Arrays {
    /// Whether the wanted array has been found, so that a fault behind it does no harm.
    fn settled(&self, asked: Option<&str>) -> bool {
        self.chosen.as_ref().is_some_and(|(block, ..)| asked.is_none_or(|asked| asked == block.name))
    }

    fn add(&mut self, report: Report, block: &Block, start: u64, fields: &Fields, asked: Option<&str>) {
        let Some(attributes) = fields.attributes.filter(|_| !block.name.is_empty()) else { return };
        self.names.push(block.name.clone());
        let better = self.chosen.is_none() || asked.is_none() && fields.scalars && !self.scalars;
        if asked.is_some_and(|asked| asked != block.name) || !better {
            return;
        }
        match block.scalar(report) {
            Ok(_) => {
                self.scalars = fields.scalars;
                self.chosen = Some((block.clone(), start, attributes));
            }
            Err(error) => self.refusal = self.refusal.take().or(Some(error)),
        }
    }

    fn finish(self, report: Report, fields: Fields, line: usize, options: &OpenOptions) -> Result<Header, Error> {
        let asked = options.array.as_deref();
        let names = self.names.iter().map(String::as_str);
        let Some((block, start, attributes)) = self.chosen else {
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
        let mut header = fields.finish(report, &block, start, attributes, options)?;
        if asked.is_none() {
            header.assumptions.extend(arrays::others_note(&block.name, others.into_iter()));
        }
        if let Some(Error::Unsupported { problem, .. } | Error::Invalid { problem, .. }) = self.unread {
            header.assumptions.push(format!("what stands behind the arrays was left unread: {problem}"));
        }
        Ok(header)
    }
}

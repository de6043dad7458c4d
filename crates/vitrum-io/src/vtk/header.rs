//! The lines of a legacy VTK file, around its arrays.

use std::io::{BufRead, Seek, SeekFrom};
use std::str::FromStr;

use super::blocks::{Block, decoded};
use crate::arrays;
use crate::error::{Error, Place, Report, clip};
use crate::placement::{Placement, UNORIENTED};
use crate::samples::SampleType;
use crate::stream;
use crate::text::{self, Lines};
use crate::volume::{IDENTITY, check_spacing};

/// Longest header that is read; real ones are a few hundred bytes.
const MAX_BYTES: u64 = 1 << 20;

const ADVICE: &str = "put the arrays before that";

/// Most arrays of a file; real ones have a few.
const MOST_BLOCKS: usize = 10_000;

/// A header understood: all that reading the data takes.
#[derive(Debug)]
pub(super) struct Header {
    pub binary: bool,
    pub sample: SampleType,
    pub dimensions: [u32; 3],
    /// Bytes of data, decoded to the file's sample type.
    pub data_bytes: u64,
    /// Where the data starts.
    pub length: u64,
    pub placement: Placement,
    pub assumptions: Vec<String>,
}

impl Header {
    /// Looks at all arrays of a file of so many bytes, and takes the one of the name `asked`, else the first scalars, else
    /// the first array with one component.
    pub fn read<R: BufRead + Seek>(
        mut reader: R,
        file_length: u64,
        asked: Option<&str>,
        report: Report,
    ) -> Result<Self, Error> {
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
        let kind = lines.next()?.unwrap_or_default();
        let binary = match kind.trim().to_ascii_lowercase().as_str() {
            "ascii" => false,
            "binary" => true,
            _ => {
                let problem = format!("`{}` is neither ASCII nor BINARY", clip(&kind));
                return Err(report.invalid(Place::Line(3), problem, "write one of the two"));
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
        arrays.finish(report, fields, number, asked)
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

/// What was found of the arrays so far.
#[derive(Default)]
struct Arrays {
    names: Vec<String>,
    chosen: Option<(Block, u64, Attributes)>,
    /// Whether that are scalars, which go before other arrays.
    scalars: bool,
    /// Why the first that would have been chosen was not.
    refusal: Option<Error>,
    /// What ended the search for more.
    unread: Option<Error>,
}

impl Arrays {
    /// Whether what is wrong behind does no harm.
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

    fn finish(self, report: Report, fields: Fields, line: usize, asked: Option<&str>) -> Result<Header, Error> {
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
        let mut header = fields.finish(report, &block, start, attributes)?;
        if asked.is_none() {
            header.assumptions.extend(arrays::others_note(&block.name, others.into_iter()));
        }
        if let Some(Error::Unsupported { problem, .. } | Error::Invalid { problem, .. }) = self.unread {
            header.assumptions.push(format!("what stands behind the arrays was left unread: {problem}"));
        }
        Ok(header)
    }
}

/// How many values there are, whether they are the cells', and the line that says so.
type Attributes = (u64, bool, usize);

/// What was read so far; each with the number of its line.
#[derive(Default)]
struct Fields {
    binary: bool,
    dataset: bool,
    dimensions: Option<([u32; 3], usize)>,
    spacing: Option<([f64; 3], usize)>,
    origin: Option<([f64; 3], usize)>,
    attributes: Option<Attributes>,
    /// SCALARS whose LOOKUP_TABLE is still to come.
    pending: Option<Block>,
    /// Whether the last block was of SCALARS.
    scalars: bool,
    /// Arrays of a FIELD that are still to come.
    field: u64,
}

impl Fields {
    /// Takes in lines up to the next block of data; `None` at the end of the file.
    fn next_block<R: BufRead>(&mut self, report: Report, lines: &mut Lines<R>) -> Result<Option<Block>, Error> {
        while let Some(line) = lines.next()? {
            if let Some(block) = self.line(report, lines, &line)? {
                return Ok(Some(block));
            }
        }
        Ok(None)
    }

    /// Takes in a line; the block where its data follows.
    fn line<R: BufRead>(&mut self, report: Report, lines: &mut Lines<R>, line: &str) -> Result<Option<Block>, Error> {
        let (place, number) = (Place::Line(lines.number), lines.number);
        let mut words = line.split_whitespace();
        let Some(keyword) = words.next() else { return Ok(None) };
        let rest: Vec<_> = words.collect();
        let count = self.attributes.map_or(0, |(count, ..)| count);
        self.scalars = false;
        let lower = keyword.to_ascii_lowercase();
        if self.pending.is_some() && lower != "lookup_table" {
            return Err(report.invalid(
                place,
                format!("`{}` stands behind SCALARS, not LOOKUP_TABLE", clip(line)),
                "write `LOOKUP_TABLE default` before the data",
            ));
        }
        if self.field > 0 && lower != "metadata" {
            self.field -= 1;
            let [components, count] = numbers(report, place, line, rest.get(..2).unwrap_or_default())?;
            let kind = rest.get(2).copied().unwrap_or_default();
            return Ok(Some(Block::new(&decoded(keyword), kind, components, count, number)));
        }
        let name = decoded(rest.first().copied().unwrap_or_default());
        let kind = rest.get(1).copied().unwrap_or_default();
        let array = |components: u64| Ok(Some(Block::new(&name, kind, components, count, number)));
        match lower.as_str() {
            "dataset" => self.dataset = dataset(report, place, &rest)?,
            "dimensions" => self.dimensions = Some((numbers(report, place, line, &rest)?, number)),
            // The name before version 2.0.
            "spacing" | "aspect_ratio" => self.spacing = Some((numbers(report, place, line, &rest)?, number)),
            "origin" => self.origin = Some((numbers(report, place, line, &rest)?, number)),
            keyword @ ("point_data" | "cell_data") => {
                let [count] = numbers(report, place, line, &rest)?;
                self.attributes = Some((count, keyword == "cell_data", number));
            }
            "metadata" => while lines.next()?.is_some_and(|line| !line.trim().is_empty()) {},
            "scalars" if self.attributes.is_none() => {
                return Err(self.missing(report, "POINT_DATA", "POINT_DATA 262144"));
            }
            "scalars" => {
                let [components] = rest.get(2).map_or(Ok([1]), |word| numbers(report, place, line, &[*word]))?;
                self.pending = Some(Block::new(&name, kind, components, count, number));
            }
            "lookup_table" => match self.pending.take() {
                Some(block) => {
                    self.scalars = true;
                    return Ok(Some(block));
                }
                None => {
                    let [size] = numbers(report, place, line, rest.get(1..).unwrap_or_default())?;
                    return Ok(Some(Block::new("", self.color_kind(), 4, size, number)));
                }
            },
            "color_scalars" => {
                let [components] = numbers(report, place, line, rest.get(1..).unwrap_or_default())?;
                return Ok(Some(Block::new(&name, self.color_kind(), components, count, number)));
            }
            "vectors" | "normals" => return array(3),
            "tensors" => return array(9),
            "texture_coordinates" => {
                let [components] = numbers(report, place, line, rest.get(1..2).unwrap_or_default())?;
                let kind = rest.get(2).copied().unwrap_or_default();
                return Ok(Some(Block::new(&name, kind, components, count, number)));
            }
            "field" => [self.field] = numbers(report, place, line, rest.get(1..).unwrap_or_default())?,
            _ => {
                return Err(report.unsupported(
                    place,
                    format!("`{}` is no keyword of structured points that is read", clip(keyword)),
                    "write the file anew, for example by ParaView",
                ));
            }
        }
        Ok(None)
    }

    /// Colours are bytes, or in text numbers up to 1.
    fn color_kind(&self) -> &'static str {
        if self.binary { "unsigned_char" } else { "float" }
    }

    fn missing(&self, report: Report, what: &str, example: &str) -> Error {
        let advice = format!("add a line such as `{example}`");
        report.invalid(Place::File, format!("the header has no {what} before the data"), advice)
    }

    fn finish(
        self,
        report: Report,
        block: &Block,
        start: u64,
        (count, cells, count_line): Attributes,
    ) -> Result<Header, Error> {
        let sample = block.scalar(report)?;
        if !self.dataset {
            return Err(self.missing(report, "DATASET", "DATASET STRUCTURED_POINTS"));
        }
        let Some((points, line)) = self.dimensions else {
            return Err(self.missing(report, "DIMENSIONS", "DIMENSIONS 64 64 64"));
        };
        // A flat image has cells that are flat.
        let dimensions = points.map(|size| if cells && size > 1 { size - 1 } else { size });
        let at_line = Place::Line(line);
        if dimensions.contains(&0) {
            return Err(report.invalid(at_line, "DIMENSIONS without voxels", "give each axis a size of at least 1"));
        }
        let data_bytes = stream::byte_count(dimensions, sample.size())
            .map_err(|problem| report.invalid(at_line, problem, "correct DIMENSIONS"))?;
        let expected = data_bytes / sample.size() as u64;
        // An array of a FIELD has a count of its own.
        let (count, count_line) = if block.count == count { (count, count_line) } else { (block.count, block.line) };
        if count != expected {
            return Err(report.invalid(
                Place::Line(count_line),
                format!("{count} values for the {expected} voxels of DIMENSIONS"),
                "correct one of the two",
            ));
        }
        let mut assumptions: Vec<String> = sample.rounding_note().into_iter().collect();
        let placement = self.placement(report, points, cells, &mut assumptions)?;
        let binary = self.binary;
        Ok(Header { binary, sample, dimensions, data_bytes, length: start, placement, assumptions })
    }

    fn placement(
        &self,
        report: Report,
        points: [u32; 3],
        cells: bool,
        assumptions: &mut Vec<String>,
    ) -> Result<Placement, Error> {
        let spacing = match self.spacing {
            Some((spacing, line)) => {
                let narrow = spacing.map(|value| value as f32);
                check_spacing(report, narrow).map_err(|error| error.at(Place::Line(line)))?;
                spacing
            }
            None => {
                assumptions.push("the file says no spacing: 1 was taken along each axis".to_owned());
                [1.0; 3]
            }
        };
        assumptions.push(UNORIENTED.to_owned());
        if cells {
            assumptions.push("the values of the cells were taken at their centres".to_owned());
        }
        let first = |axis: usize| if cells && points[axis] > 1 { 0.5 * spacing[axis] } else { 0.0 };
        let origin = self.origin.map(|(origin, _)| [0, 1, 2].map(|axis| origin[axis] + first(axis)));
        let columns = [0, 1, 2].map(|axis| IDENTITY[axis].map(|unit| f64::from(unit) * spacing[axis]));
        let place = self.origin.map_or(Place::File, |(_, line)| Place::Line(line));
        Placement::from_columns(columns, origin)
            .map_err(|problem| report.invalid(place, problem, "correct SPACING or ORIGIN"))
    }
}

fn dataset(report: Report, place: Place, words: &[&str]) -> Result<bool, Error> {
    match words.first() {
        Some(kind) if kind.eq_ignore_ascii_case("structured_points") => Ok(true),
        kind => Err(report.unsupported(
            place,
            format!(
                "the dataset is `{}`, and only STRUCTURED_POINTS are read",
                clip(kind.copied().unwrap_or_default())
            ),
            "resample it to an image first, for example by ParaView's filter Resample To Image",
        )),
    }
}

/// Exactly `COUNT` numbers behind a keyword.
fn numbers<T: FromStr, const COUNT: usize>(
    report: Report,
    place: Place,
    line: &str,
    words: &[&str],
) -> Result<[T; COUNT], Error> {
    let parsed = words.iter().map(|word| word.parse()).collect::<Result<Vec<T>, _>>();
    parsed.ok().and_then(|values| values.try_into().ok()).ok_or_else(|| {
        // The types in use are f64 and the integers.
        let whole = if std::any::type_name::<T>().starts_with('f') { "" } else { "whole " };
        let problem = format!("`{}` is not a keyword and {COUNT} {whole}number(s) in range", clip(line));
        report.invalid(place, problem, "correct the line")
    })
}

//! The keywords of a legacy VTK file: the description of the grid, and the places of the data.

use std::io::BufRead;
use std::str::FromStr;

use super::blocks::{Block, decoded};
use crate::error::{Error, Place, Report, clip};
use crate::text::Lines;

/// Count of the values, whether they are the cells', and the line that says so.
pub(super) type Attributes = (u64, bool, usize);

/// Fields that were read so far, each with the number of its line.
#[derive(Default)]
pub(super) struct Fields {
    pub binary: bool,
    pub dataset: bool,
    pub dimensions: Option<([u32; 3], usize)>,
    /// Where it cannot be read, the error, which a spacing of the user's own makes up for.
    pub spacing: Option<Result<[f64; 3], Error>>,
    pub origin: Option<([f64; 3], usize)>,
    pub attributes: Option<Attributes>,
    /// SCALARS whose LOOKUP_TABLE is still to come.
    pub pending: Option<Block>,
    /// Whether the last block was of SCALARS.
    pub scalars: bool,
    /// Arrays of a FIELD that are still to come.
    pub field: u64,
}

impl Fields {
    /// Takes in lines up to the next block of data; `None` at the end of the file.
    pub fn next_block<R: BufRead>(&mut self, report: Report, lines: &mut Lines<R>) -> Result<Option<Block>, Error> {
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
            "spacing" | "aspect_ratio" => self.spacing = Some(numbers(report, place, line, &rest)),
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
                let block = Block::new(&name, self.color_kind(), components, count, number);
                return Ok(Some(Block { colors: (3..=4).contains(&components), ..block }));
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

    pub fn missing(&self, report: Report, what: &str, example: &str) -> Error {
        let advice = format!("add a line such as `{example}`");
        report.invalid(Place::File, format!("the header has no {what} before the data"), advice)
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

//! The lines in front of a legacy VTK file's first scalars.

use std::io::BufRead;
use std::str::FromStr;

use crate::error::{Error, Place, Report, clip};
use crate::placement::Placement;
use crate::samples::SampleType;
use crate::stream;
use crate::text::Lines;
use crate::volume::{IDENTITY, check_spacing};

/// Longest header that is read; real ones are a few hundred bytes.
const MAX_BYTES: u64 = 1 << 20;

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
    pub fn read(reader: impl BufRead, report: Report) -> Result<Self, Error> {
        let mut lines = Lines::new(reader, report, MAX_BYTES, "put the first SCALARS before that");
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
        let mut fields = Fields::default();
        while let Some(line) = lines.next()? {
            if fields.line(report, &mut lines, &line)? {
                let length = lines.length;
                return fields.finish(report, binary, length);
            }
        }
        Err(report.invalid(
            Place::Line(lines.number),
            "the header ends without SCALARS and their LOOKUP_TABLE",
            "get the whole file, or write a scalar field into it",
        ))
    }
}

/// What was read so far; each with the number of its line.
#[derive(Default)]
struct Fields {
    dataset: bool,
    dimensions: Option<([u32; 3], usize)>,
    spacing: Option<([f64; 3], usize)>,
    origin: Option<([f64; 3], usize)>,
    /// How many values there are, and whether they are the cells'.
    attributes: Option<(u64, bool, usize)>,
    sample: Option<SampleType>,
}

impl Fields {
    /// Takes in a line; `true` where the data follows it.
    fn line<R: BufRead>(&mut self, report: Report, lines: &mut Lines<R>, line: &str) -> Result<bool, Error> {
        let place = Place::Line(lines.number);
        let mut words = line.split_whitespace();
        let Some(keyword) = words.next() else { return Ok(false) };
        let rest: Vec<_> = words.collect();
        match keyword.to_ascii_lowercase().as_str() {
            "dataset" => self.dataset = dataset(report, place, &rest)?,
            "dimensions" => self.dimensions = Some((numbers(report, place, line, &rest)?, lines.number)),
            // The name before version 2.0.
            "spacing" | "aspect_ratio" => self.spacing = Some((numbers(report, place, line, &rest)?, lines.number)),
            "origin" => self.origin = Some((numbers(report, place, line, &rest)?, lines.number)),
            keyword @ ("point_data" | "cell_data") => {
                let [count] = numbers(report, place, line, &rest)?;
                self.attributes = Some((count, keyword == "cell_data", lines.number));
            }
            "metadata" => while lines.next()?.is_some_and(|line| !line.trim().is_empty()) {},
            "scalars" => self.sample = Some(scalars(report, place, &rest)?),
            "lookup_table" if self.sample.is_some() => return Ok(true),
            _ if self.sample.is_some() => {
                return Err(report.invalid(
                    place,
                    format!("`{}` stands behind SCALARS, not LOOKUP_TABLE", clip(line)),
                    "write `LOOKUP_TABLE default` before the data",
                ));
            }
            _ => {
                return Err(report.unsupported(
                    place,
                    format!("`{}` stands before the first SCALARS, and only those are read", clip(keyword)),
                    "write the scalars as the first data of the points or the cells",
                ));
            }
        }
        Ok(false)
    }

    fn finish(self, report: Report, binary: bool, length: u64) -> Result<Header, Error> {
        let missing = |what: &str, example: &str| {
            let advice = format!("add a line such as `{example}`");
            report.invalid(Place::File, format!("the header has no {what} before the data"), advice)
        };
        let sample = self.sample.ok_or_else(|| missing("SCALARS", "SCALARS density float 1"))?;
        if !self.dataset {
            return Err(missing("DATASET", "DATASET STRUCTURED_POINTS"));
        }
        let (points, line) = self.dimensions.ok_or_else(|| missing("DIMENSIONS", "DIMENSIONS 64 64 64"))?;
        let (count, cells, count_line) = self.attributes.ok_or_else(|| missing("POINT_DATA", "POINT_DATA 262144"))?;
        // A flat image has cells that are flat.
        let dimensions = points.map(|size| if cells && size > 1 { size - 1 } else { size });
        let at_line = Place::Line(line);
        if dimensions.contains(&0) {
            return Err(report.invalid(at_line, "DIMENSIONS without voxels", "give each axis a size of at least 1"));
        }
        let data_bytes = stream::byte_count(dimensions, sample.size())
            .map_err(|problem| report.invalid(at_line, problem, "correct DIMENSIONS"))?;
        let expected = data_bytes / sample.size() as u64;
        if count != expected {
            return Err(report.invalid(
                Place::Line(count_line),
                format!("{count} values for the {expected} voxels of DIMENSIONS"),
                "correct one of the two",
            ));
        }
        let mut assumptions: Vec<String> = sample.rounding_note().into_iter().collect();
        let placement = self.placement(report, points, cells, &mut assumptions)?;
        Ok(Header { binary, sample, dimensions, data_bytes, length, placement, assumptions })
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

/// `SCALARS name type [components]`.
fn scalars(report: Report, place: Place, words: &[&str]) -> Result<SampleType, Error> {
    if let Some(components) = words.get(2).filter(|&&components| components != "1") {
        return Err(report.unsupported(
            place,
            format!("the scalars have {} components a voxel, not 1", clip(components)),
            "write one component alone, for example by ParaView's filter Calculator",
        ));
    }
    let name = words.get(1).copied().unwrap_or_default();
    match name.to_ascii_lowercase().as_str() {
        "char" | "signed_char" => Ok(SampleType::I8),
        "unsigned_char" => Ok(SampleType::U8),
        "short" => Ok(SampleType::I16),
        "unsigned_short" => Ok(SampleType::U16),
        "int" => Ok(SampleType::I32),
        "unsigned_int" => Ok(SampleType::U32),
        "long" | "vtktypeint64" => Ok(SampleType::I64),
        "unsigned_long" | "vtktypeuint64" => Ok(SampleType::U64),
        "float" => Ok(SampleType::F32),
        "double" => Ok(SampleType::F64),
        _ => Err(report.unsupported(
            place,
            format!("the type `{}` is not read", clip(name)),
            "use one of char, unsigned_char, short, unsigned_short, int, unsigned_int, long, unsigned_long, float, \
             double",
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

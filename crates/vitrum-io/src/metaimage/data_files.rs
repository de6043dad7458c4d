//! Which files hold the data of a MetaImage header.

use super::description::{Description, HeaderSize};
use super::header::{Header, is_list};
use crate::data_file::{DataFile, MOST_FILES, numbered_name};
use crate::error::{Error, Place, Report, clip};
use crate::fields::Field;
use crate::input::Input;

/// The files in the order of their slices, each with the same share of the voxels.
pub(super) fn locate(
    header: &Header,
    description: &Description,
    input: &Input,
    report: Report,
) -> Result<Vec<DataFile>, Error> {
    let field = &header.data_file;
    if field.text.eq_ignore_ascii_case("LOCAL") {
        let file = attached(header, description, input, report)?;
        return Ok(vec![file]);
    }
    let names = names(header, description, report)?;
    let skipped = match description.header_size {
        HeaderSize::Bytes(size) => size,
        HeaderSize::None | HeaderSize::FromEnd => 0,
    };
    let detached = |name: &String| -> Result<DataFile, Error> {
        Ok(DataFile { start: skipped, ..DataFile::detached(report, field.place(), input, name)? })
    };
    names.iter().map(detached).collect()
}

fn attached(header: &Header, description: &Description, input: &Input, report: Report) -> Result<DataFile, Error> {
    match description.header_size {
        HeaderSize::Bytes(size) if size < header.length => Err(report.invalid(
            header.fields.get("HeaderSize").map_or(Place::File, Field::place),
            format!("`HeaderSize = {size}` with LOCAL data, which starts at byte {} at the earliest", header.length),
            "leave the line out, or correct the number",
        )),
        HeaderSize::Bytes(size) => Ok(DataFile::attached(input, size)),
        HeaderSize::None | HeaderSize::FromEnd => Ok(DataFile::attached(input, header.length)),
    }
}

/// File names as the header writes them: one, a list, or a numbered pattern.
fn names(header: &Header, description: &Description, report: Report) -> Result<Vec<String>, Error> {
    let field = &header.data_file;
    if is_list(field) {
        let dimension = match field.text.trim_start_matches("LIST").trim() {
            "" => description.rank - 1,
            text => {
                text.parse().ok().filter(|dimension| (1..=description.rank).contains(dimension)).ok_or_else(|| {
                    report.invalid(
                        field.place(),
                        format!("`{}` is not the dimension of a file's data, 1 to {}", clip(text), description.rank),
                        "give 1 for rows, 2 for slices, or nothing for slices",
                    )
                })?
            }
        };
        check_file_count(report, field, description, dimension, header.listed_files.len() as u64)?;
        return Ok(header.listed_files.clone());
    }
    let Some(pattern) = Pattern::parse(&field.text, description) else {
        return Ok(vec![field.text.clone()]);
    };
    let count = pattern.count().unwrap_or(0);
    check_file_count(report, field, description, description.rank - 1, count)?;
    let numbers = (0..count).map(|index| pattern.first + index as i64 * pattern.step);
    let names: Option<Vec<_>> = numbers.map(|number| numbered_name(pattern.name, number)).collect();
    names.ok_or_else(|| {
        report.invalid(
            field.place(),
            format!("`{}` is not a name with one number such as %d or %03d", clip(pattern.name)),
            "write `ElementDataFile = slice%03d.raw FIRST LAST STEP`",
        )
    })
}

/// `<name with %d> <first> <last> <step>`.
struct Pattern<'a> {
    name: &'a str,
    first: i64,
    last: i64,
    step: i64,
}

impl<'a> Pattern<'a> {
    /// `None` for a plain file name, which may have spaces and percent signs.
    fn parse(text: &'a str, description: &Description) -> Option<Self> {
        let words: Vec<_> = text.split_whitespace().collect();
        let (&name, numbers) = words.split_first()?;
        let numbers = numbers.iter().map(|word| word.parse::<i32>().map(i64::from));
        let numbers = numbers.collect::<Result<Vec<_>, _>>().ok()?;
        let slices = i64::from(description.dimensions[2]);
        let (first, last, step) = match *numbers.as_slice() {
            [] => {
                numbered_name(name, 1)?;
                (1, slices, 1)
            }
            [first] => (first, first + slices - 1, 1),
            [first, last] => (first, last, 1),
            [first, last, step] => (first, last, step),
            _ => return None,
        };
        name.contains('%').then_some(Self { name, first, last, step })
    }

    /// `None` where the step never gets from first to last.
    fn count(&self) -> Option<u64> {
        let steps = (self.last - self.first).checked_div(self.step)?;
        u64::try_from(steps).ok().map(|steps| steps + 1)
    }
}

/// Each file holds a part of `dimension` dimensions: a row, a slice or the volume.
fn check_file_count(
    report: Report,
    field: &Field,
    description: &Description,
    dimension: usize,
    count: u64,
) -> Result<(), Error> {
    let [_, height, depth] = description.dimensions.map(u64::from);
    let (expected, parts) = match dimension {
        1 => (height * depth, "rows"),
        2 => (depth, "slices"),
        _ => (1, "volume"),
    };
    if count != expected || count > MOST_FILES {
        return Err(report.invalid(
            field.place(),
            format!("{count} data files for {expected} {parts}, where at most {MOST_FILES} are read"),
            "give one file for each, and check the numbers behind the pattern",
        ));
    }
    Ok(())
}

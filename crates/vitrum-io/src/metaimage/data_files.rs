//! Data files of a MetaImage header.

use super::description::{Description, HeaderSize};
use super::header::Header;
use crate::detached::{DataFile, List, NumberedNames, check_file_count, numbered_name};
use crate::error::{Error, Place, Report};
use crate::fields::Field;
use crate::input::Input;

/// The files in the order of their slices, each with the same share of the voxels.
pub(super) fn locate<'a>(
    header: &Header,
    description: &Description,
    input: &'a Input,
    report: Report,
) -> Result<Vec<DataFile<'a>>, Error> {
    let field = &header.data_file;
    let mut files = if field.text.eq_ignore_ascii_case("LOCAL") {
        vec![attached(header, description, input, report)?]
    } else {
        detached(header, description, input, report)?
    };
    if description.header_size == HeaderSize::FromEnd {
        let times = if header.several_files() { 1 } else { description.times.count };
        let bytes = description.data_bytes.saturating_mul(times) / files.len() as u64;
        files.iter_mut().for_each(|file| file.start = file.length.saturating_sub(bytes).max(file.start));
    }
    Ok(files)
}

fn detached<'a>(
    header: &Header,
    description: &Description,
    input: &Input,
    report: Report,
) -> Result<Vec<DataFile<'a>>, Error> {
    let mut names = names(header, description, report)?;
    if description.times.count > 1 && names.len() > 1 {
        names = names.drain(..).skip(description.times.chosen as usize).take(1).collect();
    }
    let skipped = match description.header_size {
        HeaderSize::Bytes(size) => size,
        HeaderSize::None | HeaderSize::FromEnd => 0,
    };
    let detached = |name: &String| -> Result<DataFile<'a>, Error> {
        let mut file = DataFile::detached(report, header.data_file.place(), input, name)?;
        file.start = skipped;
        Ok(file)
    };
    names.iter().map(detached).collect()
}

fn attached<'a>(
    header: &Header,
    description: &Description,
    input: &'a Input,
    report: Report,
) -> Result<DataFile<'a>, Error> {
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
    if let Some(List { dimension }) = List::of(report, field, description.rank)? {
        let dimension = dimension.unwrap_or(description.rank - 1);
        check_count(report, field, description, dimension, header.listed_files.len() as u64)?;
        return Ok(header.listed_files.clone());
    }
    let Some(numbered) = pattern(&field.text, description) else {
        return Ok(vec![field.text.clone()]);
    };
    check_count(report, field, description, description.rank - 1, numbered.count())?;
    numbered.names(report, field, "ElementDataFile = slice%03d.raw FIRST LAST STEP")
}

/// `<name with %d> <first> <last> <step>`; `None` for a plain file name, which may have spaces and percent signs.
fn pattern<'a>(text: &'a str, description: &Description) -> Option<NumberedNames<'a>> {
    let words: Vec<_> = text.split_whitespace().collect();
    let (&name, numbers) = words.split_first()?;
    let numbers = numbers.iter().map(|word| word.parse::<i32>().map(i64::from));
    let numbers = numbers.collect::<Result<Vec<_>, _>>().ok()?;
    let times = description.times.count;
    let slices = if times > 1 { times as i64 } else { i64::from(description.dimensions[2]) };
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
    name.contains('%').then_some(NumberedNames { name, first, last, step })
}

/// Checks the number of files; each holds a part of `dimension` dimensions: a row, a slice or the volume.
fn check_count(
    report: Report,
    field: &Field,
    description: &Description,
    dimension: usize,
    count: u64,
) -> Result<(), Error> {
    let [_, height, depth] = description.dimensions.map(u64::from);
    let times = description.times.count;
    let (expected, parts) = match dimension {
        3.. if times > 1 => (times, "points in time"),
        _ if times > 1 => (0, "files that hold less than a point in time"),
        1 => (height * depth, "rows"),
        2 => (depth, "slices"),
        _ => (1, "volume"),
    };
    check_file_count(report, field, count, count == expected, &format!("{expected} {parts}"))
}

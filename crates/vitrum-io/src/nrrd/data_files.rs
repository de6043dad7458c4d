//! Data files of a NRRD header.

use super::description::Description;
use super::header::Header;
use crate::detached::{DataFile, List, NumberedNames, check_file_count, dimension};
use crate::error::{Error, Place, Report};
use crate::fields::Field;
use crate::input::Input;

/// The data files in the order of their slices, each with the same share of the voxels; of files with one point in time each, the file
/// of the chosen one.
pub(super) fn locate<'a>(
    header: &Header,
    description: &Description,
    input: &'a Input,
    report: Report,
) -> Result<Vec<DataFile<'a>>, Error> {
    let Some(field) = header.get("datafile") else {
        if !header.closed {
            return Err(report.invalid(
                Place::File,
                "the header has neither a `data file` nor a blank line with the data behind it",
                "name the data file, or get the whole file",
            ));
        }
        return Ok(vec![DataFile::attached(input, header.length)]);
    };
    let mut names = names(header, field, description, report)?;
    if description.times.count > 1 && names.len() > 1 {
        names = names.drain(..).skip(description.times.chosen as usize).take(1).collect();
    }
    names.iter().map(|name| DataFile::detached(report, field.place(), input, name)).collect()
}

/// File names as the header writes them: one, a list, or a numbered pattern.
fn names(header: &Header, field: &Field, description: &Description, report: Report) -> Result<Vec<String>, Error> {
    if let Some(List { dimension }) = List::of(report, field, 3)? {
        check_count(report, field, description, dimension, header.listed_files.len() as u64)?;
        return Ok(header.listed_files.clone());
    }
    let Some((numbered, subdim)) = pattern(&field.text) else {
        return Ok(vec![field.text.clone()]);
    };
    let subdim = subdim.map(|text| dimension(report, field, text, 3)).transpose()?;
    check_count(report, field, description, subdim, numbered.count())?;
    numbered.names(report, field, "data file: slice%03d.raw FIRST LAST STEP")
}

/// `<name with %d> <first> <last> <step> [<subdim>]`; `None` for a plain file name, which may have spaces and percent signs.
fn pattern(text: &str) -> Option<(NumberedNames<'_>, Option<&str>)> {
    let words: Vec<_> = text.split_whitespace().collect();
    let (&name, numbers) = words.split_first()?;
    let (&[first, last, step], subdim) = match numbers {
        [numbers @ .., subdim] if numbers.len() == 3 => (numbers.as_array()?, Some(*subdim)),
        numbers => (numbers.as_array()?, None),
    };
    let [first, last, step] = [first, last, step].map(|word| word.parse::<i32>().ok());
    let (first, last, step) = (first?.into(), last?.into(), step?.into());
    name.contains('%').then_some((NumberedNames { name, first, last, step }, subdim))
}

/// Checks the number of files; each holds a slice, or the data of `subdim` dimensions: rows (1), slices (2) or slabs of slices (3).
fn check_count(
    report: Report,
    field: &Field,
    description: &Description,
    subdim: Option<usize>,
    count: u64,
) -> Result<(), Error> {
    let [_, height, depth] = description.dimensions.map(u64::from);
    let times = description.times.count;
    let (fits, expected) = match subdim {
        None | Some(3) if times > 1 => (count == times, format!("{times} points in time")),
        Some(_) if times > 1 => (false, format!("{times} points in time, of which each has a file")),
        Some(1) => (count == height * depth, format!("{} rows", height * depth)),
        Some(3) => (count > 0 && depth.is_multiple_of(count), format!("equal slabs of {depth} slices")),
        _ => (count == depth, format!("{depth} slices")),
    };
    check_file_count(report, field, count, fits, &expected)
}

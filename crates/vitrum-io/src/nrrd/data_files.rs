//! Which files hold the data of a NRRD header.

use super::description::Description;
use super::header::Header;
use crate::data_file::{DataFile, MOST_FILES, NumberedNames};
use crate::error::{Error, Place, Report, clip};
use crate::fields::Field;
use crate::input::Input;

/// The files in the order of their slices, each with the same share of the voxels; of several points in time in a file
/// each, that of the chosen one.
pub(super) fn locate(
    header: &Header,
    description: &Description,
    input: &Input,
    report: Report,
) -> Result<Vec<DataFile>, Error> {
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
    if field.text.split_whitespace().next() == Some("LIST") {
        let rest = field.text.trim_start_matches("LIST").trim();
        let subdim = if rest.is_empty() { None } else { Some(subdim(report, field, rest)?) };
        let count = header.listed_files.len() as u64;
        check_file_count(report, field, description, subdim, count)?;
        return Ok(header.listed_files.clone());
    }
    let Some((numbered, subdim_text)) = pattern(&field.text) else {
        return Ok(vec![field.text.clone()]);
    };
    let subdim = subdim_text.map(|text| subdim(report, field, text)).transpose()?;
    check_file_count(report, field, description, subdim, numbered.count())?;
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

fn subdim(report: Report, field: &Field, text: &str) -> Result<usize, Error> {
    text.parse().ok().filter(|subdim| (1..=3).contains(subdim)).ok_or_else(|| {
        report.invalid(
            field.place(),
            format!("`{}` is not the dimension of a file's data, 1, 2 or 3", clip(text)),
            "give 1 for rows, 2 for slices, 3 for slabs, or nothing for slices",
        )
    })
}

/// Each file holds a slice, or what `subdim` says: rows (1), slices (2) or slabs of slices (3).
fn check_file_count(
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
    if !fits || count > MOST_FILES {
        return Err(report.invalid(
            field.place(),
            format!("{count} data files for {expected}, where at most {MOST_FILES} are read"),
            "give one file for each, and check the numbers behind the pattern",
        ));
    }
    Ok(())
}

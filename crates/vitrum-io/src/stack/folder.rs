//! A folder of TIFF files, one slice each: the files of one volume, and their order.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::error::{Error, Place, Report, clip};
use crate::folder::{MOST_FILES, is_tiff};
use crate::input::file_name;
use crate::source::Assumptions;

/// A file, by the numbers in its name.
type Numbered = (Vec<u64>, PathBuf);

/// The files of the largest series in a folder, in the order of their numbers. Never empty.
pub(super) fn slices(report: Report, folder: &Path, assumptions: &mut Assumptions) -> Result<Vec<PathBuf>, Error> {
    let entries = fs::read_dir(folder).map_err(|error| report.unreadable(error))?;
    let mut series: BTreeMap<String, Vec<Numbered>> = BTreeMap::new();
    for (count, entry) in entries.enumerate() {
        let path = entry.map_err(|error| report.unreadable(error))?.path();
        if count == MOST_FILES {
            let problem = format!("there are more than {MOST_FILES} files in the folder");
            return Err(report.unsupported(Place::File, problem, "give a folder with the slices of one volume"));
        }
        if is_tiff(&path) {
            let (pattern, numbers) = parse(&file_name(&path));
            series.entry(pattern).or_default().push((numbers, path));
        }
    }
    let named = |(pattern, files): &(String, Vec<Numbered>)| format!("{} ({} files)", clip(pattern), files.len());
    let mut series: Vec<_> = series.into_iter().collect();
    series.sort_by_key(|(_, files)| std::cmp::Reverse(files.len()));
    let advice = "name a file of the one that is wanted instead of the folder";
    match &series[..] {
        [] => {
            let problem = "there is no TIFF file in the folder";
            return Err(report.unsupported(Place::File, problem, "give the folder with the slices"));
        }
        [first, second, ..] if first.1.len() == second.1.len() => {
            let problem = format!("the folder holds several series alike: {}, {}", named(first), named(second));
            return Err(report.unsupported(Place::File, problem, advice));
        }
        [first, others @ ..] if !others.is_empty() => {
            let shown: Vec<_> = others.iter().take(8).map(named).collect();
            assumptions.push(format!(
                "the largest series was taken, {}; others are: {}; {advice}",
                named(first),
                shown.join(", ")
            ));
        }
        _ => {}
    }
    order(report, series.swap_remove(0).1)
}

/// A name with a `#` for each of its numbers, and these.
fn parse(name: &str) -> (String, Vec<u64>) {
    let (mut pattern, mut numbers, mut rest) = (String::new(), Vec::new(), name);
    while let Some(start) = rest.find(|character: char| character.is_ascii_digit()) {
        let digits = &rest[start..];
        let end = digits.find(|character: char| !character.is_ascii_digit()).unwrap_or(digits.len());
        pattern.push_str(&rest[..start]);
        rest = &digits[end..];
        // A longer run of digits than a number has is a part of the name.
        match digits[..end].parse() {
            Ok(number) => {
                pattern.push('#');
                numbers.push(number);
            }
            Err(_) => pattern.push_str(&digits[..end]),
        }
    }
    pattern.push_str(rest);
    (pattern, numbers)
}

/// The order of the files: by the one number in which their names differ, whose steps must be even.
fn order(report: Report, mut files: Vec<Numbered>) -> Result<Vec<PathBuf>, Error> {
    let differing: Vec<usize> =
        (0..files[0].0.len()).filter(|&place| files.iter().any(|file| file.0[place] != files[0].0[place])).collect();
    let names = |a: &Numbered, b: &Numbered| format!("{} and {}", file_name(&a.1), file_name(&b.1));
    if differing.len() > 1 {
        let problem = format!("the names of the slices differ in several numbers, such as {}", {
            let other = files.iter().find(|file| file.0[differing[1]] != files[0].0[differing[1]]);
            names(&files[0], other.unwrap_or(&files[0]))
        });
        return Err(report.unsupported(
            Place::File,
            problem,
            "put the slices of one volume into a folder of their own",
        ));
    }
    files.sort();
    // Where none differs, names do by the zeros before one.
    let place = differing.first().copied().unwrap_or(files[0].0.len().saturating_sub(1));
    let number = |file: &Numbered| file.0.get(place).copied().unwrap_or(0);
    let step = |pair: &[Numbered]| number(&pair[1]) - number(&pair[0]);
    let smallest = files.windows(2).map(step).min().unwrap_or(1);
    if let Some(pair) = files.windows(2).find(|pair| smallest == 0 && step(pair) == 0) {
        let problem = format!("two slices have the number {}: {}", number(&pair[0]), names(&pair[0], &pair[1]));
        return Err(report.unsupported(Place::File, problem, "leave out one of the two"));
    }
    if let Some(pair) = files.windows(2).find(|pair| step(pair) != smallest) {
        let problem = format!("between {} slices are missing", names(&pair[0], &pair[1]));
        return Err(report.unsupported(Place::File, problem, "add them, or number the files without gaps"));
    }
    Ok(files.into_iter().map(|(_, path)| path).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_taken_apart_at_their_numbers() {
        assert_eq!(parse("a12b007.tif"), ("a#b#.tif".to_owned(), vec![12, 7]));
        assert_eq!(parse("µ9"), ("µ#".to_owned(), vec![9]));
        assert_eq!(parse("slice.tif"), ("slice.tif".to_owned(), vec![]));
        assert_eq!(parse("99999999999999999999.tif"), ("99999999999999999999.tif".to_owned(), vec![]));
    }
}

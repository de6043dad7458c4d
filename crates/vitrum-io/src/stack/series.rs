//! Numbered files beside each other, such as `slice0012.tif` and `slice0013.tif`.

use std::path::{Path, PathBuf};

use crate::folder::MOST_FILES;

/// A file name with a number at its end.
struct Numbered<'a> {
    before: &'a str,
    digits: &'a str,
    /// The extension, with its dot.
    after: &'a str,
}

impl<'a> Numbered<'a> {
    fn parse(name: &'a str) -> Option<Self> {
        let (stem, after) = name.split_at(name.rfind('.')?);
        let before = stem.trim_end_matches(|character: char| character.is_ascii_digit());
        let digits = &stem[before.len()..];
        (1..=18).contains(&digits.len()).then_some(Self { before, digits, after })
    }

    /// The file of another number, if it exists.
    fn sibling(&self, folder: &Path, number: u64) -> Option<PathBuf> {
        let Self { before, digits, after } = *self;
        let width = digits.len();
        let padded = format!("{before}{number:0width$}{after}");
        // With or without zeros in front, a name without any may go on from 9 to 10.
        let plain = (!digits.starts_with('0')).then(|| format!("{before}{number}{after}"));
        [Some(padded), plain].into_iter().flatten().map(|name| folder.join(name)).find(|path| path.is_file())
    }
}

/// The unbroken run of numbered files around `path`, lowest number first; `path` alone where its
/// name has no number.
pub(super) fn series(path: &Path) -> Vec<PathBuf> {
    let alone = vec![path.to_owned()];
    let Some(name) = path.file_name().and_then(|name| name.to_str()).and_then(Numbered::parse) else { return alone };
    let Ok(number) = name.digits.parse::<u64>() else { return alone };
    let folder = path.parent().unwrap_or(Path::new(""));
    let below = (0..number).rev().map_while(|number| name.sibling(folder, number));
    let mut files: Vec<_> = below.take(MOST_FILES).collect();
    files.reverse();
    files.push(path.to_owned());
    let above = (number + 1..).map_while(|number| name.sibling(folder, number));
    files.extend(above.take(MOST_FILES));
    files
}

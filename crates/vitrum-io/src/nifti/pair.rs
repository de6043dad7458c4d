//! Pairs: a header in `NAME.hdr`, and its data in `NAME.img` beside it.

use std::path::PathBuf;

use super::header::Kind;
use crate::detached::locate;
use crate::error::{Error, Place, Report};
use crate::input::Input;

const HEADERS: [&str; 2] = [".hdr", ".hdr.gz"];
const IMAGES: [&str; 2] = [".img", ".img.gz"];

/// Whether a name is the name of a pair's header.
pub(super) fn is_header(name: &str) -> bool {
    HEADERS.iter().any(|extension| stem(name, extension).is_some())
}

/// Whether a name is the name of a pair's data.
pub(super) fn is_image(name: &str) -> bool {
    IMAGES.iter().any(|extension| stem(name, extension).is_some())
}

/// The file with the data of a header: plain or gzipped, whichever is there, as the header is where both are.
pub(super) fn image(input: &Input, kind: Kind) -> Result<PathBuf, Error> {
    let report = Report::new(&input.name);
    let place = Place::Byte(kind.layout.magic as u64);
    let [mut first, mut second] = IMAGES;
    let file_name = input.file_name();
    let stem = match HEADERS.map(|extension| stem(&file_name, extension)) {
        [Some(stem), _] => stem,
        [_, Some(stem)] => {
            (first, second) = (second, first);
            stem
        }
        _ => {
            return Err(report.invalid(
                place,
                "this is the header of a NIfTI pair, with its data in an .img file",
                "name the two NAME.hdr and NAME.img, or convert them to a single .nii file",
            ));
        }
    };
    let upper = file_name.ends_with(|last: char| last.is_ascii_uppercase());
    let name =
        |extension: &str| format!("{stem}{}", if upper { extension.to_uppercase() } else { extension.to_owned() });
    let there = |extension: &&str| input.path().with_file_name(name(extension)).exists();
    let extension = [first, second].into_iter().find(|extension| there(extension)).unwrap_or(first);
    locate(report, place, input, &name(extension)).map(|(path, _)| path)
}

/// A name without its extension, in capitals or not.
fn stem<'a>(name: &'a str, extension: &str) -> Option<&'a str> {
    let (stem, end) = name.split_at_checked(name.len().checked_sub(extension.len())?)?;
    end.eq_ignore_ascii_case(extension).then_some(stem)
}

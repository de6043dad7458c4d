//! Sections of a page that a program writes.

use std::fs;
use std::path::Path;

use crate::Failure;

/// The page with the text between `<!-- measured: NAME -->` and the next `<!-- end -->` replaced; nothing if it has no such section.
#[must_use]
pub fn replace(page: &str, name: &str, text: &str) -> Option<String> {
    let begin = format!("<!-- measured: {name} -->\n");
    let (before, rest) = page.split_once(&begin)?;
    let (_, after) = rest.split_once("<!-- end -->")?;
    Some(format!("{before}{begin}{text}\n<!-- end -->{after}"))
}

/// Replaces a section of the page at `path`, see [`replace`].
///
/// # Errors
/// If the page cannot be read or written, or has no such section.
pub fn rewrite(path: &Path, name: &str, text: &str) -> Result<(), Failure> {
    let page = fs::read_to_string(path).map_err(|error| Failure::Output { path: path.to_owned(), error })?;
    let missing = || Failure::Setup(format!("{} has no line `<!-- measured: {name} -->`", path.display()));
    write(path, &replace(&page, name, text).ok_or_else(missing)?)
}

/// Writes a file, and makes its folder if that is missing.
///
/// # Errors
/// If it cannot be written.
pub fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    folder.and_then(|()| fs::write(path, text)).map_err(|error| Failure::Output { path: path.to_owned(), error })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_section_is_replaced() {
        let page = "a\n<!-- measured: one -->\nold\n<!-- end -->\nb\n<!-- measured: two -->\nkept\n<!-- end -->\n";
        let new = replace(page, "one", "new").unwrap();
        assert_eq!(new, page.replace("old", "new"));
        assert_eq!(replace(&new, "one", "new").unwrap(), new);
        assert_eq!(replace(page, "three", "new"), None);
    }
}

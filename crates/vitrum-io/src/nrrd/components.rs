//! A first axis of colours or vectors, whose numbers lie side by side.

use super::header::Header;
use crate::error::{Error, Place, Report, clip};

/// Takes the axis out of a header that begins with one; the number of components, whether they are colours, and where that is said.
pub(super) fn take(header: &mut Header, report: Report) -> Result<Option<(u64, bool, Place)>, Error> {
    let first = |name: &str| header.get(name).and_then(|field| field.text.split_whitespace().next());
    let kind = first("kinds").unwrap_or_default().to_ascii_lowercase();
    let is_none = first("spacedirections").is_some_and(|word| word.eq_ignore_ascii_case("none"));
    let components = matches!(kind.as_str(), "vector" | "list" | "point" | "covariant-vector" | "normal" | "complex")
        || kind.ends_with("-vector")
        || kind.ends_with("-color")
        || kind.ends_with("-normal")
        || kind.ends_with("-gradient");
    let spatial = matches!(kind.as_str(), "domain" | "space" | "time");
    let rank: usize = header.get("dimension").and_then(|field| field.text.trim().parse().ok()).unwrap_or(0);
    if rank < 4 || !(components || is_none && !spatial) {
        return Ok(None);
    }
    let field = header.require(report, "sizes", "sizes: 3 64 64 64")?;
    let place = field.place();
    let count = field.text.split_whitespace().next().and_then(|word| word.parse::<u64>().ok());
    let Some(count) = count else {
        let problem = format!("`sizes: {}` does not begin with a whole number", clip(&field.text));
        return Err(report.invalid(place, problem, "write a size for each axis"));
    };
    let words = ["sizes", "kinds", "spacings", "thicknesses", "axismins", "axismaxs", "centerings", "centers"];
    for name in words.into_iter().chain(["spacedirections"]) {
        header.fields.change(name, without_first_word);
    }
    for name in ["units", "labels"] {
        header.fields.change(name, without_first_quoted);
    }
    header.fields.change("dimension", |_| (rank - 1).to_string());
    Ok(Some((count, kind.ends_with("-color"), place)))
}

/// The field after the first word.
fn without_first_word(text: &str) -> String {
    text.trim_start().split_once(char::is_whitespace).map_or_else(String::new, |(_, rest)| rest.trim_start().to_owned())
}

/// The field after the first text in quotes.
fn without_first_quoted(text: &str) -> String {
    match text.trim_start().strip_prefix('"').and_then(|rest| rest.split_once('"')) {
        Some((_, rest)) => rest.trim_start().to_owned(),
        None => without_first_word(text),
    }
}

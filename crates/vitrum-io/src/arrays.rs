//! Files with several arrays, of which one is read.

use crate::error::{Error, Place, Report, clip};
use crate::setting::Setting;
use crate::source::Assumption;
use crate::suggest::nearest;

/// At most so many names stand in a message.
const MOST_NAMES: usize = 8;

/// A list of names in quotes, for messages: the first [`MOST_NAMES`] and the number of the others.
pub(crate) fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<_> = names.collect();
    let shown: Vec<_> = names.iter().take(MOST_NAMES).map(|name| format!("`{}`", clip(name))).collect();
    let more = names.len().saturating_sub(MOST_NAMES);
    if more > 0 { format!("{} and {more} more", shown.join(", ")) } else { shown.join(", ") }
}

/// The assumption that `taken` is the wanted array of a file that has `others`, too; `None` if it has no other.
pub(crate) fn others_note<'a>(taken: &str, others: impl Iterator<Item = &'a str>) -> Option<Assumption> {
    let others = listed(others);
    let fact = format!("the array `{}` was taken", clip(taken));
    (!others.is_empty()).then(|| Assumption::replaceable(fact, Setting::Array, others))
}

/// The error of an unknown array name.
pub(crate) fn unknown<'a>(report: Report, asked: &str, known: impl Iterator<Item = &'a str> + Clone) -> Error {
    let advice = match nearest(asked, known.clone()) {
        Some(near) => format!("did you mean `{}`?", clip(near)),
        None => match listed(known) {
            names if names.is_empty() => "there are none with a name: leave out the name".to_owned(),
            names => format!("the arrays are: {names}"),
        },
    };
    report.unsupported(Place::File, format!("there is no array `{}`", clip(asked)), advice).with_setting(Setting::Array)
}

//! Elements of a document's lists, by their indices.

use crate::error::{Error, Place, Report};

/// The element of a list that the file names by its index; `from` says where, such as `nodes[3].mesh`.
pub(super) fn lookup<'a, T>(
    report: Report,
    list: &'a [T],
    name: &str,
    index: usize,
    from: impl FnOnce() -> String,
) -> Result<&'a T, Error> {
    list.get(index).ok_or_else(|| {
        let problem = format!("{} is {index}, and there are {} {name}, counted from 0", from(), list.len());
        report.invalid(Place::File, problem, "correct the index")
    })
}

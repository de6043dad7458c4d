//! Limits of the memory that a file may ask for, checked before anything is allocated.

use crate::error::{Error, Report};

/// Bytes of memory that this process can still have, within its control group where it has one.
///
/// `u64::MAX` where the operating system does not say: the allocation itself is then the check.
#[cfg(not(target_family = "wasm"))]
pub(crate) fn available() -> u64 {
    let Ok(mut system) = sysinfo::System::new() else {
        return u64::MAX;
    };
    system.refresh_memory();
    let machine = match system.available_memory() {
        0 => u64::MAX,
        bytes => bytes,
    };
    system.cgroup_limits().map_or(machine, |group| machine.min(group.free_memory))
}

/// A page is not told its memory: the allocation itself is then the check.
#[cfg(target_family = "wasm")]
pub(crate) fn available() -> u64 {
    u64::MAX
}

/// Fails when `needed` decoded bytes exceed `max_bytes`, or the available memory where it is `None`.
pub(crate) fn check(report: Report, needed: u64, max_bytes: Option<u64>) -> Result<(), Error> {
    let (limit, advice) = match max_bytes {
        Some(limit) => (limit, "raise the limit, or crop or downsample the data first"),
        None => (available(), "that is the memory available now: free some, or crop or downsample the data first"),
    };
    if needed > limit {
        return Err(report.too_large(needed, limit, advice));
    }
    Ok(())
}

/// Fails when `bytes` exceed the memory that is available now; `what` is for the message.
///
/// # Errors
///
/// [`Error::TooLarge`].
pub fn require_memory(what: &str, bytes: u64) -> Result<(), Error> {
    check(Report::new(what), bytes, None)
}

/// An empty vector with room for `count` elements, or [`Error::TooLarge`]: never an abort.
pub(crate) fn reserve<T>(report: Report, count: usize) -> Result<Vec<T>, Error> {
    let mut vector = Vec::new();
    vector.try_reserve_exact(count).map_err(|_| {
        let needed = (count as u64).saturating_mul(size_of::<T>() as u64);
        report.too_large(needed, available(), "the system refused the memory: free some first")
    })?;
    Ok(vector)
}

//! Tests that leave themselves out on a machine without the data or the device that they need.

use std::env;
use std::ffi::OsStr;
use std::io::{Write, stdout};
use std::thread;

/// The beginning of the line by which a test reports that it left itself out; `cargo xtask test` counts these lines.
const MARK: &str = "[left out] ";

/// Whether the environment says that this machine has what tests need, so that its lack is a failure.
pub(crate) fn is_required(variable: &str) -> bool {
    is_set(variable)
}

/// Whether an environment variable says yes.
pub(crate) fn is_set(variable: &str) -> bool {
    says_yes(env::var_os(variable).as_deref())
}

/// Whether a variable's value says yes: anything but `0` and an empty text.
fn says_yes(value: Option<&OsStr>) -> bool {
    value.is_some_and(|value| !value.is_empty() && value != "0")
}

/// Says on stdout, past the test harness's capture, that the running test is left out.
pub(crate) fn say(reason: &str) {
    let test = thread::current().name().unwrap_or("a test").to_owned();
    // Not `println!`, which the harness keeps to itself if the test passes. What cannot be written is not missed.
    let _ = writeln!(stdout(), "{MARK}{test}: {reason}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_and_nothing_say_no() {
        assert!(!says_yes(None));
        assert!(["", "0"].iter().all(|value| !says_yes(Some(OsStr::new(value)))));
        assert!(["1", "yes"].iter().all(|value| says_yes(Some(OsStr::new(value)))));
    }
}

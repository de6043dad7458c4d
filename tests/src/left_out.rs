//! Tests that leave themselves out on a machine without the data or the device that they need.

use std::env;
use std::io::{Write, stdout};
use std::thread;

/// The beginning of the line by which a test reports that it left itself out; `cargo xtask test` counts these lines.
const MARK: &str = "[left out] ";

/// Whether the environment says that this machine has what tests need, so that its lack is a failure.
pub(crate) fn is_required(variable: &str) -> bool {
    env::var_os(variable).is_some_and(|value| !value.is_empty() && value != "0")
}

/// Says on stdout, past the test harness's capture, that the running test is left out.
pub(crate) fn say(reason: &str) {
    let test = thread::current().name().unwrap_or("a test").to_owned();
    // Not `println!`, which the harness keeps to itself if the test passes. What cannot be written is not missed.
    let _ = writeln!(stdout(), "{MARK}{test}: {reason}");
}

//! `cargo xtask test`: every test, on both backends.

use std::io::{BufRead, BufReader, Write, stdout};
use std::process::Stdio;
use std::time::Instant;

use crate::command::{announce, cargo, not_started, require_success};
use crate::failure::Failure;
use crate::screen;
use crate::shaders::COMPILER;
use crate::vulkan::{self, Driver, Installation};

/// The beginning of the line by which a test reports that it left itself out for want of data; `vitrum_conformance::data` writes it.
const LEFT_OUT: &str = "[left out] ";

/// The crate of the kernels.
const KERNELS: &str = "vitrum-kernels";

/// Run all tests with both backends; a missing Vulkan driver is installed where that is possible, else a failure.
///
/// What will be installed is said first: Mesa's software driver for Vulkan, and Xvfb and xdotool for the real window, on Debian and Ubuntu, as root.
/// Nothing else is.
#[derive(clap::Args, Default)]
pub struct Arguments {
    /// Install nothing. Without a Vulkan driver, tests of the GPU backend are left out; the summary says so and counts them.
    #[arg(long)]
    no_install: bool,

    /// Passed on to `cargo test`; a plain word selects the tests whose names contain it.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<String>,
}

/// Runs the tests and prints a summary.
///
/// The shader compiler is left out: its dependencies build SPIRV-Tools, which takes longer than all tests, and what it
/// makes is committed and tested here. `cargo xtask ci` covers it. The kernels' own test program is left out, too, for which all kernels would be compiled
/// a second time: `tests/tests/kernel_units.rs` runs its tests.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let installation = if arguments.no_install { Installation::Forbidden } else { Installation::Allowed };
    let driver = vulkan::driver(installation)?;
    screen::install_missing(installation);
    if let Driver::Missing(reason) = &driver {
        eprintln!("xtask: {reason}");
        eprintln!("xtask: tests of the GPU backend leave themselves out; the summary lists and counts them");
    }
    let mut command =
        cargo(["test", "--release", "--workspace", "--exclude", COMPILER, "--exclude", KERNELS, "--no-fail-fast"]);
    command.args(&arguments.arguments);
    // Errors against closed forms are held to their bounds, and not only listed.
    command.env("VITRUM_REQUIRE_GPU", requirement(&driver)).env("VITRUM_MEASURE", "0").stdout(Stdio::piped());

    announce(&command);
    let start = Instant::now();
    let mut child = command.spawn().map_err(|error| not_started(&command, &error))?;
    let mut summary = Summary::default();
    let mut output = BufReader::new(child.stdout.take().expect("stdout is piped"));
    let mut line = Vec::new();
    while output.read_until(b'\n', &mut line).is_ok_and(|length| length > 0) {
        // A closed stdout must not end the tests.
        let _ = stdout().write_all(&line);
        summary.read_line(&String::from_utf8_lossy(&line));
        line.clear();
    }
    let status = child.wait().map_err(|error| not_started(&command, &error))?;
    let driver = match &driver {
        Driver::Found(name) => name.clone(),
        Driver::Missing(reason) => format!("none ({reason})"),
    };
    println!("\n{}\nVulkan driver: {driver}\n{:.1} s", summary.text(), start.elapsed().as_secs_f64());
    require_success(&command, status)?;
    if summary.passed == 0 && arguments.arguments.is_empty() {
        return Err(Failure::check("no test ran"));
    }
    Ok(())
}

/// The value of `VITRUM_REQUIRE_GPU`: with a driver, a test that finds no adapter fails; without, it leaves itself out.
fn requirement(driver: &Driver) -> &'static str {
    match driver {
        Driver::Found(_) => "1",
        Driver::Missing(_) => "0",
    }
}

/// The output of the test programs.
#[derive(Default)]
struct Summary {
    programs: usize,
    passed: usize,
    failed: usize,
    ignored: usize,
    left_out: Vec<String>,
}

impl Summary {
    fn read_line(&mut self, line: &str) {
        if let Some((_, what)) = line.split_once(LEFT_OUT) {
            self.left_out.push(what.trim_end().to_owned());
        }
        let Some(result) = line.strip_prefix("test result: ") else { return };
        self.programs += 1;
        for part in result.split([';', '.']) {
            match part.trim().split_once(' ') {
                Some((count, "passed")) => self.passed += count.parse().unwrap_or(0),
                Some((count, "failed")) => self.failed += count.parse().unwrap_or(0),
                Some((count, "ignored")) => self.ignored += count.parse().unwrap_or(0),
                _ => {}
            }
        }
    }

    fn text(&self) -> String {
        let Self { programs, passed, failed, ignored, left_out } = self;
        let mut text = format!("tests: {passed} passed, {failed} failed, {ignored} ignored in {programs} programs");
        if !left_out.is_empty() {
            text.push_str(&format!("\n{} of the passed tests left something out:", left_out.len()));
            left_out.iter().for_each(|what| text.push_str(&format!("\n  {what}")));
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(Parser)]
    struct Task {
        #[command(flatten)]
        arguments: Arguments,
    }

    #[test]
    fn a_flag_of_the_task_stands_before_those_of_the_tests() {
        let parsed = |line: &[&str]| Task::parse_from([&["test"], line].concat()).arguments;
        let arguments = parsed(&["--no-install", "--test", "docs"]);
        assert!(arguments.no_install);
        assert_eq!(arguments.arguments, ["--test", "docs"]);
        let arguments = parsed(&["golden"]);
        assert!(!arguments.no_install);
        assert_eq!(arguments.arguments, ["golden"]);
    }

    #[test]
    fn an_adapter_is_required_where_there_is_a_driver() {
        assert_eq!(requirement(&Driver::Found("lvp_icd.json".to_owned())), "1");
        assert_eq!(requirement(&Driver::Missing("no loader".to_owned())), "0");
    }

    #[test]
    fn results_add_up() {
        let mut summary = Summary::default();
        summary.read_line("running 3 tests");
        summary.read_line(
            "test result: ok. 19 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.00s\n",
        );
        summary.read_line(
            "test result: FAILED. 2 passed; 3 failed; 0 ignored; 0 measured; 7 filtered out; finished in 1.25s\n",
        );
        assert_eq!(summary.text(), "tests: 21 passed, 3 failed, 1 ignored in 2 programs");
    }

    #[test]
    fn what_is_left_out_is_told() {
        let mut summary = Summary::default();
        summary.read_line("test tooth ... [left out] tooth: shared/data/tooth.nrrd is missing\n");
        assert_eq!(summary.left_out, ["tooth: shared/data/tooth.nrrd is missing"]);
        assert!(summary.text().contains("\n  tooth: shared/data"), "{}", summary.text());
    }
}

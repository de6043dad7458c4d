//! Errors against closed forms: measured values, and the bounds that tests hold them to.
//!
//! This table is the source of the first table of `docs/accuracy.md` (`cargo xtask docs`). No bound is more than twice the measured value. To
//! refresh a value, take it from the failure's message, or list them all; nothing is held to the table then:
//! `VITRUM_MEASURE=1 cargo test --release -p vitrum-conformance --test closed_forms --test refraction --test beams -- --nocapture | grep measured`.

use std::fmt;

use vitrum::backend::Backend;

pub use super::lines::*;
use crate::bounds;
use crate::left_out;

/// The environment variable by which errors are listed, and not held to the table.
const MEASURE: &str = "VITRUM_MEASURE";

/// How far a measured value may be from the table's on a backend that is held to the last bit: the table has two digits.
const ROUNDING: f64 = 0.05;

/// The error of a quantity whose true value is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorBound {
    /// The closed form.
    pub form: &'static str,
    /// The grid, and the part of the picture that is measured.
    pub setup: &'static str,
    /// The quantity with the error, and its unit.
    pub quantity: &'static str,
    /// The largest error measured, the same to the last bit on the CPU and on lavapipe; two digits.
    pub measured: f64,
    /// The largest error that a test allows, at most twice what was measured.
    pub bound: f64,
    /// The largest error allowed on adapters that are not held to the last bit, if it is another one: where the error is rounding alone.
    pub elsewhere: Option<f64>,
}

impl ErrorBound {
    /// Holds an error to the bound, and on a backend that is exact also to the measured value.
    ///
    /// # Panics
    /// If it is larger, or the table is out of date.
    pub fn hold(&self, error: f64, backend: &dyn Backend) {
        self.hold_on(error, backend.name(), bounds::is_exact(backend));
    }

    /// As [`Self::hold`], of a computation that needs no backend.
    ///
    /// # Panics
    /// As [`Self::hold`].
    pub fn hold_native(&self, error: f64) {
        self.hold_on(error, "native", true);
    }

    fn hold_on(&self, error: f64, place: &str, is_exact: bool) {
        println!("measured: {self}: {error:.3e} ({place}), {:.1e} in the table", self.measured);
        if left_out::is_set(MEASURE) {
            return;
        }
        let bound = if is_exact { self.bound } else { self.elsewhere.unwrap_or(self.bound) };
        assert!(error <= bound, "{self}: {error:.3e} was measured ({place}), the bound is {bound:.1e}");
        assert!(
            !is_exact || (error - self.measured).abs() <= ROUNDING * self.measured,
            "{self}: {error:.3e} was measured ({place}), but tests/src/closed_forms/lines.rs says {:.1e}; put the new value there and run \
             `cargo xtask docs`",
            self.measured
        );
    }

    fn cells(&self, before: Option<&Self>) -> [String; 5] {
        // Where a cell says what the one above it says, it stays empty.
        let form = if before.is_some_and(|before| before.form == self.form) { "" } else { self.form };
        let setup = if before.is_some_and(|before| (before.form, before.setup) == (self.form, self.setup)) {
            ""
        } else {
            self.setup
        };
        [form.to_owned(), setup.to_owned(), self.quantity.to_owned(), digits(self.measured), digits(self.bound)]
    }
}

impl fmt::Display for ErrorBound {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}; {}; {}", self.form, self.setup, self.quantity)
    }
}

/// The larger of two errors, and NaN if one of them is.
#[must_use]
pub fn larger(one: f64, other: f64) -> f64 {
    if one.is_nan() || one > other { one } else { other }
}

/// A number with two digits, as people write it.
fn digits(value: f64) -> String {
    if value >= 1.0 {
        return format!("{value:.1}");
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{value:.1e}");
    if value < 1e-3 { text } else { text.parse::<f64>().map_or(text, |rounded| rounded.to_string()) }
}

/// The names of the table's columns.
pub const HEADER: [&str; 5] = ["closed form", "set-up", "error of", "measured", "bound"];

/// The cells of each line.
pub fn cells() -> impl Iterator<Item = [String; 5]> {
    let before = |index: usize| index.checked_sub(1).map(|before| &ALL[before]);
    ALL.iter().enumerate().map(move |(index, line)| line.cells(before(index)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::catch_unwind;

    #[test]
    fn no_bound_is_more_than_twice_what_was_measured() {
        for line in ALL {
            assert!(line.measured >= 0.0 && line.measured <= line.bound, "{line}");
            assert!(
                line.bound <= 2.0 * line.measured * (1.0 + 1e-9),
                "{line}: {:.1e} for {:.1e}",
                line.bound,
                line.measured
            );
            assert!(line.elsewhere.is_none_or(|elsewhere| elsewhere > line.bound), "{line}");
        }
    }

    #[test]
    fn lines_have_different_names() {
        let mut names: Vec<String> = ALL.iter().map(ToString::to_string).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), ALL.len());
    }

    #[test]
    fn an_error_beyond_its_bound_and_a_table_that_is_out_of_date_fail() {
        let holds = |line: ErrorBound, error: f64, is_exact: bool| {
            catch_unwind(|| line.hold_on(error, "test", is_exact)).is_ok()
        };
        let ErrorBound { measured, bound, .. } = LAYER_EXIT;
        assert!(holds(LAYER_EXIT, measured, true) && holds(LAYER_EXIT, bound, false) && holds(LAYER_EXIT, 0.0, false));
        assert!(!holds(LAYER_EXIT, 1.01 * bound, false) && !holds(LAYER_EXIT, f64::NAN, false));
        assert!(!holds(LAYER_EXIT, 1.1 * measured, true) && !holds(LAYER_EXIT, 0.9 * measured, true));
        assert!(holds(LIGHTS_AMBIENT, 0.0, true) && !holds(LIGHTS_AMBIENT, 1e-9, true));
        assert!(holds(LIGHTS_AMBIENT, 1e-9, false) && !holds(LIGHTS_AMBIENT, 2e-6, false));
    }

    #[test]
    fn an_error_that_is_no_number_is_the_largest() {
        assert_eq!((larger(1.0, 2.0), larger(2.0, 1.0)), (2.0, 2.0));
        assert!(larger(f64::NAN, 1.0).is_nan() && larger(1.0, f64::NAN).is_nan());
    }

    #[test]
    fn numbers_have_two_digits() {
        assert_eq!(
            [0.0, 1.44e-8, 0.000_62, 0.0114, 0.5, 1.0].map(digits),
            ["0", "1.4e-8", "6.2e-4", "0.011", "0.5", "1.0"]
        );
    }

    #[test]
    fn equal_cells_below_each_other_stay_empty() {
        let cells: Vec<[String; 5]> = cells().collect();
        assert_eq!(cells.len(), ALL.len());
        assert_eq!(cells.iter().filter(|cells| cells[0] == LUNEBURG_CENTRAL.form).count(), 1);
        assert!(cells.iter().any(|cells| cells[0].is_empty() && !cells[1].is_empty()));
    }
}

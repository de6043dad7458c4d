//! The program `vitrum`, which the wheel brings along.

use pyo3::prelude::*;

/// Runs the program with these words, the program's name first, and returns its exit code.
#[pyfunction]
pub fn main(py: Python<'_>, words: Vec<std::ffi::OsString>) -> u8 {
    py.detach(|| vitrum_cli::run(&words))
}

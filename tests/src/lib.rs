//! Conformance: both backends against each other, against closed forms and against golden pictures.
//!
//! The tests in `tests/` and the programs `conformance` (`cargo xtask diff`) and `bench` (`cargo xtask bench`) share what
//! is here: which [`bounds`] hold where, the [`table`] of what was measured, and the [`evidence`] that a breach leaves.

pub mod bounds;
pub mod data;
pub mod evidence;
pub mod table;

use std::path::{Path, PathBuf};

/// The workspace's root folder.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("this package lies in the workspace").to_owned()
}

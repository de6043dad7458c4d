//! Coverage-guided fuzzing of every reader: `cargo xtask fuzz`, and `docs/security.md` for what it found.
//!
//! A workspace of its own, since libFuzzer needs a nightly compiler. What the targets do stands beside the tests of
//! `vitrum-io`, which run it on a fixed set of mutations with the stable one.

#[path = "../../crates/vitrum-io/tests/readers/mod.rs"]
pub mod readers;

pub use libfuzzer_sys::fuzz_target;

/// A fuzz target: the reader of this name.
#[macro_export]
macro_rules! target {
    ($name:literal) => {
        static READERS: std::sync::LazyLock<$crate::readers::Readers> =
            std::sync::LazyLock::new(|| $crate::readers::Readers::new($name));
        $crate::fuzz_target!(|bytes: &[u8]| READERS.read($name, bytes));
    };
}

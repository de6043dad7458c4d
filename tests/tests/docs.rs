//! The parts of `docs/` that are made from the code are current.

use vitrum_conformance::docs;

#[test]
fn files_that_are_made_from_the_code_are_current() {
    for made in docs::all().unwrap() {
        assert!(made.is_current().unwrap(), "{} is not current; run: cargo xtask docs", made.path.display());
    }
}

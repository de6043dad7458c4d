//! The unit tests that stand in the kernels' sources.
//!
//! A test program of the crate `vitrum-kernels` would have all kernels compiled a second time, which takes longer than most tests: `cargo xtask test` leaves it
//! out. Here the files with tests alone are compiled again, beside the crate that they are part of.

use std::fs;
use std::path::Path;
// What the files call `crate`.
use vitrum_kernels::{abi, field, math, sweep};

/// The folder of the kernels, from here.
const KERNELS: &str = "../../shaders-rs/src/";

/// The modules of these files.
macro_rules! files {
    ($($module:ident: $path:literal),* $(,)?) => {
        $(#[allow(dead_code, reason = "its tests alone are looked at")] #[path = $path] mod $module;)*
        const FILES: &[&str] = &[$($path),*];
    };
}

files! {
    tiles: "../../shaders-rs/src/sweep/tiles.rs",
    offset: "../../shaders-rs/src/sweep/light/offset.rs",
    placed: "../../shaders-rs/src/sweep/light/placed.rs",
    quad: "../../shaders-rs/src/sweep/light/quad.rs",
    receiver_map: "../../shaders-rs/src/sweep/light/receiver_map.rs",
}

#[test]
fn every_file_with_tests_is_here() {
    fn gather(folder: &Path, root: &Path, found: &mut Vec<String>) {
        for entry in fs::read_dir(folder).expect("the kernels are there") {
            let path = entry.expect("a file").path();
            if path.is_dir() {
                gather(&path, root, found);
            } else if fs::read_to_string(&path).expect("text").contains("#[cfg(test)]") {
                let below = path.strip_prefix(root).expect("it is below");
                found.push(below.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shaders-rs/src");
    let mut found = Vec::new();
    gather(&root, &root, &mut found);
    found.sort();
    let mut listed: Vec<&str> = FILES.iter().filter_map(|path| path.strip_prefix(KERNELS)).collect();
    listed.sort_unstable();
    assert_eq!(found, listed, "list the file in `files!`, so that its tests run");
}

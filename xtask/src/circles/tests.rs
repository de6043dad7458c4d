//! Crates made for these tests, with and without circles.

use std::fs;
use std::path::PathBuf;

use tempfile::TempDir;

use super::{Arguments, Graph, check};

/// A crate of files, by their paths and contents, the root first.
struct Planted {
    folder: TempDir,
    root: PathBuf,
}

impl Planted {
    fn new(files: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        for (path, content) in files {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().expect("a file has a folder")).expect("a folder");
            fs::write(path, content).expect("a written file");
        }
        let root = folder.path().join(files[0].0);
        Self { folder, root }
    }

    /// The circles, as names of files.
    fn circles(&self) -> Vec<Vec<String>> {
        self.circles_by(false)
    }

    fn circles_by(&self, relative: bool) -> Vec<Vec<String>> {
        let graph = Graph::of_crate(&self.root, relative).expect("the crate is read");
        let name = |&file: &usize| graph.files[file].clone();
        graph.circles().iter().map(|circle| circle.iter().map(name).collect()).collect()
    }

    fn check(&self) -> Result<(), String> {
        assert!(self.folder.path().is_dir());
        let crates = [("planted".to_owned(), self.root.clone())];
        check(&crates, &Arguments { uses: true, ..Arguments::default() }).map_err(|failure| {
            assert_eq!(failure.code, 1);
            failure.message
        })
    }
}

const LIB: &str = "mod a; mod b; mod c; mod d;";

#[test]
fn a_circle_of_four_files_fails_and_one_of_three_passes() {
    let four = Planted::new(&[
        ("lib.rs", LIB),
        ("a.rs", "use crate::b::B; pub struct A(B);"),
        ("b.rs", "pub struct B; pub fn f() -> super::c::C { super::c::C }"),
        ("c.rs", "pub struct C; fn f() { println!(\"{}\", crate::d::NUMBER); }"),
        ("d.rs", "pub const NUMBER: u32 = 1; impl From<crate::a::A> for u32 { fn from(_: crate::a::A) -> Self { 1 } }"),
    ]);
    assert_eq!(four.circles(), [["a.rs", "b.rs", "c.rs", "d.rs"]]);
    assert!(four.check().unwrap_err().contains("planted (4 files)"));

    let three = Planted::new(&[
        ("lib.rs", LIB),
        ("a.rs", "use crate::b::B; pub struct A(B);"),
        ("b.rs", "pub struct B; pub fn f() -> super::c::C { super::c::C }"),
        ("c.rs", "pub struct C; fn f(_: crate::a::A) {}"),
        ("d.rs", "fn f(_: crate::a::A) {}"),
    ]);
    assert_eq!(three.circles(), [["a.rs", "b.rs", "c.rs"]]);
    assert_eq!(three.check(), Ok(()));
}

#[test]
fn a_re_export_leads_to_the_file_that_defines_the_item() {
    // The child names its sibling's item by the parent, which uses neither.
    let planted = Planted::new(&[
        ("lib.rs", "mod parent; pub use parent::Item as Renamed;"),
        ("parent/mod.rs", "mod first; mod second; pub use self::first::Item; pub use second::*;"),
        ("parent/first.rs", "pub struct Item;"),
        ("parent/second.rs", "use super::Item; use crate::Renamed; pub fn second(_: Item, _: Renamed) {}"),
    ]);
    assert!(planted.circles().is_empty());
    // Now the item needs what the sibling defines, by the glob.
    fs::write(
        planted.folder.path().join("parent/first.rs"),
        "pub struct Item; impl Item { fn f(self) { crate::parent::second(self, Item) } }",
    )
    .expect("a written file");
    assert_eq!(planted.circles(), [["parent/first.rs", "parent/second.rs"]]);
    // The same by a glob of its own.
    fs::write(
        planted.folder.path().join("parent/first.rs"),
        "use super::*; pub struct Item; impl Item { fn f(self) { second(self, Item) } }",
    )
    .expect("a written file");
    assert_eq!(planted.circles(), [["parent/first.rs", "parent/second.rs"]]);
}

#[test]
fn what_a_module_names_of_its_submodules_counts_by_a_use_line() {
    let child = ("parent/child.rs", "pub struct Child; pub fn f() -> super::Parent { super::Parent }");
    let with = |parent| Planted::new(&[("lib.rs", "mod parent;"), ("parent/mod.rs", parent), child]);
    let imported = with("mod child; use self::child::Child; pub struct Parent; fn f(_: Child) {}");
    assert_eq!(imported.circles(), [["parent/mod.rs", "parent/child.rs"]]);
    for parent in [
        "mod child; pub use self::child::Child; pub struct Parent; fn f(_: Child) {}",
        "mod child; pub struct Parent; fn f() { child::f(); }",
    ] {
        assert!(with(parent).circles().is_empty());
        assert_eq!(with(parent).circles_by(true), [["parent/mod.rs", "parent/child.rs"]]);
    }
}

#[test]
fn a_module_and_a_function_of_one_name_are_told_apart() {
    let planted = Planted::new(&[
        ("lib.rs", "mod open; mod user; pub use open::open;"),
        ("open.rs", "pub fn open() {} pub struct Options;"),
        ("user.rs", "use crate::open; fn f(_: open::Options) { open(); crate::open::open(); }"),
    ]);
    assert!(planted.circles().is_empty());
    let graph = Graph::of_crate(&planted.root, true).expect("the crate is read");
    let names: Vec<_> = graph.uses.iter().map(|used| (used.from, used.to, used.name.as_str())).collect();
    assert_eq!(names, [(2, 1, "Options"), (2, 1, "open")]);
}

#[test]
fn tests_inline_modules_and_paths_of_files_are_understood() {
    let planted = Planted::new(&[
        ("lib.rs", "mod a; #[path = \"other/place.rs\"] mod b;"),
        (
            "a.rs",
            "use crate::b::B; pub struct A(B); pub mod inner { pub fn f(_: super::super::b::B) {} } \
             #[cfg(test)] mod tests { use crate::b::unused; }",
        ),
        ("other/place.rs", "pub struct B; #[cfg(test)] mod tests { use crate::a::A; }"),
    ]);
    assert!(planted.circles().is_empty());
    fs::write(planted.folder.path().join("other/place.rs"), "pub struct B; fn f() { crate::a::inner::f(B) }")
        .expect("a written file");
    assert_eq!(planted.circles(), [["a.rs", "other/place.rs"]]);
}

#[test]
fn re_exports_that_go_round_end() {
    let planted = Planted::new(&[
        ("lib.rs", "mod a; mod b;"),
        ("a.rs", "pub use crate::b::*; pub use crate::b::Item; fn f(_: Item) {}"),
        ("b.rs", "pub use crate::a::*; pub use crate::a::Item; fn f(_: Item) {}"),
    ]);
    assert!(planted.circles().is_empty());
}

//! The pages in `docs/adding` name files that exist.

use std::fs;

use vitrum_conformance::root;

/// The paths that a page names: words between backticks with a slash in them that are not code.
fn paths(page: &str) -> impl Iterator<Item = &str> {
    let words = page.split('`').skip(1).step_by(2);
    words.filter(|word| word.contains('/') && !word.contains([' ', '(', '<', ':', '*']))
}

#[test]
fn every_file_that_a_page_names_exists() {
    let mut count = 0;
    for entry in fs::read_dir(root().join("docs/adding")).expect("the folder is there") {
        let file = entry.expect("it can be listed").path();
        let page = fs::read_to_string(&file).expect("a page is text");
        for path in paths(&page) {
            assert!(root().join(path).exists(), "{} names {path}, which does not exist", file.display());
            count += 1;
        }
    }
    assert!(count > 30, "only {count} paths were found");
}

#[test]
fn every_decision_is_in_the_index() {
    let folder = root().join("docs/adr");
    let index = fs::read_to_string(folder.join("README.md")).expect("the index is there");
    for entry in fs::read_dir(&folder).expect("the folder is there") {
        let name = entry.expect("it can be listed").file_name().into_string().expect("names are text");
        assert!(name == "README.md" || index.contains(&format!("({name})")), "docs/adr/README.md lacks {name}");
    }
}

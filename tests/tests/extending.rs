//! The examples in `docs/extending.md` are in the tree.

use std::fs;

use vitrum_conformance::root;

/// Lines without their indentation.
fn lines(text: &str) -> Vec<&str> {
    text.lines().map(str::trim).filter(|line| !line.is_empty()).collect()
}

#[test]
fn every_example_is_in_the_file_it_names() {
    let page = fs::read_to_string(root().join("docs/extending.md")).expect("the page is there");
    let mut examples = 0;
    for part in page.split("<!-- from ").skip(1) {
        let (path, rest) = part.split_once(" -->").expect("a path ends with -->");
        let example = rest.split("```rust").nth(1).and_then(|rest| rest.split("```").next()).expect("a block follows");
        let source = fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
        let (source, example) = (lines(&source), lines(example));
        assert!(
            source.windows(example.len()).any(|window| window == example),
            "docs/extending.md shows what is not in {path}:\n{}",
            example.join("\n")
        );
        examples += 1;
    }
    assert_eq!((examples, page.matches("```rust").count()), (6, 6), "each example names the file it is from");
}

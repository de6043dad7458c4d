//! `docs/conformance.md` shows the bounds as they are.

use std::fs;

use vitrum_conformance::bounds::{self, FAMILIES};
use vitrum_conformance::root;

#[test]
fn the_page_has_the_table_of_families() {
    let path = root().join("docs/conformance.md");
    let page = fs::read_to_string(path).expect("the page is there");
    let (_, rest) = page.split_once("<!-- table of families -->\n").expect("the table begins");
    let (table, _) = rest.split_once("\n<!-- end -->").expect("the table ends");
    let now = bounds::markdown(&FAMILIES);
    assert!(table == now, "docs/conformance.md should show\n{now}");
}

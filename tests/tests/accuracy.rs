//! `docs/accuracy.md` has what `cargo xtask accuracy` measures.

use std::fs;

use vitrum::backend::CpuBackend;
use vitrum_conformance::accuracy::{ALL, replace};
use vitrum_conformance::{Failure, root};

fn page() -> String {
    fs::read_to_string(root().join("docs/accuracy.md")).expect("the page is there")
}

#[test]
fn every_section_is_on_the_page_with_its_plot() {
    let page = page();
    for (name, _) in ALL {
        assert!(replace(&page, name, "").is_some_and(|without| without != page), "{name}: run `cargo xtask accuracy`");
        assert!(page.contains(&format!("(accuracy/{name}.svg)")), "{name} shows no plot");
        let plot = root().join("docs/accuracy").join(format!("{name}.svg"));
        assert!(fs::read_to_string(plot).is_ok_and(|text| text.starts_with("<svg")), "{name}: no plot");
    }
}

/// The ray step needs nothing that differs from machine to machine, so what the page says of it can be measured again anywhere.
#[test]
fn the_page_says_what_is_measured() -> Result<(), Failure> {
    let (name, measure) = ALL[0];
    let section = measure(&mut CpuBackend::new(Some(1))?)?;
    assert!(page().contains(&section.text), "{name}: run `cargo xtask accuracy --only {name}`\n{}", section.text);
    let plot = fs::read_to_string(root().join("docs/accuracy/step.svg")).expect("the plot is there");
    assert!(section.plot.svg().is_ok_and(|svg| svg == plot), "{name}: the plot is another one");
    Ok(())
}

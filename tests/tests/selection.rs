//! `cargo xtask diff` compares the cases that its options select.

use std::collections::BTreeSet;
use std::fs;
use std::process::{Command, Output};

use serde_json::Value;
use vitrum_conformance::adapter;

fn conformance(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_conformance")).args(arguments).output().expect("the program starts")
}

/// Runs the program with `--json`. The result has the numbers, and the text of the page that the same run wrote.
fn measured(arguments: &[&str]) -> (Value, String) {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (json, html) = (path("numbers.json"), path("report.html"));
    let output = conformance(&[arguments, &["--json", &json, "--html", &html]].concat());
    let read = |path: &str| {
        fs::read_to_string(path).unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&output.stderr)))
    };
    let numbers: Value = serde_json::from_str(&read(&json)).expect("it is JSON");
    // Whether a bound holds is for other tests to say; here, that the exit code says what the numbers do.
    assert_eq!(output.status.code(), Some(if numbers["passed"] == true { 0 } else { 1 }));
    (numbers, read(&html))
}

fn values(numbers: &Value, key: &str) -> BTreeSet<String> {
    let rows = numbers["rows"].as_array().expect("rows are a list");
    rows.iter().map(|row| row[key].as_str().expect("it is a text").to_owned()).collect()
}

fn texts<const N: usize>(texts: [&str; N]) -> BTreeSet<String> {
    texts.map(str::to_owned).into()
}

#[test]
fn golden_pictures_need_no_adapter() {
    let (numbers, page) = measured(&["--tier", "t3", "--scene", "ball", "--scene", "lune", "--method", "sweep"]);
    assert_eq!(values(&numbers, "tier"), texts(["T3"]));
    assert_eq!(values(&numbers, "scene"), texts(["ball", "luneburg"]));
    assert_eq!(values(&numbers, "method"), texts(["sweep"]));
    assert_eq!(numbers["backends"], serde_json::json!(["CPU against golden pictures"]));
    assert!(page.contains("luneburg") && !page.contains("supernova") && page.contains("data:image/png"));
}

#[test]
fn tiers_and_adapters_are_selected() {
    let Some(gpu) = adapter::for_test() else { return };
    let name = vitrum::backend::Backend::adapter(&gpu);
    // The same adapter twice is one adapter.
    let adapters = ["--adapter", &name[..10], "--adapter", &name[..8]];
    let (numbers, _) =
        measured(&[["--tier", "t1", "--tier", "t3", "--scene", "ball eu"].as_slice(), &adapters].concat());
    assert_eq!(values(&numbers, "tier"), texts(["T1"]));
    assert_eq!(values(&numbers, "scene"), texts(["ball euler"]));
    // Once with SPIR-V as it is, where the driver takes it, and once translated.
    let backends = |numbers: &Value| -> Vec<String> {
        let texts = numbers["backends"].as_array().expect("it is a list").iter();
        texts.map(|text| text.as_str().expect("it is a text").to_owned()).collect()
    };
    let found = backends(&numbers);
    let is_translated = |text: &String| text.ends_with("; shaders translated)");
    assert!(found.len() == if is_translated(&name) { 1 } else { 2 } && found[0].ends_with(&name), "{found:?}");
    assert_eq!(found.iter().filter(|text| is_translated(text)).count(), 1, "{found:?}");
    let (numbers, _) = measured(&["--tier", "t1", "--scene", "ball eu", "--shaders", "translated"]);
    assert_eq!(backends(&numbers).iter().map(is_translated).collect::<Vec<_>>(), [true]);
}

#[test]
fn what_is_not_known_is_refused_with_what_is() {
    for (arguments, known) in [
        (["--tier", "t9"].as_slice(), "t0, t1, t2, t3"),
        (&["--method", "beems"], "sweep"),
        (
            &["--tier", "t3", "--scene", "ball", "--scene", "bell"],
            "angel-ball, ball, ball-in-fog, combustion, gem, glass, goblet, head, luneburg, ocean, phantom, prism, ring, smoke, statue, still-life, supernova, torus, tree, vase",
        ),
        (&["--tier", "t1", "--scene", "bell"], "head all"),
    ] {
        let output = conformance(arguments);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(known) && message.contains(arguments.last().unwrap()), "{message}");
    }
}

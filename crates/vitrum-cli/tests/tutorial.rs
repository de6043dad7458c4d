//! The tutorial's commands, in their order, from start to end.

mod common;

use common::Folder;
use std::fs;

/// The commands of the page's blocks of shell, without `vitrum`.
fn commands(page: &str) -> Vec<Vec<String>> {
    let blocks = page.split("```sh\n").skip(1).map(|rest| rest.split("```").next().unwrap_or_default());
    blocks.flat_map(str::lines).filter_map(|line| line.strip_prefix("vitrum ")).map(words).collect()
}

/// The words of a line, as a shell parts them: quotation marks of one kind hold the other kind.
fn words(line: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut within = None;
    for letter in line.chars() {
        match (within, letter) {
            (None, '"' | '\'') => within = Some(letter),
            (Some(mark), letter) if mark == letter => within = None,
            (None, ' ') => words.push(String::new()),
            (_, letter) => words.last_mut().expect("there is one").push(letter),
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

#[test]
fn every_command_of_the_tutorial_works_in_its_order() {
    let folder = Folder::new();
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/tutorial.md");
    let page = fs::read_to_string(path).expect("the page is there");
    let commands = commands(&page);
    assert!(commands.len() > 8, "{commands:?}");
    for command in &commands {
        let mut arguments: Vec<&str> = command.iter().map(String::as_str).collect();
        if ["render", "turntable", "presets"].contains(&arguments[0]) {
            arguments.extend(["--backend", "cpu", "--quiet"]);
        }
        let told = folder.succeed(&arguments);
        if command[0] == "info" {
            let landmarks = told.lines().find(|line| line.starts_with("landmarks")).expect("a scan has landmarks");
            let shown =
                page.split("Here: `").nth(1).and_then(|rest| rest.split('`').next()).expect("the page has them");
            assert!(landmarks.contains(shown), "{landmarks}, and the page says {shown}");
        }
        if let Some(at) = command.iter().position(|word| word == "-o") {
            let made = fs::metadata(folder.file(&command[at + 1])).expect("the file was written");
            assert!(made.len() > 500, "{command:?}: {} bytes", made.len());
        }
    }
    // The figure is on white, and its annotations are there apart.
    let figure = vitrum_io::read_picture(&folder.file("figure.png")).expect("a picture");
    let corner = figure.color()[0];
    assert!(corner.iter().all(|&value| value > 0.99), "{corner:?}");
    let annotations = fs::read_to_string(folder.file("figure.svg")).expect("an SVG");
    assert!(annotations.contains("bone above 300 HU") && annotations.contains("dm"), "{annotations}");
}

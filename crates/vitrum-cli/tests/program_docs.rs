//! `docs/program.md` documents every command and every flag.

mod common;

use common::Folder;
use std::path::Path;

/// The first words of the lines below a heading of `--help`, up to the next blank line.
fn listed<'a>(help: &'a str, heading: &str) -> Vec<&'a str> {
    let lines = help.lines().skip_while(|line| *line != heading).skip(1).take_while(|line| !line.is_empty());
    // Descriptions that go on in the next line are indented further.
    lines.filter_map(|line| line.strip_prefix("  ")?.split(' ').next()).filter(|word| !word.is_empty()).collect()
}

fn page() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/program.md");
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn every_exit_code_is_documented() {
    let help = Folder::new().succeed(&["--help"]);
    let (_, told) = help.split_once("Exit codes: ").expect("the help tells exit codes");
    let (told, _) = told.split_once("\n\n").expect("another paragraph follows");
    let words = told.split([',', ' ', '\n']).filter_map(|word| word.trim_end_matches('.').parse::<u8>().ok());
    let page = page();
    let (_, table) = page.split_once("| exit code | meaning |\n|---|---|\n").expect("the page has the table");
    let rows = table.lines().take_while(|line| line.starts_with('|'));
    let documented: Vec<u8> = rows.filter_map(|row| row.split('|').nth(1)?.trim().parse().ok()).collect();
    assert_eq!(words.collect::<Vec<u8>>(), documented);
    assert!(documented.len() > 5, "{documented:?}");
}

#[test]
fn every_command_and_flag_is_documented() {
    let page = page();
    let folder = Folder::new();
    let help = folder.succeed(&["-h"]);
    let commands = listed(&help, "Commands:");
    assert!(commands.len() > 8, "the help was not understood:\n{help}");
    for command in commands.into_iter().filter(|command| *command != "help") {
        let named = format!("`vitrum {command}");
        let mut sections =
            page.split("\n## ").filter(|section| section.lines().next().is_some_and(|head| head.contains(&named)));
        let section = sections.next().unwrap_or_else(|| panic!("docs/program.md has no section on {command}"));
        let help = folder.succeed(&[command, "-h"]);
        let options = help.lines().map(str::trim_start).filter(|line| line.starts_with('-'));
        let flags = options.filter_map(|line| line.split_whitespace().find(|word| word.starts_with("--")));
        // A value that may be left out is told in the same word: `--solid[=<RULE>]`.
        let flags = flags.map(|flag| flag.split('[').next().unwrap_or(flag));
        for flag in flags.filter(|flag| !matches!(*flag, "--help" | "--version")) {
            assert!(section.contains(flag), "docs/program.md does not say what `vitrum {command} {flag}` does");
        }
    }
}

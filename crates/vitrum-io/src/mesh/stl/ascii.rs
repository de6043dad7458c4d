//! STL as text.

use super::Facets;
use crate::error::{Error, Report};
use crate::mesh::words::{Words, number, show};

/// Whether a file's start is text that begins with `solid`.
pub(super) fn is_text(head: &[u8]) -> bool {
    let start = head.trim_ascii_start();
    let is_control = |byte: &u8| byte.is_ascii_control() && !byte.is_ascii_whitespace();
    // Where the head is binary, its count has a byte of 0 if there are fewer than 16 million triangles.
    start.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid")) && !head.iter().any(is_control)
}

pub(super) fn read(bytes: &[u8], facets: &mut Facets) -> Result<(), Error> {
    let report = facets.builder.report;
    let mut words = Words::new(bytes, 0, 1);
    let mut inside = false;
    while let Some(word) = words.next() {
        match word.to_ascii_lowercase().as_slice() {
            // Behind both stands a name of any kind, or nothing.
            b"solid" if !inside => {
                words.skip_line();
                inside = true;
            }
            b"endsolid" if inside => {
                words.skip_line();
                inside = false;
            }
            b"facet" if inside => facet(report, &mut words, facets)?,
            // Zeros pad a file.
            word if !inside && word.iter().all(|&byte| byte == 0) => {}
            _ => {
                let expected = if inside { "`facet` or `endsolid`" } else { "`solid`" };
                return Err(unexpected(report, &words, Some(word), expected));
            }
        }
    }
    if inside { Err(unexpected(report, &words, None, "`facet` or `endsolid`")) } else { Ok(()) }
}

/// The words behind `facet`, up to `endfacet`.
fn facet(report: Report, words: &mut Words, facets: &mut Facets) -> Result<(), Error> {
    expect(report, words, &["normal"])?;
    let normal = vector(report, words, true)?;
    expect(report, words, &["outer", "loop"])?;
    let mut corners = [[0.0; 3]; 3];
    for corner in &mut corners {
        expect(report, words, &["vertex"])?;
        *corner = vector(report, words, false)?;
    }
    expect(report, words, &["endloop", "endfacet"])?;
    facets.add(normal, corners)
}

fn expect(report: Report, words: &mut Words, expected: &[&str]) -> Result<(), Error> {
    for expected in expected {
        match words.next() {
            Some(word) if word.eq_ignore_ascii_case(expected.as_bytes()) => {}
            word => return Err(unexpected(report, words, word, &format!("`{expected}`"))),
        }
    }
    Ok(())
}

/// Three numbers; those of a normal, which is only compared, may be NaN, as some programs write for no area.
fn vector(report: Report, words: &mut Words, normal: bool) -> Result<[f32; 3], Error> {
    let mut vector = [0.0; 3];
    for component in &mut vector {
        let Some(word) = words.next() else {
            return Err(unexpected(report, words, None, "a number"));
        };
        *component = match number(report, words.place(), word) {
            Err(_) if normal && word.to_ascii_lowercase().windows(3).any(|part| part == b"nan") => 0.0,
            other => other?,
        };
    }
    Ok(vector)
}

fn unexpected(report: Report, words: &Words, word: Option<&[u8]>, expected: &str) -> Error {
    match word {
        Some(word) => {
            let problem = format!("`{}` where {expected} was expected", show(word));
            report.invalid(words.place(), problem, "correct the line; each facet is a triangle")
        }
        None => {
            let problem = format!("the file ends where {expected} was expected");
            report.invalid(words.place(), problem, "get the whole file")
        }
    }
}

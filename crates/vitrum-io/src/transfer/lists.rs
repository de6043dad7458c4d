//! Plain lists: a point a line, as numbers apart by white space, commas or semicolons.

use super::Found;
use super::curve::{Colors, Opacities, Point};
use crate::error::{Error, Place, Report, clip};

/// Reads lines of a scalar and an opacity, of a scalar and red, green and blue, or of all five.
pub(super) fn read(report: Report, text: &str) -> Result<Found, Error> {
    const ADVICE: &str = "write a point a line: a scalar and an opacity, a scalar and red, green and blue, or all five";
    let (mut colors, mut opacities) = (Vec::new(), Vec::new());
    let mut headings = 0;
    for (index, line) in text.lines().enumerate() {
        let place = Place::Line(index + 1);
        let line = line.split('#').next().unwrap_or_default();
        let words = line.split(|c: char| c.is_whitespace() || c == ',' || c == ';').filter(|word| !word.is_empty());
        let words: Vec<&str> = words.collect();
        if words.is_empty() {
            continue;
        }
        let numbers: Vec<f64> = words.iter().map_while(|word| word.parse().ok()).collect();
        match numbers.as_slice() {
            // Names of columns may stand in front.
            _ if numbers.len() < words.len() && colors.is_empty() && opacities.is_empty() && headings < 8 => {
                headings += 1;
            }
            _ if numbers.len() < words.len() => {
                let problem = format!("`{}` is no number", clip(words[numbers.len()]));
                return Err(report.invalid(place, problem, ADVICE));
            }
            [x, opacity] => opacities.push(Point::new(*x, [*opacity], place)),
            [x, r, g, b] => colors.push(Point::new(*x, [*r, *g, *b], place)),
            [x, r, g, b, opacity] => {
                colors.push(Point::new(*x, [*r, *g, *b], place));
                opacities.push(Point::new(*x, [*opacity], place));
            }
            other => {
                let problem = format!("{} numbers in a line", other.len());
                return Err(report.invalid(place, problem, ADVICE));
            }
        }
    }
    let mut found = Found { format: "list of numbers", ..Found::default() };
    let most = colors.iter().flat_map(|point: &Point<3>| point.y).fold(0.0, f64::max);
    if most > 1.0 && most <= 255.0 {
        colors.iter_mut().flat_map(|point| &mut point.y).for_each(|value| *value /= 255.0);
        found.assumptions.push("colours are beyond 1: they were taken to go up to 255".to_owned());
    }
    found.colors = Colors { points: colors, ..Colors::default() };
    found.opacities = Opacities { points: opacities };
    Ok(found)
}

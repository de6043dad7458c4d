//! The SVG document as it grows.

use crate::font::{CAPITAL, FAMILY, LINE, measure};
use crate::style::{Style, hex};
use std::fmt::Write;
use vitrum::scene::Paint;

/// The end of a text that stays at its place.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Align {
    Start,
    Middle,
    End,
}

/// A document of a picture's size.
pub struct Canvas {
    size: [f64; 2],
    body: String,
    notes: Vec<String>,
}

/// A number as short as a thousandth of a pixel needs.
pub struct Short(pub f64);

impl std::fmt::Display for Short {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let text = format!("{:.3}", self.0);
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

impl Canvas {
    pub fn new(size: [f64; 2]) -> Self {
        Self { size, body: String::new(), notes: Vec::new() }
    }

    /// The upper left corner of a block of `size` pixels, where its style hangs it, behind it its plate.
    pub fn place(&mut self, style: &Style, size: [f64; 2]) -> [f64; 2] {
        let place = |axis: usize| {
            let room = self.size[axis] - 2.0 * style.margin - size[axis];
            style.margin + style.anchor[axis] * room + style.offset[axis]
        };
        let [x, y] = [place(0), place(1)];
        if let Some(plate) = style.plate {
            let pad = 0.5 * style.size;
            self.rectangle([x - pad, y - pad], [size[0] + 2.0 * pad, size[1] + 2.0 * pad], plate, "plate");
        }
        [x, y]
    }

    /// A filled rectangle.
    pub fn rectangle(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2], paint: Paint, class: &str) {
        let _ = writeln!(
            self.body,
            "<rect class=\"{class}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"{}/>",
            Short(x),
            Short(y),
            Short(width),
            Short(height),
            hex(paint),
            opacity("fill", paint)
        );
    }

    /// A path that is drawn as a line, with an edge around it where the style has one.
    pub fn line(&mut self, path: &str, style: &Style, more: &str) {
        let mut stroke = |paint: Paint, width: f64| {
            let _ = writeln!(
                self.body,
                "<path d=\"{path}\" fill=\"none\" stroke=\"{}\"{} stroke-width=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"{more}/>",
                hex(paint),
                opacity("stroke", paint),
                Short(width)
            );
        };
        if let Some(edge) = style.edge {
            stroke(edge, 2.0 * style.line);
        }
        stroke(style.ink, style.line);
    }

    /// A line of text, whose capitals stand on `y`.
    pub fn text(&mut self, text: &str, [x, y]: [f64; 2], align: Align, style: &Style) {
        self.text_with(text, [x, y], align, style, "");
    }

    /// As [`Self::text`], with further attributes.
    pub fn text_with(&mut self, text: &str, [x, y]: [f64; 2], align: Align, style: &Style, more: &str) {
        if let (_, Some(missing)) = measure(text, 1.0) {
            self.note(format!("the font of annotations has no `{missing}`"));
        }
        let anchor = match align {
            Align::Start => "start",
            Align::Middle => "middle",
            Align::End => "end",
        };
        let edge = style.edge.map_or_else(String::new, |edge| {
            format!(
                " stroke=\"{}\"{} stroke-width=\"{}\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
                hex(edge),
                opacity("stroke", edge),
                Short(0.12 * style.size)
            )
        });
        let _ = writeln!(
            self.body,
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{anchor}\" fill=\"{}\"{}{edge}{more}>{}</text>",
            Short(x),
            Short(y),
            Short(style.size),
            hex(style.ink),
            opacity("fill", style.ink),
            escaped(text)
        );
    }

    /// Elements that are SVG already.
    pub fn raw(&mut self, elements: &str) {
        self.body.push_str(elements);
        self.body.push('\n');
    }

    /// A sentence for the reader of the picture, once.
    pub fn note(&mut self, note: String) {
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }

    /// The document, and the notes.
    pub fn finish(self) -> (String, Vec<String>) {
        let [width, height] = self.size.map(Short);
        let svg = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"{FAMILY}\">\n{}</svg>\n",
            self.body
        );
        (svg, self.notes)
    }
}

/// Width and height of lines of text; of each line the height from capitals' tops to their feet, and lines as far apart as the font has them.
pub fn block(lines: &[&str], size: f64) -> [f64; 2] {
    let width = lines.iter().map(|line| measure(line, size).0).fold(0.0, f64::max);
    let height = if lines.is_empty() { 0.0 } else { CAPITAL * size + (lines.len() - 1) as f64 * LINE * size };
    [width, height]
}

/// The attribute of a paint that lets something through.
fn opacity(what: &str, paint: Paint) -> String {
    if paint.alpha == 255 {
        String::new()
    } else {
        format!(" {what}-opacity=\"{}\"", Short(f64::from(paint.alpha) / 255.0))
    }
}

/// A text as XML has it; control characters, which it cannot have, are blanks.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for letter in text.chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\u{fffe}' | '\u{ffff}' => out.push(' '),
            control if control.is_control() => out.push(' '),
            letter => out.push(letter),
        }
    }
    out
}

/// The shortest text of a number with `digits` significant digits.
pub fn number(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".to_owned();
    }
    let magnitude = libm::floor(libm::log10(value.abs())) as i32;
    if !(-4..7).contains(&magnitude) {
        let text = format!("{value:.*e}", digits.saturating_sub(1));
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let mantissa =
            if mantissa.contains('.') { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa };
        return format!("{mantissa}e{exponent}");
    }
    let decimals = (digits as i32 - 1 - magnitude).max(0) as usize;
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::{Short, escaped, number};

    #[test]
    fn texts_and_numbers_are_as_documents_have_them() {
        assert_eq!(escaped("a < b & c > \u{1}d"), "a &lt; b &amp; c &gt;  d");
        assert_eq!([Short(1.5).to_string(), Short(-0.0001).to_string(), Short(20.0).to_string()], ["1.5", "0", "20"]);
        let shown = [0.5, 100.0, -20.0, 0.1 + 0.2, 2e-9, 5e12, 1234.5678].map(|value| number(value, 4));
        assert_eq!(shown, ["0.5", "100", "−20", "0.3", "2e-9", "5e12", "1235"]);
    }
}

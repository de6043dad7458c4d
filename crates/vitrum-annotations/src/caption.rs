//! A caption: lines of text.

use crate::canvas::{Align, Canvas, block};
use crate::font::{CAPITAL, LINE};
use crate::style::Style;
use vitrum::scene::Annotation;

pub fn add(annotation: &Annotation, style: &Style, canvas: &mut Canvas) {
    // In a setting without quotes the two letters stand for the end of a line.
    let text = annotation.text.as_deref().unwrap_or_default().replace("\\n", "\n");
    let lines: Vec<&str> = text.lines().collect();
    let [width, height] = block(&lines, style.size);
    let [x, y] = canvas.place(style, [width, height]);
    // Lines lean to the side that the caption hangs on.
    let align = match style.anchor[0] {
        0.0 => Align::Start,
        1.0 => Align::End,
        _ => Align::Middle,
    };
    for (index, line) in lines.into_iter().enumerate() {
        let foot = y + CAPITAL * style.size + index as f64 * LINE * style.size;
        canvas.text(line, [x + style.anchor[0] * width, foot], align, style);
    }
}

//! The scale bar.

use crate::canvas::{Align, Canvas, block};
use crate::font::CAPITAL;
use crate::style::Style;
use crate::{Job, unit};
use vitrum::scene::Annotation;

/// The most that a bar of a chosen length takes, over the picture's width.
const SHARE: f64 = 0.25;

/// The longest of 1, 2 and 5 times a power of ten that is at most `most`.
#[must_use]
pub fn round_length(most: f64) -> f64 {
    let exponent = libm::floor(libm::log10(most));
    // A logarithm may miss a whole number by a bit.
    let lengths = [exponent - 1.0, exponent, exponent + 1.0]
        .into_iter()
        .flat_map(|exponent| [1.0, 2.0, 5.0].map(|digit| digit * libm::pow(10.0, exponent)));
    lengths.filter(|length| *length <= most * (1.0 + 1e-12)).fold(0.0, f64::max)
}

pub fn add(job: &Job<'_>, annotation: &Annotation, style: &Style, canvas: &mut Canvas) {
    let pixel = job.view.pixel_size(job.scene.film.height, job.view.target_depth);
    let length = annotation.length.map_or_else(|| round_length(SHARE * job.size[0] * pixel), f64::from);
    let pixels = length / pixel;
    let own = job.subject.volume().and_then(unit::of);
    let text = unit::told(length, annotation.unit.as_deref().or(own));
    if !job.view.orthographic {
        canvas.note(format!(
            "the scale bar of {text} holds at the depth of the camera's target alone, as the projection is perspective; with \
             camera.projection=orthographic it holds everywhere"
        ));
    }
    if own.is_none() && annotation.unit.is_none() {
        canvas.note(
            "the data name no unit of length, and the scale bar has none; annotation.N.unit gives it one".to_owned(),
        );
    }
    if pixels > job.size[0] {
        canvas
            .note(format!("the scale bar of {text} is {pixels:.0} pixels long, and the picture {} wide", job.size[0]));
    }
    let shown = annotation.text.as_deref().unwrap_or(&text);
    let [letters, height] = block(&[shown], style.size);
    let thick = (2.0 * style.line).round().max(1.0);
    let gap = 0.4 * style.size;
    let [x, y] = canvas.place(style, [letters.max(pixels), height + gap + thick]);
    let middle = x + 0.5 * letters.max(pixels);
    canvas.text(shown, [middle, y + CAPITAL * style.size], Align::Middle, style);
    // On whole pixels, so that only the bar's right end may share one.
    let corner = [(middle - 0.5 * pixels).round(), (y + height + gap).round()];
    if let Some(edge) = style.edge {
        let wide = 0.06 * style.size;
        canvas.rectangle(corner.map(|at| at - wide), [pixels + 2.0 * wide, thick + 2.0 * wide], edge, "edge");
    }
    canvas.rectangle(corner, [pixels, thick], style.ink, "scale-bar");
}

#[cfg(test)]
mod tests {
    use super::round_length;

    #[test]
    fn lengths_are_round_and_the_longest_that_fit() {
        for (most, length) in [(1.0, 1.0), (0.99, 0.5), (4.99, 2.0), (99.9, 50.0), (1000.0, 1000.0), (3e-9, 2e-9)] {
            assert!((round_length(most) / length - 1.0).abs() < 1e-9, "{most}: {}", round_length(most));
        }
    }
}

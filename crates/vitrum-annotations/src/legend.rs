//! A legend: the colours and the opacity of the transfer function over the scalar.

use crate::canvas::{Align, Canvas, Short, block, number};
use crate::font::{CAPITAL, measure};
use crate::scale_bar::round_length;
use crate::style::{Style, hex};
use crate::{Job, Refusal};
use std::fmt::Write;
use vitrum::io::linear_to_srgb;
use vitrum::scene::{Annotation, ColorPoint, OpacityPoint, Paint};

/// Height of a legend without one of its own, in percent of the picture's height.
const USUAL: f32 = 40.0;

/// Colours along the bar.
const STOPS: u32 = 128;

/// The value of a piecewise linear function, constant beyond its ends; `one` where it has no points.
fn at<P, const N: usize>(points: &[P], value: f64, read: impl Fn(&P) -> (f32, [f32; N])) -> [f64; N] {
    let read = |point: &P| {
        let (at, values) = read(point);
        (f64::from(at), values.map(f64::from))
    };
    let after = points.iter().position(|point| read(point).0 > value);
    match (after, points) {
        (_, []) => [1.0; N],
        (Some(0), [first, ..]) => read(first).1,
        (None, [.., last]) => read(last).1,
        (Some(after), points) => {
            let ((low, from), (high, to)) = (read(&points[after - 1]), read(&points[after]));
            let share = (value - low) / (high - low);
            std::array::from_fn(|channel| from[channel] + share * (to[channel] - from[channel]))
        }
    }
}

/// A colour of the screen.
fn paint(linear: [f64; 3]) -> Paint {
    let code = |value: f64| (linear_to_srgb(value as f32).clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
    Paint { rgb: linear.map(code), alpha: 255 }
}

pub fn add(job: &Job<'_>, annotation: &Annotation, style: &Style, canvas: &mut Canvas) -> Result<(), Refusal> {
    let Some(volume) = job.subject.volume() else {
        let advice = "leave the annotation out, or show a volume";
        return Err(("a mesh has no transfer function, and a legend shows one".to_owned(), advice.to_owned()));
    };
    let transfer = &job.scene.transfer;
    let colors: &[ColorPoint] = if transfer.color.is_empty() { &transfer.filter } else { &transfer.color };
    let values = colors.iter().map(|point| point.value).chain(transfer.opacity.iter().map(|point| point.value));
    let ends = values.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)]);
    let [low, high] = if ends[0] < ends[1] {
        // Points may stand far beyond what the data has.
        let [low, high] = [ends[0].max(volume.range[0]), ends[1].min(volume.range[1])];
        if low < high { [low, high] } else { ends }
    } else {
        volume.common_range()
    };
    let [low, high] = if low < high { [low, high] } else { [low - 0.5, low + 0.5] }.map(f64::from);
    let value = |share: f64| low + share * (high - low);

    let height = f64::from(annotation.extent.unwrap_or(USUAL)) * 0.01 * job.size[1];
    let width = 1.3 * style.size;
    let gap = 0.4 * style.size;
    let step = round_length((high - low) * (3.0 * style.size / height).max(0.16));
    let first = (low / step - 1e-9).ceil();
    let ticks: Vec<f64> =
        (0..64).map(|index| (first + f64::from(index)) * step).take_while(|tick| *tick <= high + 1e-9 * step).collect();
    let labels: Vec<String> = ticks.iter().map(|tick| number(*tick, 6)).collect();
    let letters = labels.iter().map(|label| measure(label, style.size).0).fold(0.0, f64::max);
    let heading: Vec<&str> = annotation.text.as_deref().unwrap_or_default().lines().collect();
    let [heading_width, heading_height] = block(&heading, style.size);
    let above = if heading.is_empty() { 0.0 } else { heading_height + style.size };
    let size = [(width + 2.0 * gap + letters).max(heading_width), above + height];
    let [x, y] = canvas.place(style, size);
    for (index, line) in heading.iter().enumerate() {
        let foot = y + CAPITAL * style.size + index as f64 * crate::font::LINE * style.size;
        canvas.text(line, [x, foot], Align::Start, style);
    }
    let top = y + above;
    bar(colors, [x, top, width, height], style, canvas, value);
    curve(&transfer.opacity, [x, top, width, height], style, canvas, value);
    for (tick, label) in ticks.into_iter().zip(labels) {
        let at = top + height * (1.0 - (tick - low) / (high - low));
        canvas.line(&format!("M{} {at:.3}h{}", Short(x + width), Short(gap)), style, "");
        canvas.text(&label, [x + width + 2.0 * gap, at + 0.5 * CAPITAL * style.size], Align::Start, style);
    }
    Ok(())
}

/// The bar of colours, the greatest value on top.
fn bar(
    colors: &[ColorPoint],
    [x, y, width, height]: [f64; 4],
    style: &Style,
    canvas: &mut Canvas,
    value: impl Fn(f64) -> f64,
) {
    let mut stops = String::new();
    for index in 0..=STOPS {
        let share = f64::from(index) / f64::from(STOPS);
        let color = paint(at(colors, value(1.0 - share), |point| (point.value, point.color)));
        let _ = write!(stops, "<stop offset=\"{}\" stop-color=\"{}\"/>", Short(share), hex(color));
    }
    let name = format!("legend-{}-{}", x.round(), y.round());
    let ink = hex(style.ink);
    let [left, upper, wide, high, line] = [x, y, width, height, style.line].map(Short);
    canvas.raw(&format!(
        "<linearGradient id=\"{name}\" x1=\"0\" y1=\"0\" x2=\"0\" y2=\"1\">{stops}</linearGradient>\n\
         <rect class=\"legend\" x=\"{left}\" y=\"{upper}\" width=\"{wide}\" height=\"{high}\" fill=\"url(#{name})\" stroke=\"{ink}\" stroke-width=\"{line}\"/>"
    ));
}

/// The opacity, from the bar's left edge, clear, to its right edge, the greatest.
fn curve(
    points: &[OpacityPoint],
    [x, y, width, height]: [f64; 4],
    style: &Style,
    canvas: &mut Canvas,
    value: impl Fn(f64) -> f64,
) {
    let most = f64::from(points.iter().map(|point| point.opacity).fold(0.0, f32::max));
    if most <= 0.0 {
        return;
    }
    let mut path = String::new();
    for index in 0..=STOPS {
        let share = f64::from(index) / f64::from(STOPS);
        let [opacity] = at(points, value(1.0 - share), |point| (point.value, [point.opacity]));
        let letter = if index == 0 { 'M' } else { 'L' };
        let _ = write!(path, "{letter}{} {}", Short(x + width * opacity / most), Short(y + height * share));
    }
    // It lies on any colour.
    let white = Paint { rgb: [255; 3], alpha: 255 };
    let drawn = Style { ink: Paint { rgb: [0; 3], alpha: 255 }, edge: Some(white), ..*style };
    canvas.line(&path, &drawn, " class=\"opacity\"");
}

#[cfg(test)]
mod tests {
    use super::at;

    #[test]
    fn functions_are_linear_between_points_and_constant_beyond() {
        let points = [(0.0, [0.0]), (1.0, [1.0]), (1.0, [3.0]), (2.0, [4.0])];
        let seen = |value| at(&points, value, |point| *point)[0];
        assert_eq!([seen(-1.0), seen(0.25), seen(1.5), seen(9.0)], [0.0, 0.25, 3.5, 4.0]);
        assert_eq!(at(&[] as &[(f32, [f32; 1])], 0.0, |point| *point), [1.0]);
    }
}

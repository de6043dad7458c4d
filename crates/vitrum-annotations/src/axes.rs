//! The directions of the world's axes.

use crate::Job;
use crate::canvas::{Align, Canvas, Short};
use crate::font::CAPITAL;
use crate::style::Style;
use glam::DVec3;
use vitrum::scene::{Annotation, Paint};

/// The axes' colours, as other programs have them.
const COLORS: [[u8; 3]; 3] = [[214, 39, 40], [44, 160, 44], [31, 119, 180]];

/// Length of axes without one of their own, in percent of the picture's height.
pub const USUAL: f32 = 9.0;

pub fn add(job: &Job<'_>, annotation: &Annotation, style: &Style, canvas: &mut Canvas) {
    let length = f64::from(annotation.extent.unwrap_or(USUAL)) * 0.01 * job.size[1];
    let reach = length + style.size;
    let [x, y] = canvas.place(style, [2.0 * reach; 2]);
    let middle = [x + reach, y + reach];
    let mut axes =
        [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| job.view.direction(axis)).into_iter().enumerate().collect::<Vec<_>>();
    // The one that points away most goes first.
    axes.sort_by(|(_, one), (_, other)| other.z.total_cmp(&one.z));
    for (axis, direction) in axes {
        let at = |share: f64| [middle[0] + direction.x * length * share, middle[1] - direction.y * length * share];
        let ink = if annotation.color.is_some() { style.ink } else { Paint { rgb: COLORS[axis], alpha: 255 } };
        let colored = Style { ink, line: 1.5 * style.line, ..*style };
        let [tip_x, tip_y] = at(1.0);
        canvas.line(
            &format!("M{} {}L{} {}", Short(middle[0]), Short(middle[1]), Short(tip_x), Short(tip_y)),
            &colored,
            "",
        );
        let flat = libm::hypot(direction.x, direction.y);
        if flat > 0.15 {
            canvas.line(&head([direction.x / flat, direction.y / flat], [tip_x, tip_y], 0.18 * length), &colored, "");
        }
        let beyond = 1.0 + 0.7 * style.size / length;
        let [text_x, text_y] = at(beyond);
        canvas.text(["x", "y", "z"][axis], [text_x, text_y + 0.5 * CAPITAL * style.size], Align::Middle, &colored);
    }
}

/// The two barbs of an arrow with its tip at `tip`.
fn head([x, y]: [f64; 2], tip: [f64; 2], length: f64) -> String {
    let barb = |side: f64| {
        let [back, across] = [0.9 * length, 0.45 * length * side];
        [tip[0] - x * back - y * across, tip[1] + y * back - x * across].map(Short)
    };
    let ([ax, ay], [bx, by]) = (barb(1.0), barb(-1.0));
    format!("M{ax} {ay}L{} {}L{bx} {by}", Short(tip[0]), Short(tip[1]))
}

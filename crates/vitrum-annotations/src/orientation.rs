//! Marks of orientation: letters at the picture's edges, or a cube.

use crate::Job;
use crate::axes::USUAL;
use crate::canvas::{Align, Canvas, Short};
use crate::font::CAPITAL;
use crate::style::{Style, hex};
use glam::DVec3;
use std::fmt::Write;
use vitrum::io::Orientation;
use vitrum::scene::{Annotation, Paint};

/// Names of the world's directions +x, −x, +y, −y, +z and −z: those of a patient, or of the axes.
fn names(job: &Job<'_>) -> [&'static str; 6] {
    match job.subject.volume().map(|volume| volume.orientation) {
        Some(Orientation::Patient) => ["R", "L", "A", "P", "S", "I"],
        _ => ["+x", "−x", "+y", "−y", "+z", "−z"],
    }
}

/// The world direction of an index of [`names`].
fn direction(index: usize) -> DVec3 {
    let axis = [DVec3::X, DVec3::Y, DVec3::Z][index / 2];
    if index.is_multiple_of(2) { axis } else { -axis }
}

/// The names of the world's directions that point to a side of the picture, the nearest first: all that are within 70° of it.
fn towards(side: DVec3, names: [&str; 6]) -> String {
    let nearness = |index: &usize| direction(*index).dot(side);
    let mut near: Vec<usize> = (0..6).filter(|index| nearness(index) > 0.342).collect();
    near.sort_by(|one, other| nearness(other).total_cmp(&nearness(one)));
    near.into_iter().map(|index| names[index]).collect()
}

pub fn add_letters(job: &Job<'_>, _annotation: &Annotation, style: &Style, canvas: &mut Canvas) {
    let [right, above] = [job.view.axes.x_axis, job.view.axes.y_axis];
    let names = names(job);
    let [width, height] = job.size;
    let half = 0.5 * CAPITAL * style.size;
    let [dx, dy] = style.offset;
    for (side, [x, y], align) in [
        (right, [width - style.margin, 0.5 * height + half], Align::End),
        (-right, [style.margin, 0.5 * height + half], Align::Start),
        (above, [0.5 * width, style.margin + 2.0 * half], Align::Middle),
        (-above, [0.5 * width, height - style.margin], Align::Middle),
    ] {
        canvas.text(&towards(side, names), [x + dx, y + dy], align, style);
    }
}

/// Edge of the letter on a face, over the cube's.
const LETTER: f64 = 0.55;

pub fn add_cube(job: &Job<'_>, annotation: &Annotation, style: &Style, canvas: &mut Canvas) {
    let edge = f64::from(annotation.extent.unwrap_or(USUAL)) * 0.01 * job.size[1];
    // The longest diagonal turns within this.
    let reach = 0.5 * edge * 3f64.sqrt();
    let [x, y] = canvas.place(style, [2.0 * reach; 2]);
    let middle = [x + reach, y + reach];
    let names = names(job);
    let flat = |world: DVec3| {
        let seen = job.view.direction(world) * (0.5 * edge);
        [seen.x, -seen.y]
    };
    for (index, name) in names.into_iter().enumerate() {
        let normal = direction(index);
        let facing = -job.view.direction(normal).z;
        if facing <= 1e-6 {
            continue;
        }
        // A viewer before the face has the world's up above it; before the upper face the patient's front.
        let above = if normal.z == 0.0 { DVec3::Z } else { DVec3::Y * normal.z.signum() * -1.0 };
        let right = above.cross(normal);
        let corner = |across: f64, up: f64| {
            let [dx, dy] = flat(normal + right * across + above * up);
            format!("{} {}", Short(middle[0] + dx), Short(middle[1] + dy))
        };
        let outline =
            format!("M{}L{}L{}L{}Z", corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0));
        let shade = (110.0 + 130.0 * facing) as u8;
        let face = Paint { rgb: [shade; 3], alpha: 255 };
        canvas.raw(&format!(
            "<path class=\"face\" d=\"{outline}\" fill=\"{}\" stroke=\"#000000\" stroke-width=\"{}\" stroke-linejoin=\"round\"/>",
            hex(face),
            Short(style.line)
        ));
        let ([ax, ay], [bx, by], [cx, cy]) = (flat(right), flat(above * -1.0), flat(normal));
        let half = 0.5 * edge;
        let mut matrix = String::new();
        let _ = write!(
            matrix,
            " transform=\"matrix({:.5} {:.5} {:.5} {:.5} {} {})\"",
            ax / half,
            ay / half,
            bx / half,
            by / half,
            Short(middle[0] + cx),
            Short(middle[1] + cy)
        );
        let size = LETTER * edge * if name.chars().count() > 1 { 0.8 } else { 1.0 };
        let ink = annotation.color.as_ref().map_or(Paint { rgb: [0; 3], alpha: 255 }, |_| style.ink);
        let letter = Style { size, ink, edge: None, ..*style };
        canvas.text_with(name, [0.0, 0.5 * CAPITAL * size], Align::Middle, &letter, &matrix);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_name_all_directions_that_are_near() {
        let patient = ["R", "L", "A", "P", "S", "I"];
        assert_eq!(towards(DVec3::X, patient), "R");
        assert_eq!(towards(-DVec3::Z, patient), "I");
        assert_eq!(towards(DVec3::new(0.8, -0.6, 0.0), patient), "RP");
        assert_eq!(towards(DVec3::new(0.6, 0.8, 0.0), patient), "AR");
        assert_eq!(towards(DVec3::new(0.95, 0.3, 0.0).normalize(), patient), "R");
    }
}

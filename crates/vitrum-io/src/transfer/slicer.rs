//! 3D Slicer's volume properties as text: `.vp` files, and the attributes of MRML that have the same form.
//!
//! The format: <https://slicer.readthedocs.io/en/latest/developer_guide/modules/volumerendering.html>.

use super::Found;
use super::curve::{Colors, Opacities, Point};
use crate::error::{Error, Place, Report, clip};
use crate::source::Assumptions;

/// What is left out of a volume property.
pub(super) const LEFT_OUT: &str = "left out: shading and interpolation, for which a scene has keys of its own";

/// Reads a `.vp` file: six numbers, then opacities, opacities of gradients, and colours, a line each.
pub(super) fn read(report: Report, text: &str) -> Result<Found, Error> {
    let lines = text.lines().enumerate().map(|(index, line)| (Place::Line(index + 1), line.trim()));
    let lines: Vec<_> = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#')).collect();
    let mut found = Found { format: "3D Slicer volume property", ..Found::default() };
    let [_, _, _, _, _, _, opacity, gradient, color, ..] = lines.as_slice() else {
        let problem = format!("{} lines, and a volume property has 9", lines.len());
        let advice = "save the volume property by 3D Slicer: six numbers, then opacities, opacities of gradients and colours, a line each";
        return Err(report.invalid(Place::File, problem, advice));
    };
    found.opacities = opacities(report, opacity.0, opacity.1)?;
    found.gradients = gradients(report, gradient.0, gradient.1, &mut found.assumptions);
    found.colors = colors(report, color.0, color.1)?;
    found.assumptions.push(LEFT_OUT.to_owned());
    Ok(found)
}

/// Factors of opacity at magnitudes of the gradient, written as opacities are; none where they are no such list, which is told.
pub(super) fn gradients(report: Report, place: Place, text: &str, assumptions: &mut Assumptions) -> Opacities {
    opacities(report, place, text).unwrap_or_else(|_| {
        assumptions.push("left out: the opacity by gradients, which is no list of numbers".to_owned());
        Opacities::default()
    })
}

/// A count of numbers, then pairs of a scalar and an opacity.
pub(super) fn opacities(report: Report, place: Place, text: &str) -> Result<Opacities, Error> {
    let values = numbers(report, place, text, 2, "opacities")?;
    let points = values.chunks_exact(2).map(|point| Point::new(point[0], [point[1]], place)).collect();
    Ok(Opacities { points })
}

/// A count of numbers, then fours of a scalar and red, green and blue.
pub(super) fn colors(report: Report, place: Place, text: &str) -> Result<Colors, Error> {
    let values = numbers(report, place, text, 4, "colours")?;
    let points = values.chunks_exact(4).map(|point| Point::new(point[0], [point[1], point[2], point[3]], place));
    Ok(Colors { points: points.collect(), ..Colors::default() })
}

/// The numbers behind their count, `of` of which make a point.
fn numbers(report: Report, place: Place, text: &str, of: usize, what: &str) -> Result<Vec<f64>, Error> {
    let advice = format!("write the count of the numbers, then {of} for each point");
    let mut values = Vec::new();
    for word in text.split_whitespace() {
        let value = word.parse::<f64>().map_err(|_| {
            report.invalid(place, format!("`{}` among the {what} is no number", clip(word)), advice.clone())
        })?;
        values.push(value);
    }
    let Some((&count, values)) = values.split_first() else {
        return Err(report.invalid(place, format!("there are no {what}"), advice));
    };
    if count != values.len() as f64 || values.len() % of != 0 {
        let problem = format!("{} numbers of {what} behind the count {count}, of {of} each", values.len());
        return Err(report.invalid(place, problem, advice));
    }
    Ok(values.to_vec())
}

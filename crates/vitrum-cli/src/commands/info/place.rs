//! Where a volume lies, in the words of those who look at patients: millimetres, and letters of sides.

use vitrum::io::{Orientation, Volume};

/// The name of the volume's unit of length, where it is known.
pub fn unit_name(volume: &Volume) -> Option<&'static str> {
    let stated = volume.source.assumptions.stated().iter().any(|fact| fact.name == "unit");
    (stated || volume.orientation == Orientation::Patient).then_some("mm")
}

/// The unit as it stands behind numbers.
pub fn unit(volume: &Volume) -> String {
    unit_name(volume).map(|name| format!(" {name}")).unwrap_or_default()
}

/// The sides that each axis of a patient's volume runs between, such as `R→L`.
pub fn letters(volume: &Volume) -> Option<[String; 3]> {
    // World x points to the right, y to anterior, z to superior.
    const SIDES: [[char; 2]; 3] = [['L', 'R'], ['P', 'A'], ['I', 'S']];
    (volume.orientation == Orientation::Patient).then(|| {
        volume.axes.map(|axis| {
            let side = main(axis);
            let [from, to] = SIDES[side];
            if axis[side] < 0.0 { format!("{to}→{from}") } else { format!("{from}→{to}") }
        })
    })
}

/// The directions of the axes: letters of a patient's sides, with the angle where an axis is oblique; else vectors.
pub fn axes(volume: &Volume) -> String {
    const STRAIGHT: f32 = 0.1;
    let letters = letters(volume);
    let axis = |index: usize| {
        let direction = volume.axes[index];
        let vector = || {
            let [x, y, z] = shown(direction);
            format!("({x}, {y}, {z})")
        };
        let name = ["x", "y", "z"][index];
        let Some(letters) = &letters else { return format!("{name} {}", vector()) };
        let angle = libm::acosf(direction[main(direction)].abs().min(1.0)).to_degrees();
        let oblique = if angle > STRAIGHT { format!(", {angle:.1}° oblique") } else { String::new() };
        format!("{name} {}{oblique}", letters[index])
    };
    [0, 1, 2].map(axis).join(if letters.is_some() { "; " } else { ", " })
}

/// The component along which a direction mainly runs.
fn main(direction: [f32; 3]) -> usize {
    (0..3).max_by(|&a, &b| direction[a].abs().total_cmp(&direction[b].abs())).unwrap_or(0)
}

/// The components without what rounding leaves beside the largest of them, and without -0.
pub fn tidy(vector: [f32; 3]) -> [f32; 3] {
    let largest = vector.iter().fold(0.0_f32, |largest, component| largest.max(component.abs()));
    // Of f32, below the last digit of the largest component.
    vector.map(|component| if component.abs() <= 1e-7 * largest { 0.0 } else { component })
}

/// The components as people read them, in six digits.
pub fn shown(vector: [f32; 3]) -> [String; 3] {
    tidy(vector).map(|component| format!("{:.6}", super::digits::Digits(f64::from(component))))
}

#[cfg(test)]
mod tests {
    use super::{shown, tidy};

    #[test]
    fn rounding_leaves_no_trace() {
        assert_eq!(tidy([1.0, -0.0, -6.24e-29]).map(f32::to_bits), [1.0_f32, 0.0, 0.0].map(f32::to_bits));
        assert_eq!(shown([0.488_281_25, 2.999_999_8, -0.0]), ["0.488281", "3", "0"]);
        assert_eq!(tidy([1e-9, 2e-9, 3e-9]), [1e-9, 2e-9, 3e-9], "small volumes have small places");
    }
}

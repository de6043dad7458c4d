//! The spaces in which colours are interpolated between the points of a map.

use std::f64::consts::PI;

use crate::image::srgb_to_linear;

/// A space in which colours are interpolated. Colours themselves are always sRGB code values from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ColorSpace {
    /// Red, green and blue each by itself.
    #[default]
    Rgb,
    /// Hue, saturation and value; hues go the shorter way round.
    Hsv,
    /// CIE L*a*b*.
    Lab,
    /// Moreland's diverging maps: by way of an unsaturated colour between two saturated ones of different hues.
    Diverging,
    /// The colour of the point before.
    Step,
}

impl ColorSpace {
    /// The space of a name as files have it.
    pub(super) fn named(name: &str) -> Option<Self> {
        Some(match name.trim().to_ascii_lowercase().as_str() {
            "rgb" | "0" => Self::Rgb,
            "hsv" | "1" => Self::Hsv,
            "lab" | "cielab" | "2" | "lab/ciede2000" | "4" | "labciede2000" => Self::Lab,
            "diverging" | "3" => Self::Diverging,
            "step" | "5" => Self::Step,
            _ => return None,
        })
    }
}

/// The colour at a share `t` of the way from one to another, in sRGB code values.
#[must_use]
pub fn color_at(space: ColorSpace, from: [f64; 3], to: [f64; 3], t: f64) -> [f64; 3] {
    let mix = |from: [f64; 3], to: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| from[i] + (to[i] - from[i]) * t) };
    let mixed = match space {
        ColorSpace::Rgb => mix(from, to),
        ColorSpace::Step => {
            if t < 1.0 {
                from
            } else {
                to
            }
        }
        ColorSpace::Lab => lab_to_rgb(mix(rgb_to_lab(from), rgb_to_lab(to))),
        ColorSpace::Hsv => {
            let (mut from, mut to) = (rgb_to_hsv(from), rgb_to_hsv(to));
            if (to[0] - from[0]).abs() > 0.5 {
                let lower = if to[0] > from[0] { &mut from } else { &mut to };
                lower[0] += 1.0;
            }
            hsv_to_rgb(mix(from, to))
        }
        ColorSpace::Diverging => diverging(from, to, t),
    };
    mixed.map(|value| value.clamp(0.0, 1.0))
}

/// Linear RGB of sRGB code values.
pub(super) fn linear(code: [f64; 3]) -> [f32; 3] {
    code.map(|value| srgb_to_linear(value as f32).clamp(0.0, 1.0))
}

/// Moreland, Diverging color maps for scientific visualization (2009): in polar coordinates of L*a*b*, magnitude, saturation and hue.
fn diverging(from: [f64; 3], to: [f64; 3], t: f64) -> [f64; 3] {
    const SATURATED: f64 = 0.05;
    let (mut from, mut to, mut t) = (polar(rgb_to_lab(from)), polar(rgb_to_lab(to)), t);
    let between = {
        let difference = (from[2] - to[2]).abs();
        difference.min(2.0 * PI - difference)
    };
    if from[1] > SATURATED && to[1] > SATURATED && between > 0.33 * PI {
        let middle = [from[0].max(to[0]).max(88.0), 0.0, 0.0];
        if t < 0.5 {
            to = middle;
            t *= 2.0;
        } else {
            from = middle;
            t = 2.0 * t - 1.0;
        }
    }
    if from[1] < SATURATED && to[1] > SATURATED {
        from[2] = adjusted_hue(to, from[0]);
    } else if to[1] < SATURATED && from[1] > SATURATED {
        to[2] = adjusted_hue(from, to[0]);
    }
    let mixed: [f64; 3] = std::array::from_fn(|i| from[i] + (to[i] - from[i]) * t);
    let [magnitude, saturation, hue] = mixed;
    let across = magnitude * libm::sin(saturation);
    lab_to_rgb([magnitude * libm::cos(saturation), across * libm::cos(hue), across * libm::sin(hue)])
}

/// The hue that an unsaturated end of the magnitude `unsaturated` takes opposite of a saturated one.
fn adjusted_hue([magnitude, saturation, hue]: [f64; 3], unsaturated: f64) -> f64 {
    if magnitude >= unsaturated - 0.1 {
        return hue;
    }
    let rise = libm::sqrt(unsaturated * unsaturated - magnitude * magnitude);
    let spin = saturation * rise / (magnitude * libm::sin(saturation));
    if hue > -0.3 * PI { hue + spin } else { hue - spin }
}

fn polar([l, a, b]: [f64; 3]) -> [f64; 3] {
    let magnitude = libm::sqrt(l * l + a * a + b * b);
    let saturation = if magnitude > 0.001 { libm::acos((l / magnitude).clamp(-1.0, 1.0)) } else { 0.0 };
    let hue = if saturation > 0.001 { libm::atan2(b, a) } else { 0.0 };
    [magnitude, saturation, hue]
}

/// The white of D65.
const WHITE: [f64; 3] = [0.9505, 1.0, 1.089];

fn rgb_to_lab(rgb: [f64; 3]) -> [f64; 3] {
    let light = |code: f64| {
        if code > 0.04045 { libm::pow((code + 0.055) / 1.055, 2.4) } else { code / 12.92 }
    };
    let [r, g, b] = rgb.map(light);
    let xyz = [
        0.4124 * r + 0.3576 * g + 0.1805 * b,
        0.2126 * r + 0.7152 * g + 0.0722 * b,
        0.0193 * r + 0.1192 * g + 0.9505 * b,
    ];
    let curve = |value: f64| if value > 0.008856 { libm::cbrt(value) } else { 7.787 * value + 16.0 / 116.0 };
    let [x, y, z] = [0, 1, 2].map(|i| curve(xyz[i] / WHITE[i]));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn lab_to_rgb([l, a, b]: [f64; 3]) -> [f64; 3] {
    let y = (l + 16.0) / 116.0;
    let curve = |value: f64| {
        let cube = value * value * value;
        if cube > 0.008856 { cube } else { (value - 16.0 / 116.0) / 7.787 }
    };
    let [x, y, z] = [a / 500.0 + y, y, y - b / 200.0].map(curve);
    let [x, y, z] = [x * WHITE[0], y * WHITE[1], z * WHITE[2]];
    let light = [
        3.2406 * x - 1.5372 * y - 0.4986 * z,
        -0.9689 * x + 1.8758 * y + 0.0415 * z,
        0.0557 * x - 0.2040 * y + 1.0570 * z,
    ];
    light.map(|value| if value > 0.0031308 { 1.055 * libm::pow(value, 1.0 / 2.4) - 0.055 } else { 12.92 * value })
}

fn rgb_to_hsv([r, g, b]: [f64; 3]) -> [f64; 3] {
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let chroma = most - least;
    if chroma <= 0.0 {
        return [0.0, 0.0, most];
    }
    let sixth = if most == r {
        (g - b) / chroma
    } else if most == g {
        2.0 + (b - r) / chroma
    } else {
        4.0 + (r - g) / chroma
    };
    let hue = sixth / 6.0;
    [if hue < 0.0 { hue + 1.0 } else { hue }, chroma / most, most]
}

fn hsv_to_rgb([hue, saturation, value]: [f64; 3]) -> [f64; 3] {
    let hue = hue - hue.floor();
    [5.0, 3.0, 1.0].map(|offset| {
        let k = (offset + hue * 6.0) % 6.0;
        value - value * saturation * k.min(4.0 - k).clamp(0.0, 1.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: [f64; 3], b: [f64; 3], within: f64) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= within)
    }

    #[test]
    fn spaces_meet_their_ends_and_come_back() {
        let colors = [[0.2, 0.4, 0.9], [0.9, 0.1, 0.1], [0.0; 3], [1.0; 3], [0.5, 0.5, 0.5]];
        for space in [ColorSpace::Rgb, ColorSpace::Hsv, ColorSpace::Lab, ColorSpace::Diverging, ColorSpace::Step] {
            for (from, to) in colors.iter().flat_map(|from| colors.iter().map(move |to| (*from, *to))) {
                // The matrices of sRGB are given to four digits.
                assert!(close(color_at(space, from, to, 0.0), from, 2e-3), "{space:?} {from:?} {to:?}");
                assert!(close(color_at(space, from, to, 1.0), to, 2e-3), "{space:?} {from:?} {to:?}");
            }
        }
    }

    #[test]
    fn the_middle_of_cool_to_warm_is_the_gray_that_paraview_has() {
        let [cool, warm] = [[0.231373, 0.298039, 0.752941], [0.705882, 0.0156863, 0.14902]];
        // What ParaView writes into its map as the point in the middle.
        assert!(close(color_at(ColorSpace::Diverging, cool, warm, 0.5), [0.865, 0.865, 0.865], 4e-3));
    }

    #[test]
    fn hues_go_the_shorter_way_round() {
        let magenta = color_at(ColorSpace::Hsv, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 0.5);
        assert!(close(magenta, [1.0, 0.0, 1.0], 1e-12), "{magenta:?}");
    }
}

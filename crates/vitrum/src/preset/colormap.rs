//! Maps of colours by name, as plots have them.

use crate::scene::{ColorPoint, Rgb};
use vitrum_io::transfer::{ColorSpace, color_at};
use vitrum_io::{linear_to_srgb, srgb_to_linear};

/// The names of all maps, and what they look like.
const NAMES: [(&str, &str); 9] = [
    ("viridis", "a map of colours: violet, green, yellow; as bright as the value is high"),
    ("magma", "a map of colours: black, violet, orange, pale yellow"),
    ("inferno", "a map of colours: black, violet, orange, yellow"),
    ("plasma", "a map of colours: blue, violet, orange, yellow"),
    ("cividis", "a map of colours: blue to yellow, alike with and without red-green blindness"),
    ("gray", "a map of colours: black to white"),
    ("bone", "a map of colours: black to white by way of a bluish gray"),
    ("hot", "a map of colours: black, red, yellow, white"),
    ("cool-to-warm", "a map of colours: blue to red by way of a light gray, for values around a middle"),
];

/// Samples of a map: those of the tables that colour maps are published as.
const SAMPLES: u16 = 256;

/// Names and looks of all maps of colours.
#[must_use]
pub fn names() -> &'static [(&'static str, &'static str)] {
    &NAMES
}

/// The points of a map over a range; `None` where there is no map of the name.
pub(super) fn points(name: &str, [low, high]: [f32; 2]) -> Option<Vec<ColorPoint>> {
    let map = map(name)?;
    let last = SAMPLES - 1;
    let sample = |index: u16| {
        let share = f32::from(index) / f32::from(last);
        (share, map(f64::from(share)).map(|code| code as f32))
    };
    let samples: Vec<(f32, Rgb)> = (0..=last).map(sample).collect();
    let mut kept = vec![0];
    while let Some(&start) = kept.last().filter(|&&index| index + 1 < samples.len()) {
        let end = (start + 2..samples.len()).take_while(|&end| is_line(&samples[start..=end])).last();
        kept.push(end.unwrap_or(start + 1));
    }
    let point = |index: usize| {
        let (share, codes) = samples[index];
        ColorPoint { value: low + (high - low) * share, color: codes.map(srgb_to_linear) }
    };
    Some(kept.into_iter().map(point).collect())
}

/// A code of 8 bits, and what rounding may add: the tables are rounded.
const TOLERANCE: f32 = 1.2 / 255.0;

/// Whether a line of linear light between the ends of samples, whose colours are those of a screen, shows all of them.
fn is_line(samples: &[(f32, Rgb)]) -> bool {
    let [(low, from), .., (high, to)] = samples else { return true };
    let shows = |&(share, codes): &(f32, Rgb)| {
        let t = (share - low) / (high - low);
        (0..3).all(|channel| {
            let (a, b) = (srgb_to_linear(from[channel]), srgb_to_linear(to[channel]));
            (linear_to_srgb(a + (b - a) * t) - codes[channel]).abs() <= TOLERANCE
        })
    };
    samples.iter().all(shows)
}

type Map = fn(f64) -> [f64; 3];

fn map(name: &str) -> Option<Map> {
    Some(match name {
        "viridis" => |t| published(&colorous::VIRIDIS, t),
        "magma" => |t| published(&colorous::MAGMA, t),
        "inferno" => |t| published(&colorous::INFERNO, t),
        "plasma" => |t| published(&colorous::PLASMA, t),
        "cividis" => |t| published(&colorous::CIVIDIS, t),
        "gray" => |t| [t; 3],
        "bone" => bone,
        "hot" => hot,
        "cool-to-warm" => cool_to_warm,
        _ => return None,
    })
}

fn published(gradient: &colorous::Gradient, t: f64) -> [f64; 3] {
    let colorous::Color { r, g, b } = gradient.eval_continuous(t);
    [r, g, b].map(|code| f64::from(code) / 255.0)
}

/// A black body as MATLAB has it: red rises first, then green, then blue.
fn hot(t: f64) -> [f64; 3] {
    let rise = |start: f64, end: f64| ((t - start) / (end - start)).clamp(0.0, 1.0);
    [rise(0.0, 0.375), rise(0.375, 0.75), rise(0.75, 1.0)]
}

/// MATLAB's: seven parts of gray and one of `hot` with red and blue exchanged.
fn bone(t: f64) -> [f64; 3] {
    let [r, g, b] = hot(t);
    [b, g, r].map(|heat| (7.0 * t + heat) / 8.0)
}

/// Moreland's, with ParaView's ends.
fn cool_to_warm(t: f64) -> [f64; 3] {
    let [cool, warm] = [[0.231373, 0.298039, 0.752941], [0.705882, 0.0156863, 0.14902]];
    color_at(ColorSpace::Diverging, cool, warm, t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_io::linear_to_srgb;

    fn codes(name: &str, share: f32) -> [u8; 3] {
        let points = points(name, [0.0, 1.0]).expect("a listed map");
        let after = points.partition_point(|point| point.value < share).clamp(1, points.len() - 1);
        let (a, b) = (points[after - 1], points[after]);
        let t = (share - a.value) / (b.value - a.value);
        std::array::from_fn(|i| (linear_to_srgb(a.color[i] + (b.color[i] - a.color[i]) * t) * 255.0 + 0.5) as u8)
    }

    #[test]
    fn maps_have_their_published_colours() {
        // Of matplotlib 3.9: `matplotlib.colormaps[name](share, bytes=True)`; cool-to-warm of ParaView's table. The ends and the middle.
        let known: [(&str, [[u8; 3]; 3]); 6] = [
            ("viridis", [[68, 1, 84], [33, 145, 140], [253, 231, 37]]),
            ("magma", [[0, 0, 4], [183, 55, 121], [252, 253, 191]]),
            ("inferno", [[0, 0, 4], [188, 55, 84], [252, 255, 164]]),
            ("plasma", [[13, 8, 135], [204, 71, 120], [240, 249, 33]]),
            ("gray", [[0, 0, 0], [128, 128, 128], [255, 255, 255]]),
            ("cool-to-warm", [[59, 76, 192], [221, 221, 221], [180, 4, 38]]),
        ];
        for (name, colors) in known {
            for (share, color) in [0.0, 0.5, 1.0].into_iter().zip(colors) {
                let made = codes(name, share);
                // Interpolated tables differ by a few codes from matplotlib's nearest entry.
                let off = made.iter().zip(color).map(|(a, b)| a.abs_diff(b)).max();
                assert!(off <= Some(3), "{name} at {share}: {made:?}, expected {color:?}");
            }
        }
    }

    #[test]
    fn every_map_has_few_points_over_its_range() {
        for (name, _) in names() {
            let points = points(name, [-1000.0, 3000.0]).expect("a listed map");
            assert_eq!((points[0].value, points[points.len() - 1].value), (-1000.0, 3000.0));
            assert!(points.len() <= 64, "{name}: {}", points.len());
            assert!(points.is_sorted_by(|a, b| a.value < b.value));
        }
        assert!(points("jet", [0.0, 1.0]).is_none());
    }
}

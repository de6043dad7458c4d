//! The ground as a catcher of shadows: it is taken out of the picture, and its shadows and caustics stay.

use super::frame::Frame;

/// The values of a channel of `color`, or none.
fn channel<'a>(frame: &'a Frame, layer: &str, name: &str) -> &'a [f32] {
    frame.channel(layer, name).unwrap_or_default()
}

/// A mean of the radiance of the ground where it is seen, for rays that come to it by other ways than straight.
fn mean(radiance: &[f32], coverage: &[f32]) -> f32 {
    let seen = radiance.iter().zip(coverage).filter(|(_, coverage)| **coverage > 0.5);
    let (sum, count) = seen.fold((0.0_f64, 0_u32), |(sum, count), (value, _)| (sum + f64::from(*value), count + 1));
    if count > 0 { (sum / f64::from(count)) as f32 } else { 0.0 }
}

impl Frame {
    /// The picture without its ground. `self` has it; `bare` is the same picture without it, and `empty` shows the ground alone, with nothing that
    /// casts shadows; all of them without an environment behind.
    ///
    /// Where the ground takes the share `g` of a pixel, and is `s` times as bright as it would be alone, the pixel lets `g · s` of what is behind through, and what
    /// the ground has more than that, in some colour or all of them, is added as light. In front of a page as bright as the ground alone, it looks as it did with
    /// the ground.
    pub(crate) fn catch_shadows(mut self, bare: &Self, empty: &Self) -> Self {
        const NAMES: [&str; 3] = ["R", "G", "B"];
        let whole = NAMES.map(|name| channel(&self, "color", name).to_vec());
        let coverage = channel(&self, "color", "A").to_vec();
        let without = NAMES.map(|name| channel(bare, "color", name));
        let covered = channel(bare, "color", "A");
        let alone = NAMES.map(|name| channel(empty, "color", name));
        let there = channel(empty, "color", "A");
        let usual = alone.map(|plane| mean(plane, there));
        let tints = NAMES.map(|name| channel(bare, "transmittance", name));
        let pixels = coverage.len();
        if [&without[0], &covered, &alone[0], &there].iter().any(|plane| plane.len() != pixels) {
            return self;
        }
        let mut caught = [vec![0.0; pixels], vec![0.0; pixels], vec![0.0; pixels], vec![0.0; pixels]];
        let depths = [bare, empty].map(|frame| channel(frame, "depth", "Z"));
        for pixel in 0..pixels {
            let [subject, ground] = depths.map(|plane| plane.get(pixel).copied().unwrap_or(0.0));
            // Where the ground hides the subject, there is nothing else.
            let hidden = ground > 0.0 && ground < subject;
            let covered = if hidden { 0.0 } else { covered[pixel] };
            let without = without.map(|plane| if hidden { 0.0 } else { plane[pixel] });
            let tints = tints.map(|plane| plane.get(pixel).copied().filter(|_| !hidden).unwrap_or(1.0));
            let share = (coverage[pixel] - covered).max(0.0);
            let sum: f32 = tints.iter().sum();
            let expected: [f32; 3] = std::array::from_fn(|index| {
                let tint = if sum > 0.0 { 3.0 * tints[index] / sum } else { 1.0 };
                let radiance = if there[pixel] > 0.5 { alone[index][pixel] } else { usual[index] };
                share * tint * radiance
            });
            let seen: [f32; 3] = std::array::from_fn(|index| (whole[index][pixel] - without[index]).max(0.0));
            let lit = seen.iter().zip(expected).filter(|(_, expected)| *expected > 0.0);
            let lit = lit.map(|(seen, expected)| seen / expected).fold(1.0_f32, f32::min);
            for index in 0..3 {
                caught[index][pixel] = without[index] + (seen[index] - lit * expected[index]).max(0.0);
            }
            caught[3][pixel] = coverage[pixel] - share * lit;
        }
        if let Some(color) = self.layers.iter_mut().find(|layer| layer.name == "color") {
            for (name, plane) in NAMES.into_iter().chain(["A"]).zip(caught) {
                if let Some(channel) = color.channels.iter_mut().find(|channel| channel.name == name) {
                    channel.data = plane;
                }
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Statistics;
    use vitrum_io::Picture;

    fn frame(pixels: &[[f32; 4]]) -> Frame {
        let picture = Picture::rgba(pixels.len() as u32, 1, pixels.to_vec());
        let Picture { width, height, layers } = picture;
        Frame { width, height, layers, light: None, statistics: Statistics::default() }
    }

    #[test]
    fn before_a_page_of_the_grounds_brightness_the_picture_is_what_it_was() {
        let ground = [0.5, 0.5, 0.4];
        let lit = |factors: [f32; 3]| std::array::from_fn::<f32, 3, _>(|index| ground[index] * factors[index]);
        let opaque = |[r, g, b]: [f32; 3]| [r, g, b, 1.0];
        // In the light, in half shadow, in a red caustic, below a half clear body, in the sky.
        let [half, red] = [lit([0.5; 3]), lit([3.0, 1.2, 1.0])];
        let seen = [
            opaque(ground),
            opaque(half),
            opaque(red),
            opaque([0.1 + 0.25 * half[0], 0.25 * half[1], 0.25 * half[2]]),
            [0.0; 4],
        ];
        let bare = [[0.0; 4], [0.0; 4], [0.0; 4], [0.1, 0.0, 0.0, 0.75], [0.0; 4]];
        let empty = [opaque(ground), opaque(ground), opaque(ground), opaque(ground), [0.0; 4]];
        let caught = frame(&seen).catch_shadows(&frame(&bare), &frame(&empty));
        let plane = |name| caught.channel("color", name).expect("it is there").to_vec();
        let alpha = plane("A");
        assert!(
            alpha.iter().zip([0.0, 0.5, 0.0, 0.875, 0.0]).all(|(seen, exact)| (seen - exact).abs() < 1e-6),
            "{alpha:?}"
        );
        for (index, name) in ["R", "G", "B"].into_iter().enumerate() {
            for (pixel, value) in plane(name).into_iter().enumerate() {
                let page = if pixel == 4 { 0.0 } else { ground[index] };
                let over = value + (1.0 - alpha[pixel]) * page;
                assert!((over - seen[pixel][index]).abs() < 1e-6, "{name} of {pixel}: {over}");
            }
        }
    }
}

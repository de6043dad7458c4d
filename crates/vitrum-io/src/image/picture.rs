//! A picture in memory.

use super::srgb::{linear_to_srgb, to_8_bits};

/// Layers of channels of one size. Values are linear and unbounded; row 0 is on top.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Pixels along x.
    pub width: u32,
    /// Pixels along y.
    pub height: u32,
    /// The first is the picture itself; others, such as depth, go to OpenEXR alone.
    pub layers: Vec<Layer>,
}

/// Channels that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Name of the layer, unique in the picture.
    pub name: String,
    /// Channels: `R`, `G`, `B` and perhaps a straight `A` of a colour; `Y` of a gray value; `X`, `Y`, `Z` of a vector; else the names
    /// in the file.
    pub channels: Vec<Channel>,
}

/// One number a pixel.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// Name of the channel, unique in the layer.
    pub name: String,
    /// `width * height` values, row by row from the top.
    pub data: Vec<f32>,
}

impl Picture {
    /// A picture of one layer, `color`, with channels R, G and B.
    ///
    /// Whether the pixels are as many as the size says is checked when it is written.
    #[must_use]
    pub fn rgb(width: u32, height: u32, pixels: Vec<[f32; 3]>) -> Self {
        Self::interleaved(width, height, ["R", "G", "B"], pixels)
    }

    /// As [`Self::rgb`] with a straight alpha A from 0, clear, to 1, opaque.
    #[must_use]
    pub fn rgba(width: u32, height: u32, pixels: Vec<[f32; 4]>) -> Self {
        Self::interleaved(width, height, ["R", "G", "B", "A"], pixels)
    }

    /// As [`Self::rgb`] with one channel, Y.
    #[must_use]
    pub fn gray(width: u32, height: u32, pixels: Vec<f32>) -> Self {
        let channels = vec![Channel { name: "Y".to_owned(), data: pixels }];
        Self { width, height, layers: vec![Layer { name: COLOR.to_owned(), channels }] }
    }

    fn interleaved<const CHANNELS: usize>(
        width: u32,
        height: u32,
        names: [&str; CHANNELS],
        pixels: Vec<[f32; CHANNELS]>,
    ) -> Self {
        let mut planes = [(); CHANNELS].map(|()| Vec::with_capacity(pixels.len()));
        for pixel in pixels {
            for (plane, value) in planes.iter_mut().zip(pixel) {
                plane.push(value);
            }
        }
        let channels = names.into_iter().zip(planes);
        let channels = channels.map(|(name, data)| Channel { name: name.to_owned(), data });
        let layer = Layer { name: COLOR.to_owned(), channels: channels.collect() };
        Self { width, height, layers: vec![layer] }
    }

    /// The first layer's pixels: R, G and B, or X, Y and Z of a vector. One with neither is gray: its first channel, repeated.
    #[must_use]
    pub fn color(&self) -> Vec<[f32; 3]> {
        let Some(layer) = self.layers.first() else {
            return Vec::new();
        };
        match layer.samples() {
            Samples::Color([r, g, b]) => r.iter().zip(g).zip(b).map(|((&r, &g), &b)| [r, g, b]).collect(),
            Samples::Gray(gray) => gray.iter().map(|&gray| [gray; 3]).collect(),
        }
    }

    /// The first layer's pixels as an 8-bit PNG has them: red, green and blue in sRGB, and a straight alpha, 255 where there is none.
    #[must_use]
    pub fn to_srgb8(&self) -> Vec<[u8; 4]> {
        let code = |value: f32| to_8_bits(linear_to_srgb(value));
        let coverage = self.layers.first().and_then(|layer| layer.channel("A"));
        let alpha =
            |pixel: usize| coverage.and_then(|plane| plane.get(pixel)).map_or(u8::MAX, |&value| to_8_bits(value));
        let pixels = self.color().into_iter().enumerate();
        pixels.map(|(at, [r, g, b])| [code(r), code(g), code(b), alpha(at)]).collect()
    }
}

/// The name of the first layer.
pub(super) const COLOR: &str = "color";

const COLORS: [&str; 3] = ["R", "G", "B"];

/// Channels of a vector, in the order in which they take the places of R, G and B.
const COMPONENTS: [&str; 3] = ["X", "Y", "Z"];

/// Channels of a layer that a format without named channels writes.
pub(super) enum Samples<'a> {
    Color([&'a [f32]; 3]),
    Gray(&'a [f32]),
}

impl Layer {
    /// The values of a channel.
    #[must_use]
    pub fn channel(&self, name: &str) -> Option<&[f32]> {
        let channel = self.channels.iter().find(|channel| channel.name == name)?;
        Some(&channel.data)
    }

    /// Whether the layer holds vectors, whose components may be negative: channels X, Y and Z.
    #[must_use]
    pub fn is_vector(&self) -> bool {
        self.triple(COLORS).is_none() && self.triple(COMPONENTS).is_some()
    }

    fn triple(&self, names: [&str; 3]) -> Option<[&[f32]; 3]> {
        let [a, b, c] = names.map(|name| self.channel(name));
        Some([a?, b?, c?])
    }

    pub(super) fn samples(&self) -> Samples<'_> {
        match self.triple(COLORS).or_else(|| self.triple(COMPONENTS)) {
            Some(three) => Samples::Color(three),
            None => Samples::Gray(self.channels.first().map_or(&[], |channel| &channel.data)),
        }
    }

    /// How many channels a pixel has as [`Self::interleave`] writes it: 1 to 4.
    pub(super) fn interleaved_channels(&self) -> usize {
        let colors = match self.samples() {
            Samples::Color(planes) => planes.len(),
            Samples::Gray(_) => 1,
        };
        colors + usize::from(self.channel("A").is_some())
    }

    /// The layer's channels of some pixels, pixel by pixel, gray or colour, each through `color` and an alpha at the end through `alpha`, behind what `out`
    /// holds.
    pub(super) fn interleave<T>(
        &self,
        pixels: std::ops::Range<usize>,
        color: impl Fn(f32) -> T,
        alpha: impl Fn(f32) -> T,
        out: &mut Vec<T>,
    ) {
        let planes = match self.samples() {
            Samples::Color(planes) => planes.to_vec(),
            Samples::Gray(plane) => vec![plane],
        };
        let coverage = self.channel("A");
        for pixel in pixels {
            out.extend(planes.iter().filter_map(|plane| plane.get(pixel)).map(|&v| color(v)));
            out.extend(coverage.and_then(|plane| plane.get(pixel)).map(|&v| alpha(v)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Picture;

    #[test]
    fn the_codes_of_a_screen_are_those_of_a_png() {
        let picture = Picture::rgba(2, 1, vec![[0.0, 0.215, 7.0, 0.5], [1.0, -1.0, 0.5, 1.0]]);
        assert_eq!(picture.to_srgb8(), [[0, 128, 255, 128], [255, 0, 188, 255]]);
        assert_eq!(Picture::gray(1, 1, vec![1.0]).to_srgb8(), [[255; 4]]);
    }
}

//! The background of a finished picture.

use super::frame::Frame;
use crate::scene::Paint;
use vitrum_io::{Layer, Picture};

/// The first layer's planes by name.
fn planes<'a, const N: usize>(layer: &'a Layer, names: [&str; N]) -> Option<[&'a [f32]; N]> {
    let found = names.map(|name| layer.channel(name));
    found.iter().all(Option::is_some).then(|| found.map(Option::unwrap_or_default))
}

impl Frame {
    /// Puts a colour behind the picture, which was rendered without an environment behind: in linear light, through the colour of clear matter.
    pub(crate) fn before(mut self, paint: Paint) -> Self {
        let behind = paint.linear();
        let Some(at) = self.layers.iter().position(|layer| layer.name == "color") else { return self };
        // Out of the list for a while, so that the others can be read.
        let mut color = self.layers.remove(at);
        self.put_behind(&mut color, behind);
        self.layers.insert(at, color);
        self
    }

    /// As [`Self::before`], of the layer `color`.
    fn put_behind(&self, color: &mut Layer, behind: [f32; 3]) {
        let tints = self.layers.iter().find(|layer| layer.name == "transmittance");
        let tints = tints.and_then(|layer| planes(layer, ["R", "G", "B"]));
        let Some(alpha) = color.channel("A").map(<[f32]>::to_vec) else { return };
        let coverage = |pixel: usize| alpha[pixel].clamp(0.0, 1.0);
        for channel in &mut color.channels {
            let Some(index) = ["R", "G", "B"].iter().position(|name| *name == channel.name) else {
                channel.data.fill(1.0);
                continue;
            };
            for (pixel, value) in channel.data.iter_mut().enumerate() {
                // The coverage is that of gray light; the tint parts it among the colours.
                let tint = tints.map_or(1.0, |planes| {
                    let sum: f32 = planes.iter().map(|plane| plane[pixel]).sum();
                    if sum > 0.0 { 3.0 * planes[index][pixel] / sum } else { 1.0 }
                });
                *value += (1.0 - coverage(pixel)) * tint * behind[index];
            }
        }
    }

    /// The picture's colour as formats of the screen take it: with a straight alpha. Light that outshines what its pixel covers, such as a caustic or a
    /// highlight on nothing, raises the alpha, so that it stays over a dark page.
    #[must_use]
    pub fn straight_picture(&self) -> Picture {
        let layers = self.layers.first().cloned().into_iter().collect();
        straight(Picture { width: self.width, height: self.height, layers })
    }

    /// As [`Self::straight_picture`], without a copy.
    #[must_use]
    pub fn into_straight_picture(mut self) -> Picture {
        self.layers.truncate(1);
        straight(self.into_picture())
    }
}

/// The picture's first layer with a straight alpha.
fn straight(mut picture: Picture) -> Picture {
    let Some(layer) = picture.layers.first_mut() else { return picture };
    let Some([r, g, b, a]) = planes(layer, ["R", "G", "B", "A"]) else { return picture };
    let raised = |pixel: usize| a[pixel].max(r[pixel].max(g[pixel]).max(b[pixel])).clamp(0.0, 1.0);
    let alpha: Vec<f32> = (0..a.len()).map(|pixel| if a[pixel] < 1.0 { raised(pixel) } else { 1.0 }).collect();
    for channel in &mut layer.channels {
        if channel.name == "A" {
            channel.data.copy_from_slice(&alpha);
            continue;
        }
        for (value, &alpha) in channel.data.iter_mut().zip(&alpha) {
            *value = if alpha > 0.0 { *value / alpha } else { 0.0 };
        }
    }
    picture
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Statistics;
    use vitrum_io::Channel;

    fn frame(color: [f32; 4], tint: [f32; 3]) -> Frame {
        let layer = |name: &str, names: &[&str], values: &[f32]| Layer {
            name: name.to_owned(),
            channels: names
                .iter()
                .zip(values)
                .map(|(name, &value)| Channel { name: (*name).to_owned(), data: vec![value] })
                .collect(),
        };
        let layers =
            vec![layer("color", &["R", "G", "B", "A"], &color), layer("transmittance", &["R", "G", "B"], &tint)];
        Frame { width: 1, height: 1, layers, light: None, statistics: Statistics::default() }
    }

    fn pixel(picture: &Picture) -> [f32; 4] {
        ["R", "G", "B", "A"].map(|name| picture.layers[0].channel(name).expect("it is there")[0])
    }

    #[test]
    fn a_background_shows_through_what_is_clear_in_its_colour() {
        let white = Paint { rgb: [255; 3], alpha: 255 };
        let close = |one: [f32; 4], other: [f32; 4]| one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-6);
        // Half covered by red, and what is behind through yellow glass: a share (0.6, 0.6, 0.3) of the light, half on average.
        let seen = pixel(&frame([0.2, 0.0, 0.0, 0.5], [0.6, 0.6, 0.3]).before(white).picture());
        assert!(close(seen, [0.8, 0.6, 0.3, 1.0]), "{seen:?}");
        let empty = pixel(&frame([0.0, 0.0, 0.0, 0.0], [1.0; 3]).before(white).picture());
        assert!(close(empty, [1.0; 4]), "{empty:?}");
        let full = pixel(&frame([0.1, 0.2, 0.3, 1.0], [0.0; 3]).before(white).picture());
        assert_eq!(full, [0.1, 0.2, 0.3, 1.0]);
    }

    #[test]
    fn straight_colours_come_back_over_black() {
        for color in [[0.2, 0.1, 0.0, 0.5], [0.0, 0.0, 0.0, 0.0], [0.4, 0.2, 0.1, 0.1], [0.3, 2.0, 0.0, 1.0]] {
            let [r, g, b, a] = pixel(&frame(color, [1.0; 3]).straight_picture());
            for (straight, whole) in [r, g, b].into_iter().zip(color) {
                assert!((straight * a - whole).abs() < 1e-6, "{color:?}");
                assert!(straight <= 1.0 || color[3] == 1.0, "{color:?}");
            }
            assert!((color[3]..=1.0).contains(&a));
        }
    }
}

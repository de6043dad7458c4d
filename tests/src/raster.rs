//! Rasters, which comparisons compare: a picture of colours, or numbers laid out as one.

use std::borrow::Cow;

use vitrum::Frame;
use vitrum_compare::{CompareError, Comparison, compare, compare_buffers};
use vitrum_io::Layer;

/// A picture of colours, or numbers laid out as one.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Row by row from the top.
    pub pixels: Pixels,
}

/// The values of a raster.
#[derive(Debug, Clone, PartialEq)]
pub enum Pixels {
    /// Linear RGB that is shown, so that FLIP can judge it.
    Colors(Vec<[f32; 3]>),
    /// Anything else, compared as numbers.
    Numbers(Vec<f32>),
}

impl Raster {
    /// Planes of numbers, each of whole rows of `width`, one below the other: as a planar buffer lies in memory.
    #[must_use]
    pub fn stacked<'a>(width: u32, planes: impl IntoIterator<Item = &'a [f32]>) -> Self {
        let numbers: Vec<f32> = planes.into_iter().flatten().copied().collect();
        let height = u32::try_from(numbers.len()).unwrap_or(u32::MAX) / width.max(1);
        Self { width, height, pixels: Pixels::Numbers(numbers) }
    }

    /// Measures the difference to another raster; this one is the reference.
    ///
    /// # Errors
    /// If they differ in size.
    pub fn compare(&self, other: &Self) -> Result<Comparison, CompareError> {
        if let (Pixels::Colors(reference), Pixels::Colors(other)) = (&self.pixels, &other.pixels) {
            return compare(reference, other, self.width, self.height);
        }
        let mut comparison = compare_buffers(self.values(), other.values())?;
        (comparison.width, comparison.height) = (self.width, self.height);
        Ok(comparison)
    }

    /// Whether the values are colours that are shown.
    #[must_use]
    pub fn is_shown(&self) -> bool {
        matches!(self.pixels, Pixels::Colors(_))
    }

    /// The raster as colours, with numbers as grays.
    #[must_use]
    pub fn colors(&self) -> Cow<'_, [[f32; 3]]> {
        match &self.pixels {
            Pixels::Colors(colors) => Cow::Borrowed(colors),
            Pixels::Numbers(numbers) => numbers.iter().map(|&number| [number; 3]).collect(),
        }
    }

    fn values(&self) -> &[f32] {
        match &self.pixels {
            Pixels::Colors(colors) => colors.as_flattened(),
            Pixels::Numbers(numbers) => numbers,
        }
    }
}

/// Every output of a frame, by name.
#[must_use]
pub fn of_frame(frame: &Frame) -> Vec<(String, Raster)> {
    let size = [frame.width, frame.height];
    let mut rasters: Vec<_> = frame.layers.iter().flat_map(|layer| of_layer(layer, size)).collect();
    if let Some(light) = &frame.light {
        rasters.extend(light.layers.iter().map(|layer| ("light".to_owned(), numbers(layer, light.width, ""))));
    }
    rasters
}

/// A layer of `size` pixels, by name: colours and their alpha apart, other channels together.
#[must_use]
pub fn of_layer(layer: &Layer, size: [u32; 2]) -> Vec<(String, Raster)> {
    let [width, height] = size;
    let color = ["R", "G", "B"].map(|name| layer.channel(name));
    match (layer.name.as_str(), color) {
        ("color", [Some(r), Some(g), Some(b)]) => {
            let colors = r.iter().zip(g).zip(b).map(|((&r, &g), &b)| [r, g, b]).collect();
            let color = Raster { width, height, pixels: Pixels::Colors(colors) };
            vec![("color".to_owned(), color), ("color.A".to_owned(), numbers(layer, width, "RGB"))]
        }
        (name, _) => vec![(name.to_owned(), numbers(layer, width, ""))],
    }
}

/// The channels of a layer, less those named by a letter of `without`.
fn numbers(layer: &Layer, width: u32, without: &str) -> Raster {
    let channels = layer.channels.iter().filter(|channel| !without.contains(&channel.name));
    Raster::stacked(width, channels.map(|channel| channel.data.as_slice()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_io::Picture;

    #[test]
    fn numbers_are_placed_as_planes_one_below_the_other() {
        let reference = Raster::stacked(2, [[1.0; 4].as_slice(), [2.0; 4].as_slice()]);
        let mut other = reference.clone();
        other.pixels = Pixels::Numbers(vec![1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.5]);
        let comparison = reference.compare(&other).unwrap();
        assert_eq!((reference.width, reference.height), (2, 4));
        assert_eq!((comparison.worst_pixel(), comparison.mean_flip), (Some((1, 3)), None));
    }

    #[test]
    fn colours_and_alpha_are_apart() {
        let picture = Picture::rgba(2, 1, vec![[0.1, 0.2, 0.3, 0.4], [0.5, 0.6, 0.7, 0.8]]);
        let rasters = of_layer(&picture.layers[0], [2, 1]);
        assert_eq!(rasters[0].1.colors().as_ref(), [[0.1, 0.2, 0.3], [0.5, 0.6, 0.7]]);
        assert!(rasters[0].1.is_shown() && !rasters[1].1.is_shown());
        assert_eq!(rasters[1], ("color.A".to_owned(), Raster::stacked(2, [[0.4, 0.8].as_slice()])));
    }

    #[test]
    fn sizes_must_agree() {
        let (one, other) = (Raster::stacked(1, [[0.0; 1].as_slice()]), Raster::stacked(1, [[0.0; 2].as_slice()]));
        assert!(one.compare(&other).is_err());
    }
}

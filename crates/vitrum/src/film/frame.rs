//! A finished frame.

use super::statistics::Statistics;
use std::path::Path;
use vitrum_io::{Layer, Picture, linear_to_srgb};

/// A finished frame: named outputs, row 0 on top, linear.
///
/// [`Method::outputs`](crate::method::Method::outputs) describes the outputs. Where a pixel has several rays (`film.supersampling`) it shows
/// their mean: of depths the mean of the rays that have one, of directions and normals the unit vector; `position`, `status` and
/// `bounces` are those of the ray next to the pixel's centre.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// The outputs of the picture's size, `color` (RGBA) first.
    pub layers: Vec<Layer>,
    /// The light on the last plane, in the light grid's texels, row 0 on top, if it was requested.
    pub light: Option<Picture>,
    /// Statistics of the frame.
    pub statistics: Statistics,
}

impl Frame {
    /// An output as a picture of its own; `None` if the frame has no output of that name, or it was not requested.
    pub fn aov(&self, name: &str) -> Option<Picture> {
        if name == "light" {
            return self.light.clone();
        }
        let layer = self.layers.iter().find(|layer| layer.name == name)?;
        Some(Picture { width: self.width, height: self.height, layers: vec![layer.clone()] })
    }

    /// A picture of all outputs of the picture's size.
    pub fn picture(&self) -> Picture {
        Picture { width: self.width, height: self.height, layers: self.layers.clone() }
    }

    /// As [`Self::picture`], without a copy.
    #[must_use]
    pub fn into_picture(self) -> Picture {
        Picture { width: self.width, height: self.height, layers: self.layers }
    }

    /// Hands an output over as a picture of its own, without a copy, while `use_it` runs; `None` as of [`Self::aov`].
    pub fn lend_aov<T>(&mut self, name: &str, use_it: impl FnOnce(&Picture) -> T) -> Option<T> {
        if name == "light" {
            return self.light.as_ref().map(use_it);
        }
        let at = self.layers.iter().position(|layer| layer.name == name)?;
        let mut picture = Picture { width: self.width, height: self.height, layers: vec![self.layers.remove(at)] };
        let outcome = use_it(&picture);
        self.layers.splice(at..at, picture.layers.drain(..));
        Some(outcome)
    }

    /// Writes the picture to a file, in the format of its extension; formats with layers get all outputs of the picture's size.
    ///
    /// # Errors
    /// Those of [`vitrum_io::write_picture`].
    pub fn write(&self, path: &Path) -> Result<(), vitrum_io::Error> {
        vitrum_io::write_picture(path, &self.picture(), &[])
    }

    /// The picture for a screen: red, green, blue and coverage of each pixel, row by row from the top, 0 to 255. Colours are encoded by the
    /// curve of sRGB, brighter ones than white are white; coverage is linear, and colours are not divided by it.
    #[must_use]
    pub fn to_srgb8(&self) -> Vec<u8> {
        let code = |value: f32| (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        let channels = ["R", "G", "B", "A"].map(|name| self.channel("color", name).unwrap_or_default());
        let pixel = |at: usize| {
            let [red, green, blue, coverage] = channels.map(|channel| channel[at]);
            [code(linear_to_srgb(red)), code(linear_to_srgb(green)), code(linear_to_srgb(blue)), code(coverage)]
        };
        (0..channels[0].len()).flat_map(pixel).collect()
    }

    /// Exposure: multiplies the colour by 2^`stops`.
    pub(crate) fn expose(mut self, stops: f32) -> Self {
        let color = self.layers.iter_mut().filter(|layer| layer.name == "color");
        for channel in color.flat_map(|layer| layer.channels.iter_mut().filter(|channel| channel.name != "A")) {
            channel.data.iter_mut().for_each(|value| *value *= libm::exp2f(stops));
        }
        self
    }

    /// One channel of an output, e.g. `color` and `R`.
    pub fn channel(&self, layer: &str, channel: &str) -> Option<&[f32]> {
        let layer = self.layers.iter().find(|found| found.name == layer)?;
        layer.channels.iter().find(|found| found.name == channel).map(|found| found.data.as_slice())
    }
}

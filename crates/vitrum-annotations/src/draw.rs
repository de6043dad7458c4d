//! Drawing the document over a picture.

use crate::{AnnotationError, Overlay, font};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use vitrum::io::{Picture, linear_to_srgb, srgb_to_linear};

/// The document's pixels: red, green, blue, multiplied by the opacity, and the opacity.
pub(crate) fn rasterize(svg: &str, width: u32, height: u32) -> Result<Pixmap, AnnotationError> {
    let options = Options { font_family: font::NAME.to_owned(), fontdb: font::DATABASE.clone(), ..Options::default() };
    let tree = Tree::from_str(svg, &options).map_err(|error| AnnotationError::Drawing(error.to_string()))?;
    let mut pixmap = Pixmap::new(width, height)
        .ok_or_else(|| AnnotationError::Drawing(format!("{width} x {height} pixels are too many")))?;
    resvg::render(&tree, Transform::default(), &mut pixmap.as_mut());
    Ok(pixmap)
}

impl Overlay {
    /// Draws the annotations over the picture's first layer, whose alpha, if it has one, is straight. They are mixed as a screen shows them, in sRGB; pixels
    /// without annotations stay as they are.
    ///
    /// # Errors
    /// [`AnnotationError::Drawing`] where the document is not understood.
    pub fn draw(&self, picture: &mut Picture) -> Result<(), AnnotationError> {
        let drawn = rasterize(&self.svg, picture.width, picture.height)?;
        let Some(layer) = picture.layers.first_mut() else { return Ok(()) };
        let alpha = layer.channels.iter().position(|channel| channel.name == "A");
        for (pixel, over) in drawn.pixels().iter().enumerate() {
            if over.alpha() == 0 {
                continue;
            }
            let cover = f32::from(over.alpha()) / 255.0;
            let below = alpha.map_or(1.0, |index| layer.channels[index].data[pixel].clamp(0.0, 1.0));
            let above = below * (1.0 - cover);
            let whole = cover + above;
            let mix = |value: &mut f32, code: u8| {
                let mixed = f32::from(code) / 255.0 + linear_to_srgb(value.clamp(0.0, 1.0)) * above;
                *value = srgb_to_linear((mixed / whole).clamp(0.0, 1.0));
            };
            let codes = [over.red(), over.green(), over.blue()];
            for channel in &mut layer.channels {
                match channel.name.as_str() {
                    "R" => mix(&mut channel.data[pixel], codes[0]),
                    "G" => mix(&mut channel.data[pixel], codes[1]),
                    "B" => mix(&mut channel.data[pixel], codes[2]),
                    "A" => channel.data[pixel] = whole,
                    _ => {}
                }
            }
        }
        Ok(())
    }
}

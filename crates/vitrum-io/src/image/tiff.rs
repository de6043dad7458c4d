//! TIFF: linear float32.

use std::io;

use image::codecs::tiff::TiffEncoder;
use image::{ExtendedColorType, ImageEncoder};

use super::picture::Picture;
use crate::atomic_write::Sink;

pub(super) fn encode(sink: &mut dyn Sink, picture: &Picture) -> io::Result<()> {
    let Picture { width, height, .. } = *picture;
    let Some(layer) = picture.layers.first() else { return Ok(()) };
    // The encoder has no float32 gray, so that becomes colour.
    let (values, color_type) = match (picture.color(), layer.channel("A")) {
        (color, None) => (color.into_flattened(), ExtendedColorType::Rgb32F),
        (color, Some(alpha)) => {
            let pixels = color.into_iter().zip(alpha);
            let values = pixels.flat_map(|([r, g, b], &a)| [r, g, b, a]).collect();
            (values, ExtendedColorType::Rgba32F)
        }
    };
    TiffEncoder::new(sink)
        .write_image(bytemuck::cast_slice(&values), width, height, color_type)
        .map_err(io::Error::other)
}

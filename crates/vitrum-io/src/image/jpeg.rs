//! JPEG: sRGB in 8 bits, without alpha.

use std::io;

use image::ExtendedColorType;
use image::codecs::jpeg::JpegEncoder;

use super::options::WriteOptions;
use super::picture::Picture;
use super::srgb::{linear_to_srgb, to_8_bits};
use crate::atomic_write::Sink;

pub(super) fn encode(sink: &mut dyn Sink, picture: &Picture, options: WriteOptions) -> io::Result<()> {
    let code = |value| to_8_bits(linear_to_srgb(value));
    let bytes: Vec<u8> = picture.color().into_iter().flat_map(|pixel| pixel.map(code)).collect();
    JpegEncoder::new_with_quality(sink, options.jpeg_quality)
        .encode(&bytes, picture.width, picture.height, ExtendedColorType::Rgb8)
        .map_err(io::Error::other)
}

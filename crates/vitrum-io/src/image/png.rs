//! PNG: sRGB in 8 or 16 bits.

use std::io;

use png::{BitDepth, ColorType, Encoder, SrgbRenderingIntent};

use super::options::{Metadata, WriteOptions};
use super::picture::Picture;
use super::srgb::{linear_to_srgb, to_8_bits, to_16_bits};
use crate::atomic_write::Sink;

pub(super) fn encode(
    sink: &mut dyn Sink,
    picture: &Picture,
    metadata: &Metadata,
    options: WriteOptions,
) -> io::Result<()> {
    let Some(layer) = picture.layers.first() else { return Ok(()) };
    let (bytes, channels, depth) = if options.png_bits == 16 {
        let (codes, channels) = layer.interleave(|value| to_16_bits(linear_to_srgb(value)), to_16_bits);
        let bytes = codes.into_iter().flat_map(u16::to_be_bytes).collect();
        (bytes, channels, BitDepth::Sixteen)
    } else {
        let (bytes, channels) = layer.interleave(|value| to_8_bits(linear_to_srgb(value)), to_8_bits);
        (bytes, channels, BitDepth::Eight)
    };
    let bytes: Vec<u8> = bytes;
    let mut encoder = Encoder::new(sink, picture.width, picture.height);
    encoder.set_color(match channels {
        1 => ColorType::Grayscale,
        2 => ColorType::GrayscaleAlpha,
        3 => ColorType::Rgb,
        _ => ColorType::Rgba,
    });
    encoder.set_depth(depth);
    encoder.set_source_srgb(SrgbRenderingIntent::RelativeColorimetric);
    for (key, value) in metadata {
        encoder.add_itxt_chunk(key.clone(), value.clone())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes)?;
    Ok(writer.finish()?)
}

//! PNG: sRGB in 8 or 16 bits.

use std::io::{self, Write as _};

use png::{BitDepth, ColorType, Encoder, SrgbRenderingIntent};

use super::options::{Metadata, WriteOptions};
use super::picture::Picture;
use super::srgb::{linear_to_srgb, to_8_bits, to_16_bits};
use crate::atomic_write::Sink;

/// Bytes of a chunk of compressed pixels.
const BUFFER: usize = 1 << 18;

pub(super) fn encode(
    sink: &mut dyn Sink,
    picture: &Picture,
    metadata: &Metadata,
    options: WriteOptions,
) -> io::Result<()> {
    let Some(layer) = picture.layers.first() else { return Ok(()) };
    let mut encoder = Encoder::new(sink, picture.width, picture.height);
    encoder.set_color(match layer.interleaved_channels() {
        1 => ColorType::Grayscale,
        2 => ColorType::GrayscaleAlpha,
        3 => ColorType::Rgb,
        _ => ColorType::Rgba,
    });
    encoder.set_depth(if options.png_bits == 16 { BitDepth::Sixteen } else { BitDepth::Eight });
    encoder.set_source_srgb(SrgbRenderingIntent::RelativeColorimetric);
    for (key, value) in metadata {
        encoder.add_itxt_chunk(key.clone(), value.clone())?;
    }
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer_with_size(BUFFER)?;
    let width = picture.width as usize;
    let (mut codes, mut bytes): (Vec<u16>, Vec<u8>) = (Vec::new(), Vec::new());
    // Row by row: a large picture needs little memory besides itself.
    for row in 0..picture.height as usize {
        let pixels = row * width..(row + 1) * width;
        bytes.clear();
        if options.png_bits == 16 {
            codes.clear();
            layer.interleave(pixels, |value| to_16_bits(linear_to_srgb(value)), to_16_bits, &mut codes);
            bytes.extend(codes.iter().flat_map(|code| code.to_be_bytes()));
        } else {
            layer.interleave(pixels, |value| to_8_bits(linear_to_srgb(value)), to_8_bits, &mut bytes);
        }
        stream.write_all(&bytes)?;
    }
    stream.finish()?;
    Ok(writer.finish()?)
}

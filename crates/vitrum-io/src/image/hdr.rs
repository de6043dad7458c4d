//! Radiance HDR: 8-bit mantissas with a shared exponent, about 1 % precise.

use std::io;

use image::Rgb;
use image::codecs::hdr::HdrEncoder;

use super::picture::Picture;
use crate::atomic_write::Sink;

/// Largest value that the format holds: mantissa 255/256, exponent 127.
const LARGEST: f32 = 1.694_9e38;

pub(super) fn encode(sink: &mut dyn Sink, picture: &Picture) -> io::Result<()> {
    // RGBE has no negative numbers, no infinity and no NaN, which becomes black.
    let sane = |value: f32| if value.is_nan() { 0.0 } else { value.clamp(0.0, LARGEST) };
    let pixels: Vec<_> = picture.color().into_iter().map(|pixel| Rgb(pixel.map(sane))).collect();
    HdrEncoder::new(sink).encode(&pixels, picture.width as usize, picture.height as usize).map_err(io::Error::other)
}

//! The size that a picture may have.

use crate::error::{Error, Place, Report};
use crate::memory;
use crate::options::OpenOptions;

/// Largest number of pixels of a picture: 16384 squared, the largest texture of a graphics card.
const MOST_PIXELS: u64 = 1 << 28;

/// The error of a picture that is whole, and shows nothing.
pub(super) fn empty(report: Report) -> Error {
    report.invalid(Place::File, "there are no pixels in it", "get the file again, or write it anew")
}

/// Fails where `channels` of float32 in this size are too many, before they are allocated.
pub(super) fn check_size(
    report: Report,
    width: u64,
    height: u64,
    channels: u64,
    options: &OpenOptions,
) -> Result<(), Error> {
    let pixels = width.saturating_mul(height);
    let bytes = |pixels: u64| pixels.saturating_mul(channels).saturating_mul(4);
    if pixels > MOST_PIXELS {
        let advice = format!("scale it down from {width} x {height} pixels");
        return Err(report.too_large(bytes(pixels), bytes(MOST_PIXELS), advice));
    }
    memory::check(report, bytes(pixels), options.max_bytes)
}

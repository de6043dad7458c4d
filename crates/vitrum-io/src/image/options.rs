//! Choices about writing pictures.

use crate::error::{Error, Report};

/// Choices about writing a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WriteOptions {
    /// Bits per channel of PNG: 8 or 16.
    pub png_bits: u8,
    /// Quality of JPEG from 1, smallest, to 100, best.
    pub jpeg_quality: u8,
}

impl Default for WriteOptions {
    fn default() -> Self {
        Self { png_bits: 8, jpeg_quality: 95 }
    }
}

/// Text about a picture: keys, and values.
pub(super) type Metadata = [(String, String)];

/// Fails where an option is out of range.
pub(super) fn check_options(report: Report, options: WriteOptions) -> Result<(), Error> {
    let WriteOptions { png_bits, jpeg_quality } = options;
    if !matches!(png_bits, 8 | 16) {
        return Err(report.write(format!("PNG with {png_bits} bits"), "choose 8 or 16", None));
    }
    if !(1..=100).contains(&jpeg_quality) {
        let problem = format!("a JPEG quality of {jpeg_quality}");
        return Err(report.write(problem, "choose 1 to 100", None));
    }
    Ok(())
}

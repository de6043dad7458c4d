//! Transfer syntaxes: how a file's pixels are written.

use crate::error::{Error, Place, Report, clip};

/// Compression of pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Compression {
    /// Samples without compression.
    None,
    RunLengths,
    Jpeg,
    JpegLs,
    Jpeg2000,
}

/// Implicit VR, little-endian.
pub(super) const IMPLICIT: &str = "1.2.840.10008.1.2";
/// Explicit VR, little-endian.
pub(super) const EXPLICIT: &str = "1.2.840.10008.1.2.1";
/// Explicit VR, big-endian.
pub(super) const BIG_ENDIAN: &str = "1.2.840.10008.1.2.2";
/// Explicit VR, little-endian, the data set deflated as a whole.
pub(super) const DEFLATED: &str = "1.2.840.10008.1.2.1.99";

/// Transfer syntaxes that are read: identifier, name, and compression of pixels.
const READ: [(&str, &str, Compression); 13] = [
    (IMPLICIT, "raw, little-endian", Compression::None),
    (EXPLICIT, "raw, little-endian", Compression::None),
    (BIG_ENDIAN, "raw, big-endian", Compression::None),
    (DEFLATED, "deflate, little-endian", Compression::None),
    ("1.2.840.10008.1.2.4.50", "JPEG", Compression::Jpeg),
    ("1.2.840.10008.1.2.4.51", "JPEG, 12 bit", Compression::Jpeg),
    ("1.2.840.10008.1.2.4.57", "JPEG, lossless", Compression::Jpeg),
    ("1.2.840.10008.1.2.4.70", "JPEG, lossless", Compression::Jpeg),
    ("1.2.840.10008.1.2.4.80", "JPEG-LS, lossless", Compression::JpegLs),
    ("1.2.840.10008.1.2.4.81", "JPEG-LS", Compression::JpegLs),
    ("1.2.840.10008.1.2.4.90", "JPEG 2000, lossless", Compression::Jpeg2000),
    ("1.2.840.10008.1.2.4.91", "JPEG 2000", Compression::Jpeg2000),
    ("1.2.840.10008.1.2.5", "RLE", Compression::RunLengths),
];

/// Name of a transfer syntax, for people.
pub(super) fn name(identifier: &str) -> String {
    found(identifier).map_or(identifier, |(name, _)| name).to_owned()
}

/// Whether the pixels are known not to be compressed.
pub(super) fn is_raw(identifier: &str) -> bool {
    found(identifier).is_some_and(|(_, compression)| compression == Compression::None)
}

/// Compression of the pixels; an error where they cannot be read.
pub(super) fn compression(report: Report, identifier: &str) -> Result<Compression, Error> {
    if let Some((_, compression)) = found(identifier) {
        return Ok(compression);
    }
    let known = match identifier.strip_prefix("1.2.840.10008.1.2.").unwrap_or_default() {
        "4.92" | "4.93" => "JPEG 2000 of several components",
        "4.110" | "4.111" | "4.112" => "JPEG XL",
        "4.201" | "4.202" | "4.203" => "High-Throughput JPEG 2000",
        other if other.starts_with("4.10") => "video",
        _ => "",
    };
    let identifier = clip(identifier);
    let shown = if known.is_empty() { identifier } else { format!("{known} ({identifier})") };
    Err(report.unsupported(
        Place::File,
        format!("the pixels are written as {shown}, none of raw, RLE, JPEG, JPEG-LS and JPEG 2000"),
        "convert the files, for example by `gdcmconv --raw IN OUT` or `dcmdjpls IN OUT`",
    ))
}

fn found(identifier: &str) -> Option<(&'static str, Compression)> {
    READ.iter().find(|(other, ..)| *other == identifier).map(|&(_, name, compression)| (name, compression))
}

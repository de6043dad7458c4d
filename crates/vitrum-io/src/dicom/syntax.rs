//! Transfer syntaxes: how a file's pixels are written.

use crate::error::{Error, Place, Report, clip};

/// Those that are read: identifier, name, and whether pixels are compressed.
const READ: [(&str, &str, bool); 8] = [
    ("1.2.840.10008.1.2", "raw, little-endian", false),
    ("1.2.840.10008.1.2.1", "raw, little-endian", false),
    ("1.2.840.10008.1.2.2", "raw, big-endian", false),
    ("1.2.840.10008.1.2.4.50", "JPEG", true),
    ("1.2.840.10008.1.2.4.51", "JPEG, 12 bit", true),
    ("1.2.840.10008.1.2.4.57", "JPEG, lossless", true),
    ("1.2.840.10008.1.2.4.70", "JPEG, lossless", true),
    ("1.2.840.10008.1.2.5", "RLE", true),
];

/// For people.
pub(super) fn name(identifier: &str) -> String {
    found(identifier).map_or(identifier, |(name, _)| name).to_owned()
}

/// Whether the pixels are written as DICOM's run lengths.
pub(super) fn is_run_lengths(identifier: &str) -> bool {
    name(identifier) == "RLE"
}

/// Whether the pixels are compressed; an error where they cannot be read.
pub(super) fn compressed(report: Report, identifier: &str) -> Result<bool, Error> {
    if let Some((_, compressed)) = found(identifier) {
        return Ok(compressed);
    }
    let known = match identifier.strip_prefix("1.2.840.10008.1.2.").unwrap_or_default() {
        "1.99" => "deflate",
        "4.80" | "4.81" => "JPEG-LS",
        "4.90" | "4.91" | "4.92" | "4.93" => "JPEG 2000",
        "4.110" | "4.111" | "4.112" => "JPEG XL",
        "4.201" | "4.202" | "4.203" => "High-Throughput JPEG 2000",
        other if other.starts_with("4.10") => "video",
        _ => "",
    };
    let identifier = clip(identifier);
    let shown = if known.is_empty() { identifier } else { format!("{known} ({identifier})") };
    Err(report.unsupported(
        Place::File,
        format!("the pixels are written as {shown}, none of raw, RLE, JPEG and lossless JPEG"),
        "convert the files, for example by `gdcmconv --raw IN OUT` or `dcmdjpls IN OUT`",
    ))
}

fn found(identifier: &str) -> Option<(&'static str, bool)> {
    READ.iter().find(|(other, ..)| *other == identifier).map(|&(_, name, compressed)| (name, compressed))
}

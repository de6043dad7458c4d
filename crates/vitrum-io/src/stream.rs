//! Checks of the size that a header promises against the bytes that follow it.

use std::io::{self, Read};

use crate::error::{Error, Place, Report};
use crate::samples::{SampleType, VoxelBuffer, read_up_to};

/// The bytes that so many samples take in the file, or the problem with the sizes at `place`.
pub(crate) fn data_bytes(report: Report, place: Place, dimensions: [u32; 3], sample: SampleType) -> Result<u64, Error> {
    data_bytes_of(report, place, dimensions, sample.size())
}

/// As [`data_bytes`], for voxels of so many bytes.
pub(crate) fn data_bytes_of(report: Report, place: Place, dimensions: [u32; 3], size: usize) -> Result<u64, Error> {
    byte_count(dimensions, size).map_err(|problem| report.invalid(place, problem, "correct the sizes"))
}

/// Bytes of `dimensions` voxels of `size` bytes; the problem where that is more than any file holds.
pub(crate) fn byte_count(dimensions: [u32; 3], size: usize) -> Result<u64, String> {
    let bytes = dimensions.into_iter().map(u128::from).product::<u128>().saturating_mul(size as u128);
    // Half of the address space, so that no sum of sizes and offsets can overflow.
    u64::try_from(bytes)
        .ok()
        .filter(|&bytes| bytes <= u64::MAX >> 1)
        .ok_or_else(|| format!("the sizes make {bytes} bytes, more than any file holds"))
}

/// Fails where `available` bytes cannot hold `needed`, before anything is allocated for them.
pub(crate) fn check_length(report: Report, needed: u64, start: u64, available: u64) -> Result<(), Error> {
    if available < needed {
        return Err(report.invalid(
            Place::Byte(start),
            format!("the header promises {needed} bytes of data from here, {available} are there"),
            "correct the sizes or the sample type in the header, or get the whole file",
        ));
    }
    Ok(())
}

/// Deflate codes at most 258 bytes in 2 bits.
pub(crate) const DEFLATE_RATIO: u64 = 1032;

/// Fails where a deflate stream of `compressed` bytes cannot possibly hold `expected`.
pub(crate) fn check_deflate(report: Report, expected: u64, compressed: u64) -> Result<(), Error> {
    check_ratio(report, expected, compressed, DEFLATE_RATIO)
}

/// Fails where `compressed` bytes that grow at most by `ratio` cannot possibly hold `expected`: a
/// small file that promises more lies, and is refused without inflating it.
pub(crate) fn check_ratio(report: Report, expected: u64, compressed: u64, ratio: u64) -> Result<(), Error> {
    let most = compressed.saturating_mul(ratio);
    if expected > most {
        let packed = if ratio > 1 { "compressed " } else { "" };
        return Err(report.invalid(
            Place::File,
            format!(
                "the header promises {expected} bytes of data, and the {compressed} {packed}bytes can hold {most} at \
                 most"
            ),
            "correct the sizes or the sample type in the header, or get the whole file",
        ));
    }
    Ok(())
}

/// Decodes exactly `count` samples of `size` bytes from `reader` into `voxels`.
pub(crate) fn fill(
    report: Report,
    voxels: &mut VoxelBuffer,
    reader: &mut dyn Read,
    count: usize,
    size: usize,
) -> Result<(), Error> {
    let expected = count as u64 * size as u64;
    let (found, outcome) = voxels.append(reader, count);
    if let Err(error) = outcome {
        return Err(damaged(report, found, expected, error));
    }
    if found < expected {
        return Err(report.invalid(
            Place::File,
            format!("the header promises {expected} bytes of data, {found} were found"),
            "correct the sizes or the sample type in the header, or get the whole file",
        ));
    }
    Ok(())
}

/// Fails where a compressed stream goes on behind the `expected` bytes of data.
///
/// Reads to the end of the stream as long as that is near, which also checks its checksum, and
/// gives up soon behind: a stream may inflate to a thousand times its size.
pub(crate) fn refuse_surplus(report: Report, reader: &mut dyn Read, expected: u64) -> Result<(), Error> {
    const SLACK: usize = 64 * 1024;
    let mut behind = vec![0; SLACK];
    let (surplus, outcome) = read_up_to(reader, &mut behind);
    let found = expected + surplus as u64;
    outcome.map_err(|error| damaged(report, found, expected, error))?;
    // Zeros pad a stream.
    if behind[..surplus].iter().any(|&byte| byte != 0) {
        let more = if surplus == SLACK { "at least " } else { "" };
        return Err(report.invalid(
            Place::File,
            format!("the header promises {expected} bytes of data, {more}{found} were found"),
            "correct the sizes or the sample type in the header",
        ));
    }
    Ok(())
}

/// Skips exactly `count` bytes in front of the data.
pub(crate) fn skip(report: Report, reader: &mut dyn Read, count: u64) -> Result<(), Error> {
    let skipped = io::copy(&mut reader.take(count), &mut io::sink()).map_err(|error| broken(report, 0, error))?;
    if skipped < count {
        return Err(report.invalid(
            Place::File,
            format!("{count} bytes are to be skipped, {skipped} are there"),
            "correct the number of bytes to skip, or get the whole file",
        ));
    }
    Ok(())
}

/// As [`damaged`], of data whose length is not known.
pub(crate) fn broken(report: Report, found: u64, error: io::Error) -> Error {
    match error.kind() {
        io::ErrorKind::InvalidData | io::ErrorKind::InvalidInput | io::ErrorKind::UnexpectedEof => report.invalid(
            Place::File,
            format!("the data is damaged after {found} bytes: {error}"),
            "get the file again, or write it anew",
        ),
        _ => report.unreadable(error),
    }
}

/// An error out of a decoder is the file's fault, any other the system's.
pub(crate) fn damaged(report: Report, found: u64, expected: u64, error: io::Error) -> Error {
    match error.kind() {
        io::ErrorKind::InvalidData | io::ErrorKind::InvalidInput | io::ErrorKind::UnexpectedEof => report.invalid(
            Place::File,
            format!("the data is damaged after {found} of {expected} bytes: {error}"),
            "get the file again, or write it anew",
        ),
        _ => report.unreadable(error),
    }
}

//! The decoder of TIFF pages: opened, asked, and its errors.

use std::io;

use tiff::TiffError;
use tiff::decoder::{Decoder, Limits};
use tiff::tags::{CompressionMethod, Tag};

use super::patched::Patched;
use crate::error::{Error, Place, Report};
use crate::storage::{ByteReader, Storage};
use crate::stream;

/// A TIFF file at one of its pages.
pub(super) type Reader<'a> = Decoder<Patched<ByteReader<'a>>>;

/// The file at its first page.
pub(super) fn open<'a>(storage: &Storage<'a>, report: Report) -> Result<Reader<'a>, Error> {
    let file = storage.open().map_err(|error| report.unreadable(error))?;
    let mut limits = Limits::default();
    // Strips are read through small buffers, however long they are.
    limits.intermediate_buffer_size = usize::MAX;
    // The description of a microscope's file may be long.
    limits.ifd_value_size = 32 << 20;
    let file = Patched::new(file).map_err(|error| report.unreadable(error))?;
    let decoder = Decoder::new(file).map_err(|error| damaged(report, 1, error))?;
    Ok(decoder.with_limits(limits))
}

/// The file's byte order, for people.
pub(super) fn order(decoder: &Reader) -> &'static str {
    match decoder.byte_order() {
        tiff::tags::ByteOrder::LittleEndian => "little-endian",
        tiff::tags::ByteOrder::BigEndian => "big-endian",
    }
}

/// Whether a page is a smaller copy of another.
pub(super) fn is_thumbnail(decoder: &mut Reader) -> Result<bool, TiffError> {
    let kind: Option<u32> = decoder.find_tag_unsigned(Tag::NewSubfileType)?;
    Ok(kind.is_some_and(|kind| kind & 1 == 1))
}

/// Compression of a page, and the most bytes that one of its bytes can unpack to.
pub(super) struct Compression {
    pub name: &'static str,
    pub ratio: u64,
}

impl Compression {
    pub fn of(decoder: &mut Reader, report: Report, number: u64) -> Result<Self, Error> {
        let code = decoder.find_tag_unsigned(Tag::Compression).map_err(|error| damaged(report, number, error))?;
        let (name, ratio) = match CompressionMethod::from_u16_exhaustive(code.unwrap_or(1)) {
            CompressionMethod::None => ("raw", 1),
            // A code of at least 9 bits stands for at most 4096 bytes.
            CompressionMethod::LZW => ("LZW", 3641),
            CompressionMethod::Deflate | CompressionMethod::OldDeflate => ("deflate", stream::DEFLATE_RATIO),
            // Two bytes stand for at most 128.
            CompressionMethod::PackBits => ("PackBits", 64),
            other => {
                return Err(report.unsupported(
                    Place::File,
                    format!("page {number} is compressed by {other:?}, none of LZW, deflate and PackBits"),
                    "write it without compression, or by one of these",
                ));
            }
        };
        Ok(Self { name, ratio })
    }
}

/// The decoder's error, sorted into unsupported files, damaged ones and failures of the operating system.
pub(super) fn damaged(report: Report, number: u64, error: TiffError) -> Error {
    match error {
        TiffError::UnsupportedError(error) => report.unsupported(
            Place::File,
            format!("page {number} cannot be read: {error}"),
            "convert it, for example by saving it as TIFF from ImageJ",
        ),
        TiffError::IoError(error)
            if !matches!(
                error.kind(),
                io::ErrorKind::InvalidData | io::ErrorKind::InvalidInput | io::ErrorKind::UnexpectedEof
            ) =>
        {
            report.unreadable(error)
        }
        error => report.invalid(
            Place::File,
            format!("page {number} is damaged: {error}"),
            "get the whole file, or write it anew",
        ),
    }
}

//! Compression around a whole file: gzip and zstd.

use std::io::{self, BufRead, Read};

use flate2::bufread::GzDecoder;
use ruzstd::decoding::errors::{FrameDecoderError, ReadFrameHeaderError};
use ruzstd::decoding::{BlockDecodingStrategy, FrameDecoder};

use crate::stream::DEFLATE_RATIO;

/// Compression around a whole file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Packing {
    /// No packing.
    Plain,
    /// Packing by gzip.
    Gzip,
    /// Packing by zstd.
    Zstd,
}

impl Packing {
    /// The packing of a file with these first bytes.
    pub(crate) fn of(head: &[u8]) -> Self {
        match head {
            [0x1f, 0x8b, ..] => Self::Gzip,
            // A frame, or one of the sixteen kinds of frames that are skipped.
            [0x28, 0xb5, 0x2f, 0xfd, ..] | [0x50..=0x5f, 0x2a, 0x4d, 0x18, ..] => Self::Zstd,
            _ => Self::Plain,
        }
    }

    /// Name for people: `raw`, `gzip` or `zstd`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "raw",
            Self::Gzip => "gzip",
            Self::Zstd => "zstd",
        }
    }

    /// The most bytes that one byte can unpack to.
    pub(crate) fn ratio(self) -> u64 {
        match self {
            Self::Plain => 1,
            Self::Gzip => DEFLATE_RATIO,
            // A block of one repeated byte takes 4 bytes and makes at most 128 KiB.
            Self::Zstd => 32 * 1024,
        }
    }

    /// The unpacked bytes of `file`.
    pub(crate) fn unpack<'a>(self, file: impl BufRead + 'a) -> Box<dyn Read + 'a> {
        match self {
            Self::Plain => Box::new(file),
            Self::Gzip => Box::new(Members::new(file)),
            Self::Zstd => Box::new(Frames::new(file)),
        }
    }

    /// A file's name without the extension of its packing, such as `.gz`.
    pub(crate) fn strip(self, name: &str) -> &str {
        let extensions: &[&str] = match self {
            Self::Plain => &[],
            Self::Gzip => &[".gz"],
            Self::Zstd => &[".zst", ".zstd"],
        };
        let fits = |extension: &&&str| {
            let start = name.len().checked_sub(extension.len());
            start.and_then(|start| name.get(start..)).is_some_and(|end| end.eq_ignore_ascii_case(extension))
        };
        extensions.iter().find(fits).map_or(name, |extension| &name[..name.len() - extension.len()])
    }
}

/// The content of gzip members one after the other. What follows them and is none, such as padding, is left unread, as gzip itself
/// leaves it.
pub(crate) struct Members<R> {
    decoder: Option<GzDecoder<R>>,
    /// Whether a member has ended before.
    later: bool,
    /// Whether the current one has given anything.
    begun: bool,
}

impl<R: BufRead> Members<R> {
    pub fn new(source: R) -> Self {
        Self { decoder: Some(GzDecoder::new(source)), later: false, begun: false }
    }
}

impl<R: BufRead> Read for Members<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        while let Some(decoder) = &mut self.decoder {
            match decoder.read(buffer) {
                Ok(0) if !buffer.is_empty() => {}
                Ok(count) => {
                    self.begun = true;
                    return Ok(count);
                }
                // It is no member, but padding that begins like one.
                Err(error) if self.later && !self.begun && error.kind() != io::ErrorKind::Interrupted => {
                    self.decoder = None;
                    continue;
                }
                Err(error) => return Err(error),
            }
            let Some(mut source) = self.decoder.take().map(GzDecoder::into_inner) else { break };
            if source.fill_buf()?.first() == Some(&0x1f) {
                self.decoder = Some(GzDecoder::new(source));
                (self.later, self.begun) = (true, false);
            }
        }
        Ok(0)
    }
}

/// The content of zstd frames one after the other, each held against its checksum.
struct Frames<R> {
    source: R,
    decoder: FrameDecoder,
    /// Whether a frame has begun that is not at its end yet.
    inside: bool,
}

impl<R: BufRead> Frames<R> {
    fn new(source: R) -> Self {
        // As much as zstd itself takes without being asked.
        const MOST_WINDOW: u64 = 1 << 27;
        let mut decoder = FrameDecoder::new();
        decoder.set_max_window_size(MOST_WINDOW);
        Self { source, decoder, inside: false }
    }

    /// Reads a frame's header, or skips a frame that holds no data.
    fn begin(&mut self) -> io::Result<()> {
        match self.decoder.reset(&mut self.source) {
            Ok(()) => self.inside = true,
            Err(FrameDecoderError::ReadFrameHeaderError(ReadFrameHeaderError::SkipFrame { length, .. })) => {
                io::copy(&mut self.source.by_ref().take(length.into()), &mut io::sink())?;
            }
            Err(error) => return Err(damaged(error)),
        }
        Ok(())
    }

    fn end(&mut self) -> io::Result<()> {
        self.inside = false;
        let stated = self.decoder.get_checksum_from_data();
        if stated.is_some() && stated != self.decoder.get_calculated_checksum() {
            return Err(damaged("the zstd checksum does not fit"));
        }
        Ok(())
    }
}

impl<R: BufRead> Read for Frames<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        loop {
            if !self.inside {
                if buffer.is_empty() || self.source.fill_buf()?.is_empty() {
                    return Ok(0);
                }
                self.begin()?;
            } else if self.decoder.can_collect() > 0 {
                return self.decoder.read(buffer);
            } else if self.decoder.is_finished() {
                self.end()?;
            } else {
                let one = BlockDecodingStrategy::UptoBlocks(1);
                self.decoder.decode_blocks(&mut self.source, one).map_err(damaged)?;
            }
        }
    }
}

fn damaged(error: impl std::fmt::Display) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, error.to_string())
}

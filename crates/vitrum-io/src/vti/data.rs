//! The two shells that may lie around an array's bytes: base64 characters, and blocks of zlib.

use std::io::{self, BufRead, Read, Take};

use flate2::bufread::ZlibDecoder;

/// Bytes written in base64, white space anywhere, up to the next markup.
///
/// VTK encodes a header and the data behind it one after the other, so padding may stand between.
pub(super) struct Base64Reader<R> {
    inner: R,
    decoded: Decoded,
    position: usize,
}

/// Bytes that characters made up, and the bits of those that do not yet.
#[derive(Default)]
struct Decoded {
    bytes: Vec<u8>,
    bits: u32,
    characters: u32,
}

impl Decoded {
    fn push(&mut self, character: u8) -> io::Result<()> {
        match value(character) {
            Some(value) => {
                self.bits = self.bits << 6 | value;
                self.characters += 1;
                if self.characters == 4 {
                    self.bytes.extend_from_slice(&self.bits.to_be_bytes()[1..]);
                    (self.bits, self.characters) = (0, 0);
                }
            }
            None if character == b'=' => self.close(),
            None if character.is_ascii_whitespace() => {}
            None => {
                let problem = format!("`{}` is not a base64 character", char::from(character).escape_debug());
                return Err(io::Error::new(io::ErrorKind::InvalidData, problem));
            }
        }
        Ok(())
    }

    /// The bytes of a group that padding or the end cuts short: one of two characters, two of three.
    fn close(&mut self) {
        let bytes = (self.bits << (24 - 6 * self.characters)).to_be_bytes();
        self.bytes.extend_from_slice(&bytes[1..(self.characters as usize).max(1)]);
        (self.bits, self.characters) = (0, 0);
    }
}

impl<R: BufRead> Base64Reader<R> {
    pub fn new(inner: R) -> Self {
        Self { inner, decoded: Decoded::default(), position: 0 }
    }

    /// Decodes one buffer of characters; `false` at the end.
    fn advance(&mut self) -> io::Result<bool> {
        let buffer = self.inner.fill_buf()?;
        let end = buffer.iter().position(|&byte| byte == b'<').unwrap_or(buffer.len());
        buffer[..end].iter().try_for_each(|&character| self.decoded.push(character))?;
        self.inner.consume(end);
        if end == 0 {
            self.decoded.close();
        }
        Ok(end > 0)
    }
}

fn value(byte: u8) -> Option<u32> {
    let value = match byte {
        b'A'..=b'Z' => byte - b'A',
        b'a'..=b'z' => byte - b'a' + 26,
        b'0'..=b'9' => byte - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        _ => return None,
    };
    Some(value.into())
}

impl<R: BufRead> BufRead for Base64Reader<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.position == self.decoded.bytes.len() {
            self.decoded.bytes.clear();
            self.position = 0;
            while self.decoded.bytes.is_empty() && self.advance()? {}
        }
        Ok(&self.decoded.bytes[self.position..])
    }

    fn consume(&mut self, count: usize) {
        self.position = (self.position + count).min(self.decoded.bytes.len());
    }
}

impl<R: BufRead> Read for Base64Reader<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}

/// One block of compressed data: its bytes in the file, and those it inflates to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block {
    pub compressed: u64,
    pub inflated: u64,
}

/// The inflated bytes of blocks that lie one after the other.
pub(super) struct BlockReader<R> {
    /// The bytes behind the block that is read, once that is done.
    idle: Option<R>,
    decoder: Option<ZlibDecoder<Take<R>>>,
    blocks: std::vec::IntoIter<Block>,
    /// Bytes that the current block still has to give.
    left: u64,
}

impl<R: BufRead> BlockReader<R> {
    pub fn new(inner: R, blocks: Vec<Block>) -> Self {
        Self { idle: Some(inner), decoder: None, blocks: blocks.into_iter(), left: 0 }
    }

    /// Checks that a block ends where it should, which also checks its checksum.
    fn finish_block(&mut self) -> io::Result<()> {
        let Some(mut decoder) = self.decoder.take() else { return Ok(()) };
        if decoder.read(&mut [0])? > 0 {
            return Err(invalid("a block inflates to more than its header promises"));
        }
        let mut rest = decoder.into_inner();
        io::copy(&mut rest, &mut io::sink())?;
        self.idle = Some(rest.into_inner());
        Ok(())
    }
}

impl<R: BufRead> Read for BlockReader<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        while self.left == 0 {
            self.finish_block()?;
            let (Some(block), Some(inner)) = (self.blocks.next(), self.idle.take()) else { return Ok(0) };
            self.decoder = Some(ZlibDecoder::new(inner.take(block.compressed)));
            self.left = block.inflated;
        }
        let Some(decoder) = &mut self.decoder else { return Ok(0) };
        let most = buffer.len().min(usize::try_from(self.left).unwrap_or(usize::MAX));
        let count = decoder.read(&mut buffer[..most])?;
        if count == 0 && most > 0 {
            return Err(invalid("a block inflates to less than its header promises"));
        }
        self.left -= count as u64;
        Ok(count)
    }
}

fn invalid(problem: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, problem)
}

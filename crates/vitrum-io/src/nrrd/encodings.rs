//! The NRRD encoding in hexadecimal digits.

use std::io::{self, BufRead, Read};

/// Two hexadecimal digits a byte, white space anywhere.
pub(super) struct HexReader<R> {
    inner: io::Bytes<R>,
    /// Characters read, for messages.
    position: u64,
}

impl<R: BufRead> HexReader<R> {
    pub fn new(reader: R) -> Self {
        Self { inner: reader.bytes(), position: 0 }
    }

    /// The next digit's value; `None` at the end.
    fn digit(&mut self) -> io::Result<Option<u8>> {
        for byte in self.inner.by_ref() {
            let character = char::from(byte?);
            self.position += 1;
            if let Some(value) = character.to_digit(16) {
                return Ok(Some(value as u8));
            }
            if !character.is_ascii_whitespace() {
                let problem = format!(
                    "character {} of the data, `{}`, is not a hexadecimal digit",
                    self.position,
                    character.escape_debug()
                );
                return Err(io::Error::new(io::ErrorKind::InvalidData, problem));
            }
        }
        Ok(None)
    }
}

impl<R: BufRead> Read for HexReader<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        for (index, byte) in buffer.iter_mut().enumerate() {
            let Some(high) = self.digit()? else { return Ok(index) };
            // A digit alone at the end is half a byte, and counts as none.
            let Some(low) = self.digit()? else { return Ok(index) };
            *byte = 16 * high + low;
        }
        Ok(buffer.len())
    }
}

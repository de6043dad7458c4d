//! The two NRRD encodings that are written in characters: hex and text.

use std::io::{self, BufRead, Read};

use crate::error::{Error, Place, Report, clip};
use crate::samples::VoxelBuffer;

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

/// Fails where `available` bytes cannot hold `count` numbers: a digit each, and separators between.
pub(crate) fn check_text_length(report: Report, count: u64, start: u64, available: u64) -> Result<(), Error> {
    if available < 2 * count - 1 {
        return Err(report.invalid(
            Place::Byte(start),
            format!("the header promises {count} numbers from here, and {available} bytes are there"),
            "correct the sizes in the header, or get the whole file",
        ));
    }
    Ok(())
}

/// Decodes `count` decimal numbers, separated by white space or commas.
pub(crate) fn read_text(
    report: Report,
    voxels: &mut VoxelBuffer,
    reader: &mut impl BufRead,
    count: usize,
    sample_name: &str,
) -> Result<(), Error> {
    for index in 0..count {
        let Some(word) = next_word(reader).map_err(|error| report.unreadable(error))? else {
            return Err(report.invalid(
                Place::File,
                format!("the header promises {count} numbers, {index} were found"),
                "correct the sizes in the header, or get the whole file",
            ));
        };
        voxels.append_text(&word).ok_or_else(|| {
            report.invalid(
                Place::File,
                format!("number {} of the data, `{}`, is not a {sample_name}", index + 1, clip(&word)),
                "correct it, or the type in the header",
            )
        })?;
    }
    match next_word(reader).map_err(|error| report.unreadable(error))? {
        None => Ok(()),
        Some(word) => Err(report.invalid(
            Place::File,
            format!("`{}` follows the {count} numbers that the header promises", clip(&word)),
            "correct the sizes in the header",
        )),
    }
}

/// The next word; `None` at the end. Cut off behind 64 bytes: no number is longer.
fn next_word(reader: &mut impl BufRead) -> io::Result<Option<String>> {
    const LONGEST: usize = 64;
    let mut word = Vec::new();
    loop {
        let buffer = match reader.fill_buf() {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            other => other?,
        };
        let Some(&byte) = buffer.first() else { break };
        let separates = byte.is_ascii_whitespace() || byte == b',';
        if separates && !word.is_empty() || word.len() >= LONGEST {
            break;
        }
        if !separates {
            word.push(byte);
        }
        reader.consume(1);
    }
    Ok((!word.is_empty()).then(|| String::from_utf8_lossy(&word).into_owned()))
}

//! Storage of a file's bytes: on the disk or in memory.

use std::borrow::Cow;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Cursor, Read, Seek, SeekFrom};
use std::path::Path;

/// The place of a file's bytes.
#[derive(Debug, Clone)]
pub(crate) enum Storage<'a> {
    Disk(Cow<'a, Path>),
    Memory(&'a [u8]),
}

impl<'a> Storage<'a> {
    /// The bytes from the first on.
    pub fn open(&self) -> io::Result<ByteReader<'a>> {
        match self {
            Self::Disk(path) => Ok(ByteReader::Disk(BufReader::new(File::open(path)?))),
            Self::Memory(bytes) => Ok(ByteReader::Memory(Cursor::new(bytes))),
        }
    }

    /// Count of the bytes.
    pub fn length(&self) -> io::Result<u64> {
        match self {
            Self::Disk(path) => Ok(fs::metadata(path)?.len()),
            Self::Memory(bytes) => Ok(bytes.len() as u64),
        }
    }
}

/// A position in a file's bytes.
#[derive(Debug)]
pub(crate) enum ByteReader<'a> {
    Disk(BufReader<File>),
    Memory(Cursor<&'a [u8]>),
}

impl Read for ByteReader<'_> {
    #[inline]
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self {
            Self::Disk(reader) => reader.read(buffer),
            Self::Memory(reader) => reader.read(buffer),
        }
    }
}

impl BufRead for ByteReader<'_> {
    #[inline]
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        match self {
            Self::Disk(reader) => reader.fill_buf(),
            Self::Memory(reader) => reader.fill_buf(),
        }
    }

    #[inline]
    fn consume(&mut self, amount: usize) {
        match self {
            Self::Disk(reader) => reader.consume(amount),
            Self::Memory(reader) => reader.consume(amount),
        }
    }
}

impl Seek for ByteReader<'_> {
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        match self {
            Self::Disk(reader) => reader.seek(position),
            Self::Memory(reader) => reader.seek(position),
        }
    }

    fn seek_relative(&mut self, offset: i64) -> io::Result<()> {
        match self {
            // Within its buffer, where that holds the position.
            Self::Disk(reader) => reader.seek_relative(offset),
            Self::Memory(reader) => reader.seek_relative(offset),
        }
    }

    fn stream_position(&mut self) -> io::Result<u64> {
        match self {
            Self::Disk(reader) => reader.stream_position(),
            Self::Memory(reader) => reader.stream_position(),
        }
    }
}

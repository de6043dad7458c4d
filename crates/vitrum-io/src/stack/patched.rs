//! TIFF files of kinds that the decoder refuses, though their samples are written as any others': tags are exchanged on the way to it.
//!
//! Values of a palette, and those of which 0 is white, come as they are: a table of colours changes no value. Tiles that are named by
//! the tags of strips come by their own.

use std::collections::BTreeMap;
use std::io::{self, Read, Seek, SeekFrom};

use crate::samples::read_up_to;

/// More pages than this are no stack.
const MOST_PAGES: usize = 1 << 20;
/// A directory has some dozens of entries.
const MOST_ENTRIES: u64 = 1 << 12;

const PHOTOMETRIC: u16 = 262;
const STRIP_OFFSETS: u16 = 273;
const STRIP_BYTE_COUNTS: u16 = 279;
const TILE_WIDTH: u16 = 322;
const TILE_OFFSETS: u16 = 324;
const TILE_BYTE_COUNTS: u16 = 325;

/// A file with other bytes at some places.
#[derive(Debug)]
pub(super) struct Patched<R> {
    inner: R,
    position: u64,
    patches: BTreeMap<u64, u8>,
    /// Whether the values of the first page are indices of colours.
    pub palette: bool,
    /// Whether the file says that 0 is white.
    pub white_is_zero: bool,
}

impl<R: Read + Seek> Patched<R> {
    /// Looks at all directories, as far as they can be read: the decoder tells what is wrong with others.
    pub fn new(inner: R) -> io::Result<Self> {
        let mut file = Self { inner, position: 0, patches: BTreeMap::new(), palette: false, white_is_zero: false };
        file.scan()?;
        file.seek(SeekFrom::Start(0))?;
        Ok(file)
    }

    fn scan(&mut self) -> io::Result<()> {
        let Some(head) = self.bytes::<16>(0, 8)? else { return Ok(()) };
        let order = Order { big: head.starts_with(b"MM"), wide: order_of(&head, 2) == 43 };
        let mut next = if order.wide { order.number(&head[8..16]) } else { order.number(&head[4..8]) };
        let mut seen = std::collections::HashSet::new();
        while next != 0 && seen.len() < MOST_PAGES && seen.insert(next) {
            match self.directory(order, next, seen.len() == 1)? {
                Some(after) => next = after,
                None => break,
            }
        }
        Ok(())
    }

    /// Takes in a directory; the place of the next one.
    fn directory(&mut self, order: Order, start: u64, first: bool) -> io::Result<Option<u64>> {
        let (count_size, entry_size, value) = if order.wide { (8, 20, 12) } else { (2, 12, 8) };
        let Some(count) = self.bytes::<8>(start, count_size)? else { return Ok(None) };
        let count = order.number(&count[..count_size]);
        if count > MOST_ENTRIES {
            return Ok(None);
        }
        let mut places = BTreeMap::new();
        for index in 0..count {
            let at = start + count_size as u64 + entry_size * index;
            let Some(entry) = self.bytes::<20>(at, entry_size as usize)? else { return Ok(None) };
            let tag = order.number(&entry[..2]) as u16;
            places.insert(tag, at);
            if tag == PHOTOMETRIC && order.number(&entry[2..4]) == 3 {
                let kind = order.number(&entry[value..value + 2]);
                if first {
                    (self.palette, self.white_is_zero) = (kind == 3, kind == 0);
                }
                if kind == 0 || kind == 3 {
                    self.patch(order, at + value as u64, 1);
                }
            }
        }
        if let (Some(_), Some(&offsets), Some(&counts), None) = (
            places.get(&TILE_WIDTH),
            places.get(&STRIP_OFFSETS),
            places.get(&STRIP_BYTE_COUNTS),
            places.get(&TILE_OFFSETS),
        ) {
            self.patch(order, offsets, TILE_OFFSETS);
            self.patch(order, counts, TILE_BYTE_COUNTS);
        }
        let size = if order.wide { 8 } else { 4 };
        let next = self.bytes::<8>(start + count_size as u64 + entry_size * count, size)?;
        Ok(next.map(|next| order.number(&next[..size])))
    }

    fn patch(&mut self, order: Order, at: u64, word: u16) {
        let bytes = if order.big { word.to_be_bytes() } else { word.to_le_bytes() };
        self.patches.extend([(at, bytes[0]), (at.saturating_add(1), bytes[1])]);
    }

    /// At most `SIZE` bytes from a place on; `None` where fewer than `least` are there.
    fn bytes<const SIZE: usize>(&mut self, at: u64, least: usize) -> io::Result<Option<[u8; SIZE]>> {
        let mut bytes = [0; SIZE];
        // Beyond what a file may have, seeking fails.
        if at > i64::MAX as u64 || self.inner.seek(SeekFrom::Start(at)).is_err() {
            return Ok(None);
        }
        let (count, outcome) = read_up_to(&mut self.inner, &mut bytes);
        outcome?;
        Ok((count >= least).then_some(bytes))
    }
}

/// Coding of numbers.
#[derive(Clone, Copy)]
struct Order {
    big: bool,
    /// Whether it is a BigTIFF.
    wide: bool,
}

impl Order {
    fn number(self, bytes: &[u8]) -> u64 {
        let join = |number: u64, byte: &u8| number << 8 | u64::from(*byte);
        if self.big { bytes.iter().fold(0, join) } else { bytes.iter().rev().fold(0, join) }
    }
}

fn order_of(head: &[u8], at: usize) -> u64 {
    Order { big: head.starts_with(b"MM"), wide: false }.number(&head[at..at + 2])
}

impl<R: Read> Read for Patched<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        let end = self.position + count as u64;
        for (&at, &byte) in self.patches.range(self.position..end) {
            buffer[(at - self.position) as usize] = byte;
        }
        self.position = end;
        Ok(count)
    }
}

impl<R: Seek> Seek for Patched<R> {
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        self.position = self.inner.seek(position)?;
        Ok(self.position)
    }
}

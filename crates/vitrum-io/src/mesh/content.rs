//! The content of a mesh file, and the memory that its bytes and the mesh may still take.

use std::io::{self, Read};

use crate::error::{Error, Place, Report};
use crate::input::Input;
use crate::memory;
use crate::options::OpenOptions;
use crate::packing::Packing;

/// A budget of memory: counts the bytes allocated for a file against its limit.
#[derive(Debug, Clone)]
pub(super) struct Budget<'a> {
    report: Report<'a>,
    limit: u64,
    advice: &'static str,
    used: u64,
}

impl<'a> Budget<'a> {
    pub fn new(report: Report<'a>, options: &OpenOptions) -> Self {
        let (limit, advice) = match options.max_bytes {
            Some(limit) => (limit, "raise the limit, or decimate the mesh first"),
            None => (memory::available(), "that is the memory available now: free some, or decimate the mesh first"),
        };
        Self { report, limit, advice, used: 0 }
    }

    /// Fails where so many more bytes would not fit.
    pub fn check(&self, bytes: u64) -> Result<(), Error> {
        let needed = self.used.saturating_add(bytes);
        if needed > self.limit { Err(self.report.too_large(needed, self.limit, self.advice)) } else { Ok(()) }
    }

    /// Counts so many more bytes, or fails.
    pub fn take(&mut self, bytes: u64) -> Result<(), Error> {
        self.check(bytes)?;
        self.used += bytes;
        Ok(())
    }

    /// An empty vector with room for `count` elements, which are counted.
    pub fn reserve<T>(&mut self, count: u64) -> Result<Vec<T>, Error> {
        self.take(count.saturating_mul(size_of::<T>() as u64))?;
        memory::reserve(self.report, usize::try_from(count).unwrap_or(usize::MAX))
    }

    /// Appends and counts one element.
    pub fn push<T>(&mut self, vector: &mut Vec<T>, value: T) -> Result<(), Error> {
        self.take(size_of::<T>() as u64)?;
        if vector.len() == vector.capacity() {
            let more = vector.len().max(1024);
            vector.try_reserve(more).map_err(|_| {
                let needed = (vector.len() + more) as u64 * size_of::<T>() as u64;
                self.report.too_large(needed, memory::available(), "the system refused the memory: free some first")
            })?;
        }
        vector.push(value);
        Ok(())
    }
}

/// The whole file, unpacked.
pub(super) fn read(input: &Input, budget: &mut Budget) -> Result<Vec<u8>, Error> {
    let report = budget.report;
    if input.packing == Packing::Plain {
        let mut bytes = budget.reserve(input.length)?;
        input.open()?.take(input.length).read_to_end(&mut bytes).map_err(|error| report.unreadable(error))?;
        return Ok(bytes);
    }
    let mut decoder = input.unpacked()?;
    let mut bytes = Vec::new();
    let mut chunk = [0; 1 << 16];
    loop {
        match decoder.read(&mut chunk) {
            Ok(0) => return Ok(bytes),
            Ok(count) => {
                budget.take(count as u64)?;
                bytes.try_reserve(count).map_err(|_| {
                    let needed = (bytes.len() + count) as u64;
                    report.too_large(needed, memory::available(), "the system refused the memory: free some first")
                })?;
                bytes.extend_from_slice(&chunk[..count]);
            }
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => {
                let problem = format!("the compressed data is damaged after {} bytes: {error}", bytes.len());
                return Err(report.invalid(Place::File, problem, "get the file again, or compress it anew"));
            }
        }
    }
}

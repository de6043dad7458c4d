//! Blocks of samples that lie in one file, one behind the other.

use std::fs::File;
use std::io;
use std::path::Path;

use super::{Contiguous, VoxelSource};
use crate::error::{Error, Report};
use crate::samples::{Endian, SampleType, VoxelBuffer};
use crate::voxels::Voxels;

/// An open file, and where its samples lie.
#[derive(Debug)]
pub(super) struct FileSource {
    file: Positioned,
    name: String,
    start: u64,
    dimensions: [u32; 3],
    sample: SampleType,
    endian: Endian,
}

impl FileSource {
    pub fn open(report: Report, path: &Path, data: &Contiguous) -> Result<Self, Error> {
        let file = File::open(path).map_err(|error| report.unreadable(error))?;
        let &Contiguous { start, dimensions, sample, endian, .. } = data;
        Ok(Self { file: Positioned::new(file), name: report.file.to_owned(), start, dimensions, sample, endian })
    }
}

impl VoxelSource for FileSource {
    fn read(&self, low: [u32; 3], size: [u32; 3]) -> Result<Voxels, Error> {
        let report = Report::new(&self.name);
        let [width, height, _] = self.dimensions.map(u64::from);
        let bytes = self.sample.size() as u64;
        let count = size.map(|n| n as usize).iter().product();
        let mut voxels = VoxelBuffer::reserve(report, self.sample, self.endian, count)?;
        // Rows that follow one another in the file are read together.
        let whole = size[0] == self.dimensions[0];
        let together = if whole { size[1].max(1) } else { 1 };
        let mut run = vec![0_u8; size[0] as usize * together as usize * self.sample.size()];
        for z in low[2]..low[2] + size[2] {
            for y in (low[1]..low[1] + size[1]).step_by(together as usize) {
                let first = (u64::from(z) * height + u64::from(y)) * width + u64::from(low[0]);
                let at = self.start + first * bytes;
                self.file.read(&mut run, at).map_err(|error| report.unreadable(error))?;
                voxels.decode(&run, self.endian);
            }
        }
        Ok(voxels.into_voxels().voxels)
    }
}

/// A file that is read at positions by several threads.
#[cfg(unix)]
#[derive(Debug)]
struct Positioned(File);

#[cfg(unix)]
impl Positioned {
    fn new(file: File) -> Self {
        Self(file)
    }

    fn read(&self, to: &mut [u8], at: u64) -> io::Result<()> {
        std::os::unix::fs::FileExt::read_exact_at(&self.0, to, at)
    }
}

/// A file that is read at positions by one thread after the other, where the system has no positioned reads.
#[cfg(not(unix))]
#[derive(Debug)]
struct Positioned(std::sync::Mutex<File>);

#[cfg(not(unix))]
impl Positioned {
    fn new(file: File) -> Self {
        Self(std::sync::Mutex::new(file))
    }

    fn read(&self, to: &mut [u8], at: u64) -> io::Result<()> {
        use std::io::{Read, Seek, SeekFrom};
        let mut file = self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        file.seek(SeekFrom::Start(at))?;
        file.read_exact(to)
    }
}

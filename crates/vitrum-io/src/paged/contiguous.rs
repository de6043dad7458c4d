//! Samples that lie in one file, one behind the other, and may stay there.

use super::Paged;
use super::file::FileSource;
use crate::error::{Error, Place, Report};
use crate::memory;
use crate::options::OpenOptions;
use crate::samples::{Endian, SampleType};
use crate::storage::Storage;
use crate::stored::Stored;
use std::sync::Arc;

/// The least limit on memory for which a file opens paged by itself: overview and ranges have to fit, too.
const LEAST_LIMIT: u64 = 64 << 20;

/// The edge of a page of a renderer, in voxels, and the most pages of a volume, which are counted by 32 bits and need a few words each.
const PAGE: u64 = 16;
const MOST_PAGES: u64 = 1 << 27;

/// The samples of a volume that lie in one file, one behind the other.
pub(crate) struct Contiguous<'a> {
    pub storage: Storage<'a>,
    /// The file's name, for messages.
    pub name: &'a str,
    /// The byte of the first sample.
    pub start: u64,
    pub dimensions: [u32; 3],
    pub sample: SampleType,
    pub endian: Endian,
}

impl Contiguous<'_> {
    /// The voxels as they stay in the file, where `options` ask for that or they need more memory than there is; `None` if they are
    /// to be read, or the bytes are not on a disk.
    pub fn open(self, options: &OpenOptions) -> Result<Option<Stored>, Error> {
        let Storage::Disk(path) = &self.storage else { return Ok(None) };
        let count = |n: u32| u64::from(n);
        let voxels = self.dimensions.map(count).iter().try_fold(1_u64, |all, &n| all.checked_mul(n));
        let needed = voxels.and_then(|n| n.checked_mul(self.sample.stored_size() as u64)).unwrap_or(u64::MAX);
        let limit = || options.max_bytes.unwrap_or_else(memory::available);
        let exceeds = || (limit() >= LEAST_LIMIT) && needed > limit();
        if !options.paged && !exceeds() {
            return Ok(None);
        }
        let report = Report::new(self.name);
        let pages = self.dimensions.iter().map(|&n| u64::from(n) / PAGE + 1);
        if pages.into_iter().try_fold(1_u64, u64::checked_mul).is_none_or(|pages| pages > MOST_PAGES) {
            let problem = format!("the volume has more than {MOST_PAGES} pages of {PAGE}³ voxels");
            return Err(report.unsupported(Place::File, problem, "crop or downsample the data first"));
        }
        let source = FileSource::open(report, path, &self)?;
        let (voxels, paged) = Paged::new(report, Arc::new(source), self.dimensions)?;
        Ok(Some(Stored { voxels, colors: None, paged: Some(Arc::new(paged)) }))
    }
}

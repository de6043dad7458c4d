//! Volumes larger than memory: their voxels stay in a file, of which blocks are read when they are needed.

mod file;
mod scan;

use std::sync::{Arc, Mutex, PoisonError};

use crate::error::{Error, Place, Report};
use crate::memory;
use crate::options::OpenOptions;
use crate::samples::{Endian, SampleType};
use crate::shared::Shared;
use crate::storage::Storage;
use crate::stored::Stored;
use crate::volume::Volume;
use crate::voxels::Voxels;

/// log₂ of the edge of a brick, in voxels, for volumes of at most [`MOST_BRICKS`] such bricks.
const FINEST_BRICK: u32 = 2;

/// Largest number of bricks of a volume, a word each. Larger volumes have larger bricks, so that the words take less than a tenth of
/// the voxels' memory.
const MOST_BRICKS: u64 = 1 << 23;

/// The most voxels of an overview.
const MOST_OF_OVERVIEW: u64 = 1 << 21;

/// The least limit on memory for which a file opens paged by itself: overview and ranges have to fit, too.
const LEAST_LIMIT: u64 = 64 << 20;

/// The edge of a page of a renderer, in voxels, and the most pages of a volume, which are counted by 32 bits and need a few words each.
const PAGE: u64 = 16;
const MOST_PAGES: u64 = 1 << 27;

/// log₂ of the edge of a volume's bricks, of each of which the least and the greatest value are known.
#[must_use]
pub fn brick_shift(dimensions: [u32; 3]) -> u32 {
    let count = |shift: u32| dimensions.iter().map(|n| u64::from(n.div_ceil(1 << shift))).product::<u64>();
    (FINEST_BRICK..31).find(|&shift| count(shift) <= MOST_BRICKS).unwrap_or(31)
}

/// A source of voxels that are read block by block, such as a file. Several threads read at once.
pub trait VoxelSource: Send + Sync + std::fmt::Debug {
    /// The voxels of a block, x fastest: `size` of them along each axis from `low` on, all inside the grid, and always of the same type.
    ///
    /// # Errors
    ///
    /// [`Error::Unreadable`] where the source gives no voxels.
    fn read(&self, low: [u32; 3], size: [u32; 3]) -> Result<Voxels, Error>;
}

/// The least and the greatest stored value of each brick, x fastest; [`brick_shift`] tells the bricks' edge.
#[derive(Debug, Clone, PartialEq)]
pub enum BrickRanges {
    /// Of [`Voxels::U8`].
    U8(Vec<(u8, u8)>),
    /// Of [`Voxels::U16`].
    U16(Vec<(u16, u16)>),
    /// Of [`Voxels::F32`].
    F32(Vec<(f32, f32)>),
}

/// The voxels of a volume that stay in their source. The volume's own voxels are those of its overview: every few of them along each axis.
#[derive(Debug)]
pub struct Paged {
    source: Arc<dyn VoxelSource>,
    /// The ranges of all bricks.
    pub ranges: BrickRanges,
    /// The least and the greatest stored value.
    pub(crate) extremes: [f32; 2],
    /// Voxels from one of the overview to the next, along each axis.
    stride: u32,
    /// The first failure of a read that nobody has been told of.
    failure: Mutex<Option<Error>>,
}

/// The same source, not an equal one: voxels are not compared.
impl PartialEq for Paged {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Paged {
    /// Reads all of a source once, for the ranges and the overview; the voxels of this and it.
    fn new(report: Report, source: Arc<dyn VoxelSource>, dimensions: [u32; 3]) -> Result<(Voxels, Self), Error> {
        let count = |stride: u32| dimensions.iter().map(|n| u64::from(n.div_ceil(stride))).product::<u64>();
        let stride = (1..u32::MAX).find(|&stride| count(stride) <= MOST_OF_OVERVIEW).unwrap_or(u32::MAX);
        let (overview, ranges, extremes) = scan::scan(report, &*source, dimensions, stride)?;
        Ok((overview, Self { source, ranges, extremes, stride, failure: Mutex::default() }))
    }

    /// As [`VoxelSource::read`]; `None` where that fails, which [`Self::take_failure`] tells.
    #[must_use]
    pub fn read(&self, low: [u32; 3], size: [u32; 3]) -> Option<Voxels> {
        let failed = |error| {
            self.failure.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
        };
        self.source.read(low, size).map_err(failed).ok()
    }

    /// The first failure since the last call.
    pub fn take_failure(&self) -> Option<Error> {
        self.failure.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

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
        let source = file::FileSource::open(report, path, &self)?;
        let (voxels, paged) = Paged::new(report, Arc::new(source), self.dimensions)?;
        Ok(Some(Stored { voxels, colors: None, paged: Some(Arc::new(paged)) }))
    }
}

impl Volume {
    /// The number of the grid's voxels, wherever they are.
    #[must_use]
    pub fn grid_count(&self) -> u64 {
        self.dimensions.into_iter().map(u64::from).product()
    }

    /// The physical value at a voxel that is read from the file; NaN where that fails.
    pub(crate) fn paged_value(&self, at: [u32; 3]) -> f32 {
        let at = [0, 1, 2].map(|axis| at[axis].min(self.dimensions[axis].saturating_sub(1)));
        let read = self.paged.as_ref().and_then(|paged| paged.read(at, [1; 3]));
        let stored = read.and_then(|voxels| voxels.stored(0));
        stored.map_or(f32::NAN, |stored| stored * self.value_scale + self.value_offset)
    }

    /// The volume as it is, or where its voxels stay in a file, its overview: every few voxels along each axis, all in memory, on a grid of
    /// its own with the same first voxel.
    #[must_use]
    pub fn overview(&self) -> Self {
        let Some(paged) = &self.paged else { return self.clone() };
        let stride = paged.stride;
        Self {
            dimensions: self.dimensions.map(|n| n.div_ceil(stride)),
            spacing: self.spacing.map(|spacing| spacing * stride as f32),
            paged: None,
            ..self.clone()
        }
    }

    /// Fails where the voxels stay in a file: `what` needs all of them in memory.
    ///
    /// # Errors
    ///
    /// [`Error::Unsupported`] of a paged volume.
    pub fn require_whole(&self, what: &str) -> Result<(), Error> {
        if self.paged.is_none() {
            return Ok(());
        }
        Err(Report::new(&self.name).unsupported(
            Place::File,
            format!("{what} needs all voxels in memory, and they stay in the file"),
            "leave that out, allow more memory, or crop or downsample the data first",
        ))
    }
}

/// Voxels of one type, as they are in [`Voxels`].
pub(crate) trait Stores: bytemuck::Pod + PartialOrd + Into<f32> + Send + Sync {
    fn of(voxels: &Voxels) -> Option<&Shared<Self>>;
    fn ranges(ranges: Vec<(Self, Self)>) -> BrickRanges;
}

macro_rules! stores {
    ($($number:ty: $variant:ident),*) => {$(
        impl Stores for $number {
            fn of(voxels: &Voxels) -> Option<&Shared<Self>> {
                if let Voxels::$variant(voxels) = voxels { Some(voxels) } else { None }
            }

            fn ranges(ranges: Vec<(Self, Self)>) -> BrickRanges {
                BrickRanges::$variant(ranges)
            }
        }
    )*};
}

stores!(u8: U8, u16: U16, f32: F32);

//! Volumes larger than memory: their voxels stay in a file, of which blocks are read when they are needed.

mod contiguous;
mod file;
mod scan;
mod whole;

use std::sync::{Arc, Mutex, PoisonError};

use crate::error::{Error, Report};
use crate::shared::Shared;
use crate::voxels::Voxels;

pub(crate) use contiguous::Contiguous;

/// log₂ of the edge of a brick, in voxels, for volumes of at most [`MOST_BRICKS`] such bricks.
const FINEST_BRICK: u32 = 2;

/// Largest number of bricks of a volume, a word each. Larger volumes have larger bricks, so that the words take less than a tenth of
/// the voxels' memory.
const MOST_BRICKS: u64 = 1 << 23;

/// The most voxels of an overview.
const MOST_OF_OVERVIEW: u64 = 1 << 21;

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

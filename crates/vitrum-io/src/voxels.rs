//! The numbers of a volume, in the three types that the kernels take.

use crate::shared::Shared;
use std::ops::Deref;
use std::sync::Arc;

/// The stored voxels, x fastest, then y, then z. Clones share them.
#[derive(Debug, Clone, PartialEq)]
pub enum Voxels {
    /// Integers 0 to 255.
    U8(Shared<u8>),
    /// Integers 0 to 65535.
    U16(Shared<u16>),
    /// Finite floats.
    F32(Shared<f32>),
}

impl From<Vec<u8>> for Voxels {
    fn from(voxels: Vec<u8>) -> Self {
        Self::U8(voxels.into())
    }
}

impl From<Vec<u16>> for Voxels {
    fn from(voxels: Vec<u16>) -> Self {
        Self::U16(voxels.into())
    }
}

impl From<Vec<f32>> for Voxels {
    fn from(voxels: Vec<f32>) -> Self {
        Self::F32(voxels.into())
    }
}

/// The voxels as kernels read them: little-endian words, so many that four bytes can be read from each voxel on. Clones share
/// them, with the [`Voxels`] that they are of, too.
#[derive(Debug, Clone)]
pub struct Words(Backing);

#[derive(Debug, Clone)]
enum Backing {
    U8(Shared<u8>),
    U16(Shared<u16>),
    F32(Shared<f32>),
    Copied(Arc<Vec<u32>>),
}

impl Deref for Words {
    type Target = [u32];

    fn deref(&self) -> &[u32] {
        let words = match &self.0 {
            Backing::U8(voxels) => voxels.words(),
            Backing::U16(voxels) => voxels.words(),
            Backing::F32(voxels) => voxels.words(),
            Backing::Copied(words) => Some(words.as_slice()),
        };
        // `Voxels::words` copied those that have none, and what is held stays where it is.
        words.unwrap_or_default()
    }
}

impl Voxels {
    /// Count of the voxels.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::U8(voxels) => voxels.len(),
            Self::U16(voxels) => voxels.len(),
            Self::F32(voxels) => voxels.len(),
        }
    }

    /// Whether the volume has no voxels.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Bytes of memory that they take.
    #[must_use]
    pub fn bytes(&self) -> usize {
        match self {
            Self::U8(voxels) => size_of_val(&**voxels),
            Self::U16(voxels) => size_of_val(&**voxels),
            Self::F32(voxels) => size_of_val(&**voxels),
        }
    }

    /// The voxels' memory as words; a copy where the allocator put the voxels at an odd address.
    #[must_use]
    pub fn words(&self) -> Words {
        fn copied<T: bytemuck::Pod>(voxels: &[T]) -> Backing {
            let mut words = vec![0_u32; size_of_val(voxels).div_ceil(4) + 1];
            let bytes: &mut [u8] = bytemuck::cast_slice_mut(&mut words);
            bytes[..size_of_val(voxels)].copy_from_slice(bytemuck::cast_slice(voxels));
            Backing::Copied(Arc::new(words))
        }
        Words(match self {
            Self::U8(voxels) if voxels.words().is_some() => Backing::U8(voxels.clone()),
            Self::U16(voxels) if voxels.words().is_some() => Backing::U16(voxels.clone()),
            Self::F32(voxels) if voxels.words().is_some() => Backing::F32(voxels.clone()),
            Self::U8(voxels) => copied(voxels),
            Self::U16(voxels) => copied(voxels),
            Self::F32(voxels) => copied(voxels),
        })
    }

    /// The stored number at a linear index, neither scaled nor shifted.
    #[must_use]
    pub fn stored(&self, index: usize) -> Option<f32> {
        match self {
            Self::U8(voxels) => voxels.get(index).map(|&voxel| f32::from(voxel)),
            Self::U16(voxels) => voxels.get(index).map(|&voxel| f32::from(voxel)),
            Self::F32(voxels) => voxels.get(index).copied(),
        }
    }

    /// Smallest and largest stored number; `None` of none.
    pub(crate) fn extremes(&self) -> Option<[f32; 2]> {
        fn ends<T: Copy + Ord>(voxels: &[T]) -> Option<[T; 2]> {
            Some([*voxels.iter().min()?, *voxels.iter().max()?])
        }
        match self {
            Self::U8(voxels) => ends(voxels).map(|ends| ends.map(f32::from)),
            Self::U16(voxels) => ends(voxels).map(|ends| ends.map(f32::from)),
            Self::F32(voxels) => {
                let first = *voxels.first()?;
                Some(voxels.iter().fold([first; 2], |[low, high], &voxel| [low.min(voxel), high.max(voxel)]))
            }
        }
    }
}

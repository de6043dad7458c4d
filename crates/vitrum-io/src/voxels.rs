//! The numbers of a volume, in the three types that the kernels take.

/// The stored voxels, x fastest, then y, then z.
#[derive(Debug, Clone, PartialEq)]
pub enum Voxels {
    /// Integers 0 to 255.
    U8(Vec<u8>),
    /// Integers 0 to 65535.
    U16(Vec<u16>),
    /// Finite floats.
    F32(Vec<f32>),
}

impl Voxels {
    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::U8(voxels) => voxels.len(),
            Self::U16(voxels) => voxels.len(),
            Self::F32(voxels) => voxels.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Bytes of memory that they take.
    #[must_use]
    pub fn bytes(&self) -> usize {
        match self {
            Self::U8(voxels) => size_of_val(voxels.as_slice()),
            Self::U16(voxels) => size_of_val(voxels.as_slice()),
            Self::F32(voxels) => size_of_val(voxels.as_slice()),
        }
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

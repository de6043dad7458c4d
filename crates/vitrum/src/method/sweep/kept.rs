//! Which planes' irradiance is kept for the viewing rays.
//!
//! Rays go over several planes at once, once light has been carried over them: their records are then read and written once for all of
//! them, and a device runs them in one dispatch.

use crate::backend::START_ALIGNMENT;
use vitrum_kernels::abi::record::irradiance;

/// The most planes. With twice as many rays gain a twentieth on the CPU, and their irradiance takes as much memory as all of the light.
const MOST: u32 = 4;

/// The planes whose irradiance is in the buffer at the same time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Kept {
    pub(super) planes: u32,
    texels: u64,
}

impl Kept {
    /// As many planes of `size` light texels as are of use and fit a buffer of `largest` bytes.
    pub(super) fn new(size: [u32; 2], largest: u64) -> Self {
        let one = Self { planes: 1, texels: u64::from(size[0]) * u64::from(size[1]) };
        Self { planes: (largest / (one.words() * 4)).clamp(1, u64::from(MOST)) as u32, ..one }
    }

    /// One plane alone.
    pub(super) fn one(size: [u32; 2]) -> Self {
        Self::new(size, 0)
    }

    /// Words of a plane in the buffer.
    pub(super) fn words(self) -> u64 {
        (self.texels * irradiance::SIZE as u64).next_multiple_of(START_ALIGNMENT)
    }

    /// Where the records of plane `plane` start, in words.
    pub(super) fn start(self, plane: u32) -> u64 {
        u64::from(plane % self.planes) * self.words()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_follow_one_another_as_far_as_there_is_room() {
        let kept = Kept::new([10, 7], u64::MAX);
        assert_eq!((kept.planes, kept.words()), (MOST, 320));
        assert_eq!([0, 1, MOST - 1, MOST, MOST + 1].map(|plane| kept.start(plane)), [0, 320, 320 * 3, 0, 320]);
        let two = Kept::new([10, 7], 2 * 320 * 4 + 100);
        assert_eq!((two.planes, two.start(3)), (2, 320));
        assert_eq!(Kept::one([10, 7]).start(5), 0);
    }
}

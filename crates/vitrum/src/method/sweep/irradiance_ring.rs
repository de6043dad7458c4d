//! The ring buffer of the irradiance of the latest planes, which viewing rays read.
//!
//! Light is carried over several planes, and rays then go over all of them at once: a ray's record is read and written once for the
//! whole stretch, and a device runs the stretch in one dispatch.

use crate::backend::START_ALIGNMENT;
use vitrum_kernels::abi::record::irradiance;

/// The most planes in the ring. Twice as many would make rays faster by a twentieth on the CPU, and the ring as large as the buffers of light.
const MOST: u32 = 4;

/// The size of the ring: the number of planes whose irradiance it holds, and the light texels of a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct IrradianceRing {
    pub(super) planes: u32,
    texels: u64,
}

impl IrradianceRing {
    /// A ring of as many planes of `size` light texels as fit a buffer of `largest` bytes, 1 to [`MOST`].
    pub(super) fn new(size: [u32; 2], largest: u64) -> Self {
        let one = Self { planes: 1, texels: u64::from(size[0]) * u64::from(size[1]) };
        Self { planes: (largest / (one.words() * 4)).clamp(1, u64::from(MOST)) as u32, ..one }
    }

    /// A ring of one plane.
    pub(super) fn one(size: [u32; 2]) -> Self {
        Self::new(size, 0)
    }

    /// The distance between the starts of two planes in the buffer, in words.
    pub(super) fn words(self) -> u64 {
        (self.texels * irradiance::SIZE as u64).next_multiple_of(START_ALIGNMENT)
    }

    /// The offset of the records of plane `plane` in the buffer, in words.
    pub(super) fn start(self, plane: u32) -> u64 {
        u64::from(plane % self.planes) * self.words()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_follow_one_another_as_far_as_there_is_room() {
        let ring = IrradianceRing::new([10, 7], u64::MAX);
        assert_eq!((ring.planes, ring.words()), (MOST, 320));
        assert_eq!([0, 1, MOST - 1, MOST, MOST + 1].map(|plane| ring.start(plane)), [0, 320, 320 * 3, 0, 320]);
        let two = IrradianceRing::new([10, 7], 2 * 320 * 4 + 100);
        assert_eq!((two.planes, two.start(3)), (2, 320));
        assert_eq!(IrradianceRing::one([10, 7]).start(5), 0);
    }
}

//! The place of a triangle among the voxels, in integers, by which the host divides large triangles, too.

use crate::abi::voxelize::{VoxelizeUniforms, triangle};
use crate::field::access::read_inside;
use spirv_std::glam::{IVec3, Vec3};

/// Bits of a corner's coordinate: differences of two such numbers are exact floats.
const BITS: u32 = 22;

/// A triangle's corners, and the voxels that its box meets.
#[derive(Clone, Copy)]
pub struct Place {
    a: IVec3,
    b: IVec3,
    c: IVec3,
    /// The first voxel along x, y, z.
    pub first: IVec3,
    /// Index of the last voxel along x, y, z, counted from the first.
    pub last: IVec3,
    /// Margin by which voxels are enlarged, in units.
    margin: i32,
    /// log₂ of the units of a voxel.
    units: u32,
    /// log₂ of the units to multiples of which corners are rounded.
    coarser: u32,
}

/// The floor of log₂ of `x`, which must be above 0 and below 2³¹.
#[inline(always)]
fn magnitude(x: i32) -> u32 {
    // The upper bits alone, so that the conversion is exact on every device.
    let (upper, shift) = if x >> 16 != 0 { (x >> 16, 16) } else { (x, 0) };
    ((upper as f32).to_bits() >> 23) - 127 + shift
}

/// 2^`exponent`, which must be above −127 and below 128.
#[inline(always)]
fn power(exponent: i32) -> f32 {
    f32::from_bits(((127 + exponent) as u32) << 23)
}

/// The index of the voxel, out of `most`, in which `at` (in units) lies.
#[inline(always)]
fn voxel(at: i32, units: u32, most: i32) -> i32 {
    let voxel = at >> units;
    let voxel = if voxel > 0 { voxel } else { 0 };
    if voxel < most { voxel } else { most - 1 }
}

/// Extent of a triangle along its longest axis, in units.
#[inline(always)]
fn longest(a: IVec3, b: IVec3, c: IVec3) -> i32 {
    let size = a.max(b).max(c) - a.min(b).min(c);
    let longest = if size.x > size.y { size.x } else { size.y };
    if longest > size.z { longest } else { size.z }
}

/// Whether triangle `a`, `b`, `c` is small, seen at a glance; of those that are not, [`Place::is_small`] knows.
#[inline(always)]
pub fn is_tiny(u: &VoxelizeUniforms, a: IVec3, b: IVec3, c: IVec3) -> bool {
    // Then it meets five voxels along an axis at most: 25 rows.
    longest(a, b, c) + 2 * (u.margin as i32) < 3 << u.corner_units
}

impl Place {
    /// The place of triangle `a`, `b`, `c`, in units.
    #[inline(always)]
    pub fn new(u: &VoxelizeUniforms, a: IVec3, b: IVec3, c: IVec3) -> Self {
        let (units, overlap) = (u.corner_units, u.margin as i32);
        let low = a.min(b).min(c);
        let high = a.max(b).max(c);
        let extent = longest(a, b, c) + 2 * overlap + (2 << units);
        let coarser = if extent >> BITS != 0 { magnitude(extent) + 1 - BITS } else { 0 };
        // Corners are rounded twice, each time by half of what they become multiples of. What the arithmetic of `overlap` is off by
        // is less than 2⁻¹⁹ of the extent.
        let margin = overlap + 1 + ((1 << coarser) >> 1) + (extent >> 19) + 1;
        let (nx, ny, nz) = (u.size.x as i32, u.size.y as i32, u.size.z as i32);
        let first = IVec3::new(
            voxel(low.x - margin, units, nx),
            voxel(low.y - margin, units, ny),
            voxel(low.z - margin, units, nz),
        );
        let last = IVec3::new(
            voxel(high.x + margin, units, nx),
            voxel(high.y + margin, units, ny),
            voxel(high.z + margin, units, nz),
        );
        Self { a, b, c, first, last: last - first, margin, units, coarser }
    }

    /// The place of triangle number `index`, limited to the existing ones.
    #[inline(always)]
    pub fn of(u: &VoxelizeUniforms, corners: &[u32], index: i32) -> Self {
        let at = index * triangle::SIZE as i32;
        let last = corners.len() as i32 - triangle::SIZE as i32;
        let at = if at < last { at } else { last };
        if at < 0 {
            return Self::new(u, IVec3::ZERO, IVec3::ZERO, IVec3::ZERO);
        }
        // SAFETY: `at` is not below 0 and nine words from the end at most. Limits of their own for nine words were a fifth of the time
        // that triangles take that are smaller than a voxel.
        let c = |c: u32| unsafe { read_inside(corners, at, c) as i32 };
        Self::new(u, IVec3::new(c(0), c(1), c(2)), IVec3::new(c(3), c(4), c(5)), IVec3::new(c(6), c(7), c(8)))
    }

    /// Whether slices are layers along z; else along y. The longer of the two, so that a slice has few rows.
    #[inline(always)]
    pub fn slices_are_layers(&self) -> bool {
        self.last.z >= self.last.y
    }

    /// The number of slices of the box.
    #[inline(always)]
    pub fn slices(&self) -> i32 {
        1 + if self.slices_are_layers() { self.last.z } else { self.last.y }
    }

    /// The number of rows of a slice.
    #[inline(always)]
    pub fn rows(&self) -> i32 {
        1 + if self.slices_are_layers() { self.last.y } else { self.last.z }
    }

    /// Whether one invocation does the whole triangle.
    #[inline(always)]
    pub fn is_small(&self) -> bool {
        // Neither has more than 2¹⁴.
        self.slices() == 1 || self.slices() * self.rows() <= triangle::SMALL
    }

    /// Margin by which a voxel is enlarged on each side, in voxels.
    #[inline(always)]
    pub fn margin(&self) -> f32 {
        self.margin as f32 * power(-(self.units as i32))
    }

    /// The corners in voxels from the first one, multiples of a power of two with at most 22 bits.
    #[inline(always)]
    pub fn corners(&self) -> (Vec3, Vec3, Vec3) {
        let corner = |at: IVec3| {
            Vec3::new(self.along(at.x, self.first.x), self.along(at.y, self.first.y), self.along(at.z, self.first.z))
        };
        (corner(self.a), corner(self.b), corner(self.c))
    }

    /// A corner's coordinate in voxels from the first one.
    #[inline(always)]
    fn along(&self, at: i32, first: i32) -> f32 {
        let from_first = at - (first << self.units) + ((1 << self.coarser) >> 1);
        (from_first >> self.coarser) as f32 * power(self.coarser as i32 - self.units as i32)
    }
}

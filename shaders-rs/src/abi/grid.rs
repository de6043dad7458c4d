//! A grid of voxels.

use super::vector::Vec4;
use spirv_std::glam::IVec4;

/// Where a grid of voxels lies and how its values are stored.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Grid {
    /// Rows of the affine map from the sweep frame (world units) to voxel coordinates; voxel (0, 0, 0)'s centre is the origin.
    pub row_x: Vec4,
    /// See `row_x`.
    pub row_y: Vec4,
    /// See `row_x`.
    pub row_z: Vec4,
    /// Voxels along each axis (without padding); `w` is the farthest step, in voxels, over which a brick's range still holds.
    pub size: Vec4,
    /// Normalised scalar = stored · `x` + `y`, clamped to 0…1.
    pub value: Vec4,
    /// `x`: stored voxels in a row, `y`: in a slice, of the grid or of a page.
    pub pitch: IVec4,
    /// Bricks of the occupancy buffer along each axis; `w` is where this grid's start in the buffer.
    pub bricks: IVec4,
    /// Pages along each axis, where there are any; `w`: log₂ of a brick's edge in voxels.
    pub pages: IVec4,
}

/// How voxels are stored.
///
/// Where the volume lies in one piece it is as it came, x fastest, without padding. Where it does not fit the device, the buffer holds
/// a table with an entry for each [`page`], and then the pages that are needed now.
pub mod format {
    /// Four unsigned bytes a word.
    pub const U8: u32 = 0;
    /// Two unsigned 16-bit integers a word.
    pub const U16: u32 = 1;
    /// One float a word.
    pub const F32: u32 = 2;
    /// As [`F32`], with a second volume, also [`F32`], that gives the index of refraction.
    pub const F32_WITH_IOR: u32 = 3;
    /// As [`U8`], in pages.
    pub const U8_PAGED: u32 = 4;
    /// As [`U16`], in pages.
    pub const U16_PAGED: u32 = 5;
    /// As [`F32`], in pages.
    pub const F32_PAGED: u32 = 6;
    /// As [`F32_WITH_IOR`], both volumes in pages.
    pub const F32_WITH_IOR_PAGED: u32 = 7;

    /// The format in pages of voxels that would be stored as `whole` in one piece.
    #[must_use]
    pub const fn paged(whole: u32) -> u32 {
        match whole {
            U8 => U8_PAGED,
            U16 => U16_PAGED,
            F32 => F32_PAGED,
            _ => F32_WITH_IOR_PAGED,
        }
    }

    /// Bytes of a voxel.
    #[must_use]
    pub const fn bytes(format: u32) -> u64 {
        if is_u8(format) {
            1
        } else if is_u16(format) {
            2
        } else {
            4
        }
    }

    /// Whether voxels have 8 bits.
    #[must_use]
    #[inline(always)]
    pub const fn is_u8(format: u32) -> bool {
        (format == U8) | (format == U8_PAGED)
    }

    /// Whether voxels have 16 bits.
    #[must_use]
    #[inline(always)]
    pub const fn is_u16(format: u32) -> bool {
        (format == U16) | (format == U16_PAGED)
    }

    /// Whether voxels lie in pages.
    #[must_use]
    #[inline(always)]
    pub const fn is_paged(format: u32) -> bool {
        format >= U8_PAGED
    }
}

/// Cubes of voxels that come to the device and leave it as a whole.
///
/// Page (i, j, k) is for the cells (look-ups between voxel n and n + 1) from [`EDGE`](page::EDGE) · (i, j, k) − 1 on, and holds all
/// voxels that a stencil in one of them reads; what lies beyond the grid is filled with the nearest voxel. Its entry in the table,
/// x fastest, counts the voxels from the buffer's start to its first one.
pub mod page {
    /// log₂ of the cells along an edge.
    pub const SHIFT: i32 = 4;
    /// Cells along an edge.
    pub const EDGE: i32 = 1 << SHIFT;
    /// What of a cell's number is its place in a page.
    pub const MASK: i32 = EDGE - 1;
    /// Voxels before the first cell's: a stencil's reach.
    pub const BEFORE: i32 = 1;
    /// Voxels along an edge.
    pub const ROW: i32 = EDGE + 3;
    /// Voxels in a slice.
    pub const SLICE: i32 = ROW * ROW;
    /// Voxels from a page to the next: whole words of any format.
    pub const STRIDE: i32 = (SLICE * ROW + 3) / 4 * 4;
}

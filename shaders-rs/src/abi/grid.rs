//! A padded voxel grid.

use super::vector::Vec4;
use spirv_std::glam::IVec4;

/// Voxels of padding on every side, filled with the nearest voxel, so that a stencil never leaves the buffer.
pub const PADDING: i32 = 2;

/// log₂ of a brick's edge in voxels.
pub const BRICK_SHIFT: i32 = 2;

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
    /// `x`: stored voxels in a padded row, `y`: in a padded slice, `z`: index of voxel (0, 0, 0).
    pub pitch: IVec4,
    /// Bricks along each axis; `w` is where this grid's bricks start in the occupancy buffer.
    pub bricks: IVec4,
}

/// How voxels are stored.
pub mod format {
    /// Four unsigned bytes a word.
    pub const U8: u32 = 0;
    /// Two unsigned 16-bit integers a word.
    pub const U16: u32 = 1;
    /// One float a word.
    pub const F32: u32 = 2;
    /// As [`F32`], with a second volume, also [`F32`], that gives the index of refraction.
    pub const F32_WITH_IOR: u32 = 3;
}

//! A grid of voxels.

use super::vector::{Affine, Counts, Vec3};

/// Where a grid of voxels lies and how its values are stored.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Grid {
    /// Voxel coordinate x of a point of the view frame (world units); the centre of voxel (0, 0, 0) is the origin.
    pub row_x: Affine,
    /// Voxel coordinate y.
    pub row_y: Affine,
    /// Voxel coordinate z.
    pub row_z: Affine,
    /// Voxels along each axis (without padding).
    pub size: Vec3,
    /// The low corner of the box of what is there, in voxel coordinates: −½, or where the volume is cropped.
    pub low: Vec3,
    /// The high corner of that box: `size` − ½, or where the volume is cropped.
    pub high: Vec3,
    /// The farthest step, in voxels, over which a brick's range still holds.
    pub reach: f32,
    /// Normalised scalar = (stored − `value_origin`) · `value_scale`: from 0 to 1 the transfer functions change, beyond they are constant.
    pub value_scale: f32,
    /// See `value_scale`.
    pub value_origin: f32,
    /// Stored voxels in a row, of the grid or of a page.
    pub row_pitch: i32,
    /// Stored voxels in a slice, of the grid or of a page.
    pub slice_pitch: i32,
    /// Bricks of the occupancy buffer along each axis.
    pub bricks: Counts,
    /// Where this grid's bricks start in the occupancy buffer.
    pub first_brick: u32,
    /// Pages along each axis, where there are any.
    pub pages: Counts,
    /// log₂ of a brick's edge in voxels.
    pub brick_shift: u32,
    /// 1 if a point has the value of the voxel in which it lies, 0 if values are interpolated.
    pub nearest: u32,
}

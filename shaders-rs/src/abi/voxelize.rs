//! The uniform block of the voxelization kernels, and the buffers they read.

use super::Dispatched;
use super::dispatch::Dispatch;
use super::vector::Counts;

/// Uniforms of the kernels in [`crate::voxelize`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct VoxelizeUniforms {
    /// Size of the dispatch and mode (see [`mode`]).
    pub dispatch: Dispatch,
    /// Invocations that have work: items, or rows of voxels.
    pub work: u32,
    /// Voxels along each axis, or in a slab of layers along z.
    pub size: Counts,
    /// Words that a row of voxels takes in the buffer that is written.
    pub row_words: u32,
    /// log₂ of the columns through a voxel along y, and along z.
    pub column_shift: u32,
    /// The first layer along z that is worked on.
    pub first_layer: u32,
    /// log₂ of the units that a column has along a voxel.
    pub column_units: u32,
    /// log₂ of the units that a voxel has.
    pub voxel_units: u32,
    /// log₂ of the units that a voxel has in the corners of the surface's triangles.
    pub corner_units: u32,
    /// Units by which a voxel is enlarged on each side.
    pub margin: u32,
    /// The triangle from which items count.
    pub first_triangle: u32,
    /// Divergence of the columns (see [`crate::voxelize::columns::depth`]); 0 for parallel ones.
    pub divergence: f32,
}

impl Dispatched for VoxelizeUniforms {
    #[inline(always)]
    fn dispatch(&self) -> Dispatch {
        self.dispatch
    }
}

/// Pieces of work on the surface, for [`crate::voxelize::mark_surface`] and [`crate::voxelize::sum_attributes`].
pub mod pieces {
    /// A triangle, if it is small.
    pub const TRIANGLES: u32 = 0;
    /// An item: slices of a large triangle.
    pub const ITEMS: u32 = 1;
}

/// Which windings are inside, for [`crate::voxelize::fill_rows`].
pub mod mode {
    /// All but 0.
    pub const NONZERO: u32 = 0;
    /// The odd ones.
    pub const EVEN_ODD: u32 = 1;
}

/// A triangle of the surface: words next to each other, not planar. x, y and z of its first corner from the grid's low corner, then
/// those of the others, signed integers in units of a power of two of a voxel (see [`VoxelizeUniforms::corner_units`]).
pub mod triangle {
    /// Words.
    pub const SIZE: usize = 9;
    /// Rows of voxels in its box up to which a triangle is done by one invocation.
    pub const SMALL: i32 = 32;
}

/// Attributes of a triangle: floats next to each other, not planar.
pub mod brought {
    /// Floats.
    pub const SIZE: usize = 19;
    /// Normal of the first corner, x; y and z, then those of the other corners follow.
    pub const NORMALS: usize = 0;
    /// Linear colour of the first corner, 0 to 1: red; green and blue, then those of the other corners follow.
    pub const COLORS: usize = 9;
    /// Number of the material, counted from 1; 0 for none. Below 2²⁴.
    pub const MATERIAL: usize = 18;
}

/// A piece of work: words next to each other.
pub mod item {
    /// Words.
    pub const SIZE: usize = 3;
    /// The triangle.
    pub const TRIANGLE: usize = 0;
    /// The first slice (of the surface, from the triangle's first voxel) or row of columns (of the solid, from the grid's).
    pub const FIRST: usize = 1;
    /// How many.
    pub const COUNT: usize = 2;
}

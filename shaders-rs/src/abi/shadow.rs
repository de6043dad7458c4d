//! The uniform block of the kernels that make the shadow map, and the buffers they read.

use super::Dispatched;
use super::dispatch::Dispatch;
use super::vector::Vec3;

/// Uniforms of the kernels in [`crate::shadow`].
///
/// The shadow map's grid has x along the light: rows of voxels along x are columns of light.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct ShadowUniforms {
    /// Size of the dispatch and mode (see [`mode`]).
    pub dispatch: Dispatch,
    /// Invocations that have work: items, or rows of voxels.
    pub work: u32,
    /// Voxels along x.
    pub width: u32,
    /// Voxels along y.
    pub height: u32,
    /// Layers along z of this slab.
    pub layers: u32,
    /// The first of this slab's layers.
    pub first_layer: u32,
    /// The map's first word in its buffer.
    pub first_word: u32,
    /// Layers along z of the whole grid.
    pub depth: u32,
    /// Channels, 1 or 3.
    pub channels: u32,
    /// log₂ of the units of a winding that a voxel has.
    pub winding_units: u32,
    /// Optical depth of an occupied voxel in units ([`mode::UNIFORM`]).
    pub uniform_depth: u32,
    /// Absorption coefficient of a clear body, linear RGB, per edge of a voxel.
    pub absorption: Vec3,
    /// How much longer columns are than the grid is deep.
    pub spread: Spread,
    /// Divergence of the columns (see [`crate::voxelize::columns::depth`]); 0 for parallel ones.
    pub divergence: f32,
}

/// How columns of light run apart from a point: the tangents of their angles to the grid's x axis, which grow evenly from column to column. All
/// are 0 where columns are parallel.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Spread {
    /// The tangent along y at the grid's low corner.
    pub low_y: f32,
    /// The tangent along z there.
    pub low_z: f32,
    /// By how much a tangent grows from one column to the next.
    pub step: f32,
}

impl Dispatched for ShadowUniforms {
    #[inline(always)]
    fn dispatch(&self) -> Dispatch {
        self.dispatch
    }
}

/// Modes of [`crate::shadow::accumulate`]: how a voxel absorbs.
pub mod mode {
    /// By the sum of optical depths in it (Chang et al. 2010).
    pub const COUNTED: u32 = 0;
    /// The same in each voxel in which there is anything (Eisemann & Décoret 2006).
    pub const UNIFORM: u32 = 1;
}

/// A triangle that casts a shadow: floats next to each other, not planar.
pub mod caster {
    /// Floats.
    pub const SIZE: usize = 10;
    /// First corner, in the shadow map's voxels, x; y and z, then the other corners follow.
    pub const CORNERS: usize = 0;
    /// Its optical depth.
    pub const DEPTH: usize = 9;
}

/// The transmittance in front of a row's first voxel and behind each: 16 bits each, this many words for `voxels` of them.
pub const fn row_words(voxels: u32) -> u32 {
    (voxels + 2) >> 1
}

//! The uniform block of the kernels that make the shadow map, and the buffers they read.

use super::Dispatched;
use super::vector::Vec4;
use spirv_std::glam::UVec4;

/// Uniforms of the kernels in [`crate::shadow`].
///
/// The shadow map's grid has x along the light: rows of voxels along x are columns of light.
#[repr(C, align(16))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct ShadowUniforms {
    /// Width and height of the dispatch, mode (see [`mode`]), invocations that have work: items, or rows of voxels.
    pub dispatch: UVec4,
    /// Voxels along x and y, layers along z of this slab, the first of them.
    pub size: UVec4,
    /// Channels; layers along z of the whole grid; log₂ of the units of a winding that a voxel has; optical depth of an occupied
    /// voxel in units ([`mode::UNIFORM`]).
    pub depth: UVec4,
    /// Absorption coefficient a voxel's edge of a clear body: red, green, blue.
    pub absorption: Vec4,
}

impl Dispatched for ShadowUniforms {
    fn window(&self) -> UVec4 {
        UVec4::new(0, 0, self.dispatch.x, self.dispatch.y)
    }
}

/// What a voxel absorbs, for [`crate::shadow::accumulate`].
pub mod mode {
    /// What was summed up in it (Chang et al. 2010).
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

//! The uniform block of the kernels that follow rays through a mesh, and the buffers they read.

use super::Dispatched;
use super::vector::Vec4;
use spirv_std::glam::UVec4;

/// Uniforms of the kernels in [`crate::voxels`].
///
/// Rays run in the grid's frame: voxels from its low corner along its axes, which are the world's. In the view frame x is right, y up,
/// z the depth away from the eye.
#[repr(C, align(16))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct VoxelsUniforms {
    /// Width and height of the picture, mode (see [`mode`]), flags (see [`flag`]).
    pub dispatch: UVec4,
    /// Voxels along x, y and z; clear materials.
    pub size: UVec4,
    /// Bricks along x, y and z; surfaces that a ray may meet at most.
    pub bricks: UVec4,
    /// Half width (`x`) and height (`y`) of the picture at depth 1 (perspective) or anywhere (orthographic), in voxels there; the
    /// depth of the picture's plane (orthographic) (`z`); 1 if orthographic (`w`).
    pub camera: Vec4,
    /// Unit vectors of the view frame in the grid's: right; `w`: the eye's x in the grid's frame.
    pub right: Vec4,
    /// Up; `w`: the eye's y.
    pub up: Vec4,
    /// Away from the eye; `w`: the eye's z.
    pub away: Vec4,
    /// Edge of a voxel in world units (`x`); the cosine of the angle up to which two normals are one surface's (`y`); the distance, in
    /// voxels, up to which they are (`z`).
    pub scale: Vec4,
    /// Low corner of the box that holds all surfaces, in voxels.
    pub low: Vec4,
    /// High corner of it.
    pub high: Vec4,
    /// Environment: pattern (`x`), map width (`y`), map height (`z`), levels (`w`).
    pub environment: UVec4,
    /// Rows of the rotation from the grid's frame to the environment's (z up).
    pub environment_x: Vec4,
    /// See `environment_x`.
    pub environment_y: Vec4,
    /// See `environment_x`.
    pub environment_z: Vec4,
    /// Colour (zenith, first square), times intensity; `w`: edge of a square in radians.
    pub environment_color: Vec4,
    /// Horizon (second square), times intensity; `w`: factor on a map.
    pub environment_horizon: Vec4,
    /// Nadir, times intensity; `w`: 1 if the environment is visible.
    pub environment_nadir: Vec4,
    /// The ground: xyz · position + w is the distance in voxels, positive on the visible side. All 0 if there is none.
    pub ground: Vec4,
    /// Its reflectance.
    pub ground_color: Vec4,
    /// The wall, as the ground.
    pub wall: Vec4,
    /// Its reflectance.
    pub wall_color: Vec4,
    /// Unit direction in which light travels, along the grid's axes.
    pub light: Vec4,
    /// Its radiance.
    pub light_color: Vec4,
    /// Radiance from all sides.
    pub ambient: Vec4,
    /// Voxels of the shadow map: along the light, and across (2); its channels, 0 if nothing casts a shadow.
    pub shadow: UVec4,
    /// Rows that take a position to the shadow map's voxels: along the light; `w` is added.
    pub shadow_x: Vec4,
    /// Across.
    pub shadow_y: Vec4,
    /// Across.
    pub shadow_z: Vec4,
    /// Half the width of the filter, in the shadow map's voxels, at least 1 (`x`); edge of one of these in the grid's voxels (`y`).
    pub shadow_filter: Vec4,
}

impl Dispatched for VoxelsUniforms {
    fn window(&self) -> UVec4 {
        UVec4::new(0, 0, self.dispatch.x, self.dispatch.y)
    }
}

/// How many clear surfaces a ray is followed through.
pub mod mode {
    /// Two: where it enters and where it leaves (Wyman 2005).
    pub const TWO_SURFACES: u32 = 0;
    /// As many as it meets.
    pub const MULTI_SURFACE: u32 = 1;
}

/// What [`crate::voxels::resolve`] sees.
pub mod seen {
    /// The environment alone.
    pub const ENVIRONMENT: u32 = 0;
    /// Opaque bodies and receivers, too.
    pub const SURFACES: u32 = 1;
}

/// Switches that cost little at run time.
pub mod flag {
    /// Surfaces reflect what they do not let through (Fresnel).
    pub const FRESNEL: u32 = 1;
    /// There is something opaque ahead of rays, which they look for before they march.
    pub const SEEKS: u32 = 2;
    /// Looks belong to triangles; else to materials.
    pub const LOOK_OF_TRIANGLE: u32 = 4;
}

/// The number of what is outside of all materials: higher than any material's.
pub const AIR: i32 = 16;

/// log₂ of a brick's edge in voxels.
pub const BRICK_SHIFT: i32 = 2;

/// Steps, nodes and slices after which a dispatch leaves the rest to the next. The loops within a step are short: some drivers end
/// loops after 65,535 rounds that eight invocations take together.
pub const STEPS: i32 = 256;

/// A material: floats next to each other, not planar. Where bodies overlap, the one with the lowest number is there.
pub mod material {
    /// Floats.
    pub const SIZE: usize = 4;
    /// Index of refraction; 0 for an opaque material.
    pub const IOR: usize = 0;
    /// Absorption coefficient a voxel's edge, red; green and blue follow.
    pub const ABSORPTION: usize = 1;
}

/// A clear material's field, which is 0 outside of a box: words in front of all samples, one entry a material.
pub mod field {
    /// Words.
    pub const SIZE: usize = 4;
    /// Number of the box's first sample, two samples a word from the buffer's first word on. They go along x, then y, then z.
    pub const FIRST: usize = 0;
    /// The box along x, in voxels: where it begins (16 bits), how many it has (16 bits, from bit 16 on); y and z follow.
    pub const BOX: usize = 1;
}

/// A node of the tree of boxes, in depth-first order: floats next to each other, not planar.
pub mod node {
    /// Floats.
    pub const SIZE: usize = 8;
    /// Low corner, in voxels; y and z follow.
    pub const LOW: usize = 0;
    /// High corner; y and z follow.
    pub const HIGH: usize = 3;
    /// The triangle in a leaf; −1 for a node with nodes below.
    pub const TRIANGLE: usize = 6;
    /// The node behind all that are below this one.
    pub const BEHIND: usize = 7;
}

/// A triangle of the tree: floats next to each other, not planar.
pub mod corner {
    /// Floats.
    pub const SIZE: usize = 19;
    /// First corner, in voxels, x; y and z, then the other corners follow.
    pub const POSITIONS: usize = 0;
    /// Normal at the first corner; y and z, then those of the other corners follow.
    pub const NORMALS: usize = 9;
    /// The material's number.
    pub const MATERIAL: usize = 18;
}

/// How an opaque triangle or material looks: floats next to each other, not planar.
pub mod look {
    /// Floats.
    pub const SIZE: usize = 10;
    /// Reflectance at the first corner, red; green and blue, then those of the other corners follow.
    pub const COLORS: usize = 0;
    /// The share of light that goes through the triangle.
    pub const TRANSMITTANCE: usize = 9;
}

/// What a voxel that triangles meet has, for the paper's rays: floats next to each other, not planar.
pub mod surface {
    /// Floats.
    pub const SIZE: usize = 4;
    /// Unit normal; y and z follow.
    pub const NORMAL: usize = 0;
    /// The material's number.
    pub const MATERIAL: usize = 3;
}

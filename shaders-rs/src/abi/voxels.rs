//! The uniform block of the kernels that follow rays through a mesh, and the buffers they read.

use super::Dispatched;
use super::ambient::Ambient;
use super::camera::Camera;
use super::dispatch::Dispatch;
use super::environment::Environment;
use super::light::LightSource;
use super::receivers::Receivers;
use super::shadow::Spread;
use super::vector::{Affine, Counts, Vec3};
use super::wavefront::Wavefront;

/// Uniforms of the kernels in [`crate::voxels`].
///
/// Rays run in the grid's frame: voxels from its low corner along its axes, which are the world's. In the view frame x is right, y up,
/// z the depth away from the eye.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct VoxelsUniforms {
    /// Size of the picture and mode (see [`mode`]).
    pub dispatch: Dispatch,
    /// Switches, see [`flag`].
    pub flags: u32,
    /// Voxels along each axis.
    pub size: Counts,
    /// Clear materials.
    pub materials: u32,
    /// Bricks along each axis.
    pub bricks: Counts,
    /// Surfaces that a ray may meet at most.
    pub most_bounces: u32,
    /// The camera; lengths in voxels.
    pub camera: Camera,
    /// The view frame's x, right, as a unit vector in the grid's frame.
    pub right: Vec3,
    /// The view frame's y, up.
    pub up: Vec3,
    /// The view frame's z, away from the eye.
    pub away: Vec3,
    /// The eye, in the grid's frame.
    pub eye: Vec3,
    /// Edge of a voxel, world units.
    pub voxel: f32,
    /// Cosine of the angle up to which two normals are one surface's.
    pub same_cosine: f32,
    /// Distance up to which they are, in voxels; for triangles, up to which two surfaces are in contact.
    pub same_distance: f32,
    /// Low corner of the box that holds all surfaces, in voxels.
    pub low: Vec3,
    /// High corner of that box.
    pub high: Vec3,
    /// The environment.
    pub environment: Environment,
    /// Mean radiance of the environment over all directions, linear RGB.
    pub mean_radiance: Vec3,
    /// Ground and wall; distances in voxels.
    pub receivers: Receivers,
    /// The light.
    pub light: LightSource,
    /// Ambient light.
    pub ambient: Ambient,
    /// The shadow map.
    pub shadow: ShadowMap,
    /// The wavefront that has carried light to ground and wall, under [`flag::CAUSTICS`]: its frame, for positions in the grid's, and its maps, in
    /// the buffer of the shadow map.
    pub wavefront: Wavefront,
}

/// The grid of the transparent shadow map (Chang et al. 2010, §3).
///
/// The columns of a distant light are parallel. Those of a point run apart from it: the rows for the coordinates across then give numerators, and
/// `scale` is what they are divided by.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct ShadowMap {
    /// Its voxels: along its axis (x), and across (y, z).
    pub size: Counts,
    /// Its channels, 1 or 3; 0 if nothing casts a shadow.
    pub channels: u32,
    /// Its axis: the unit direction in which a distant light travels, or that from a point into the middle of its light.
    pub axis: Vec3,
    /// Its coordinate along the axis, in its voxels, of a position in the grid's frame.
    pub row_x: Affine,
    /// Its first coordinate across.
    pub row_y: Affine,
    /// Its second coordinate across.
    pub row_z: Affine,
    /// The width of a column over that of a column where voxels are cubes; 1 everywhere for a distant light.
    pub scale: Affine,
    /// How columns run apart.
    pub spread: Spread,
    /// Half the width of the filter, in its voxels, at least 1.
    pub radius: f32,
    /// Edge of one of its voxels, where they are cubes, in voxels of the grid.
    pub edge: f32,
    /// Tangent of the light's angular radius; 0 for a crisp light.
    pub softness: f32,
    /// Its first word.
    pub first: u32,
    /// The first word of the map of opaque bodies alone, which receivers are shadowed by under [`flag::CAUSTICS`].
    pub first_opaque: u32,
    /// Channels of that map; 0 if no opaque body casts a shadow.
    pub opaque_channels: u32,
}

impl ShadowMap {
    /// The place of a shadow map where nothing casts a shadow.
    pub const NONE: Self = Self {
        size: Counts::new(0, 0, 0),
        channels: 0,
        axis: Vec3::ZERO,
        row_x: Affine::constant(0.0),
        row_y: Affine::constant(0.0),
        row_z: Affine::constant(0.0),
        scale: Affine::constant(1.0),
        spread: Spread { low_y: 0.0, low_z: 0.0, step: 0.0 },
        radius: 0.0,
        edge: 0.0,
        softness: 0.0,
        first: 0,
        first_opaque: 0,
        opaque_channels: 0,
    };
}

impl Dispatched for VoxelsUniforms {
    #[inline(always)]
    fn dispatch(&self) -> Dispatch {
        self.dispatch
    }
}

/// How many clear surfaces a ray is followed through.
pub mod mode {
    /// Two: where it enters and where it leaves (Wyman 2005).
    pub const TWO_SURFACES: u32 = 0;
    /// As many as it meets.
    pub const MULTI_SURFACE: u32 = 1;
}

/// Modes of [`crate::voxels::resolve`]: the things that it sees.
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
    /// Rays keep their strongest reflection for a way that follows.
    pub const KEEPS: u32 = 8;
    /// Ground and wall have the light that clear bodies have refracted onto them, in maps.
    pub const CAUSTICS: u32 = 16;
}

/// The number of the air outside of all materials: higher than any material's.
pub const AIR: i32 = 16;

/// log₂ of a brick's edge in voxels.
pub const BRICK_SHIFT: i32 = 2;

/// The largest distance from a body's surface that its field holds, in voxels. A normal at the surface depends on samples up to 2 voxels
/// away along an axis and 1 along the others, and these after smoothing on distances 2 more along each: (4, 3, 3) is 5.8 from a plane across
/// the cube's diagonal. A field that is cut off nearer has normals that lean, at any resolution.
pub const BAND: f32 = 6.0;

/// Steps, nodes and slices after which a dispatch leaves the rest to the next. The loops within a step are short: some drivers end
/// loops after 65,535 rounds that eight invocations take together.
pub const STEPS: i32 = 256;

/// A material: floats next to each other, not planar. Where bodies overlap, the one with the lowest number is there.
pub mod material {
    /// Floats.
    pub const SIZE: usize = 4;
    /// Index of refraction; 0 for an opaque material, −1 for a mirror.
    pub const IOR: usize = 0;
    /// Absorption coefficient a voxel's edge, red; green and blue follow. The reflectance of a mirror.
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

/// Normal and material of a voxel that triangles meet, for the paper's rays: floats next to each other, not planar.
pub mod surface {
    /// Floats.
    pub const SIZE: usize = 4;
    /// Unit normal; y and z follow.
    pub const NORMAL: usize = 0;
    /// The material's number.
    pub const MATERIAL: usize = 3;
}

//! The uniform block of the kernels of beams, and the constants that host and kernels share.

use super::Dispatched;
use super::ambient::Ambient;
use super::camera::Camera;
use super::dispatch::Dispatch;
use super::environment::Environment;
use super::light::LightSource;
use super::receivers::Receivers;
use super::vector::{Size, Vec3};

/// Uniforms of the kernels in [`crate::beams`].
///
/// All of them work in the frame of the mesh's grid: lengths in voxels from its low corner, along the world's axes.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct BeamsUniforms {
    /// Size of the dispatch, and mode.
    pub dispatch: Dispatch,
    /// Viewing rays across and down.
    pub picture: Size,
    /// The camera; lengths in voxels.
    pub camera: Camera,
    /// The view frame's x, right, as a unit vector.
    pub right: Vec3,
    /// The view frame's y, up.
    pub up: Vec3,
    /// The view frame's z, away from the eye.
    pub away: Vec3,
    /// The eye.
    pub eye: Vec3,
    /// Edge of a voxel, world units.
    pub voxel: f32,
    /// Low corner of the box that holds all surfaces.
    pub low: Vec3,
    /// High corner of that box.
    pub high: Vec3,
    /// The light.
    pub light: LightSource,
    /// The rays of the light.
    pub lattice: Lattice,
    /// How far rays are followed.
    pub limits: Limits,
    /// The scattering medium.
    pub medium: Medium,
    /// Ground and wall.
    pub receivers: Receivers,
    /// The environment.
    pub environment: Environment,
    /// Ambient light that opaque surfaces reflect.
    pub ambient: Ambient,
    /// Switches, see [`flag`].
    pub flags: u32,
    /// The sums of in-scattered radiance.
    pub sums: Sums,
    /// The cells of the medium.
    pub cells: Cells,
}

/// The lattice of a light's rays (Hu et al. 2010, §5.1, the caustic buffer): a square of `count` × `count` texels.
///
/// Texel (i, j) has the ray through its centre. The rays of a distant light are parallel and start on a plane across it; those of a point
/// go through texels of a plane at distance 1 from it, in voxels.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Lattice {
    /// Texels along each edge.
    pub count: u32,
    /// Unit vector along the light's middle.
    pub axis: Vec3,
    /// Unit vector along the rows of texels.
    pub across: Vec3,
    /// Unit vector along the columns of texels.
    pub upwards: Vec3,
    /// Position of a distant light's plane; the position of a point.
    pub origin: Vec3,
    /// The first corner, along the rows.
    pub low_across: f32,
    /// The first corner, along the columns.
    pub low_upwards: f32,
    /// Edge of a texel along the rows.
    pub step_across: f32,
    /// Edge of a texel along the columns.
    pub step_upwards: f32,
}

/// How far rays are followed.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Limits {
    /// Distance up to which two surfaces are in contact.
    pub same_distance: f32,
    /// Share of a light ray's flux below which a part of it is not followed.
    pub threshold: f32,
    /// Share of a viewing ray's radiance below which a part of it is not followed.
    pub view_threshold: f32,
    /// Surfaces that a ray may meet on one way.
    pub bounces: u32,
    /// Number of the straight piece in air, from 0 on over all ways of a ray, up to which rays are followed by a pass.
    pub round: u32,
    /// The round of beams that light surfaces in a pass of [`crate::beams::light_surface`]: one at a time, since drivers end long loops.
    pub lit: u32,
    /// Floats from the beams of one round to those of the next.
    pub pitch: u32,
    /// Floats from the projections of one round to those of the next.
    pub projection_pitch: u32,
    /// Floats from the bundles of one round to those of the next.
    pub bundle_pitch: u32,
    /// The last round that has beams.
    pub last: u32,
    /// The major axis of the beams that are drawn, one of [`axis`].
    pub axis: u32,
    /// How beams are drawn, one of [`estimator`].
    pub estimator: u32,
    /// Floats before the optical depths along beams.
    pub depth_start: u32,
    /// Floats from the optical depths along the beams of one round to those of the next.
    pub depth_pitch: u32,
    /// Step Δx of a march along viewing rays, in voxels.
    pub step: f32,
    /// Radius r of the support of its filter, in voxels; at most [`FILTER_STEPS`] steps.
    pub filter_radius: f32,
    /// 1 over the width of a pixel at the distance of the bodies, a voxel: the constant of a march.
    pub line_weight: f32,
}

/// A medium in a box, homogeneous or with a density from a volume.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Medium {
    /// Extinction coefficient σ_t where the density is 1, RGB, a voxel.
    pub extinction: Vec3,
    /// Scattering coefficient σ_s where the density is 1, RGB, a voxel.
    pub scattering: Vec3,
    /// Mean cosine g of Henyey and Greenstein's phase function.
    pub anisotropy: f32,
    /// The phase function, one of [`phase`].
    pub phase: u32,
    /// Low corner of the box.
    pub low: Vec3,
    /// High corner of the box.
    pub high: Vec3,
    /// Nodes of a straight piece at which its optical depth is known, evenly spaced (Hu et al. 2010, §5.2); 0 in a homogeneous medium.
    pub nodes: u32,
    /// Voxels of the density's volume along x.
    pub columns: u32,
    /// Voxels along y.
    pub rows: u32,
    /// Voxels along z.
    pub layers: u32,
    /// Floats in front of the volume in the buffer of materials.
    pub first: u32,
    /// Floats in front of a tabulated phase function in the buffer of materials.
    pub first_phase: u32,
}

/// Places of a tabulated phase function: even steps of the sine of half the angle, from forward to back.
pub const PHASES: u32 = 256;

/// Phase functions.
pub mod phase {
    /// Henyey and Greenstein 1941; isotropic where g is 0.
    pub const HENYEY_GREENSTEIN: u32 = 0;
    /// Rayleigh's.
    pub const RAYLEIGH: u32 = 1;
    /// A table.
    pub const TABULATED: u32 = 2;
}

/// The sums of in-scattered radiance: for each pixel of each level of a pyramid of pictures, three channels of 64 bits.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Sums {
    /// Units in a radiance of 1.
    pub scale: f32,
    /// Levels of the pyramid above the picture itself, at most [`LEVELS`].
    pub levels: u32,
    /// Pixels below level 1, and so on.
    pub pixels_1: u32,
    /// Pixels below level 2.
    pub pixels_2: u32,
    /// Pixels below level 3.
    pub pixels_3: u32,
    /// Pixels below level 4.
    pub pixels_4: u32,
    /// Rows of the levels from 1 on before level 2.
    pub rows_2: u32,
    /// Rows before level 3.
    pub rows_3: u32,
    /// Rows before level 4.
    pub rows_4: u32,
    /// Rows of all levels from 1 on.
    pub rows: u32,
}

/// Cells of the medium's box along each of its edges, between which light that is scattered more than once is exchanged.
pub const CELLS: u32 = 16;

/// The cells of the medium's box.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Cells {
    /// Edges of a cell, in voxels.
    pub edge: Vec3,
    /// Units in a sum of light, as [`crate::abi::record::deposit`] has, of 1.
    pub scale: f32,
    /// Mean cosine of the phase function.
    pub mean_cosine: f32,
    /// Floats in front of the table of what cells exchange in the buffer of materials.
    pub first: u32,
}

/// Modes of [`crate::beams::exchange_light`]: where light arrives.
pub mod target {
    /// At cells.
    pub const CELLS: u32 = 0;
    /// At the eye, by way of a cell.
    pub const EYE: u32 = 1;
}

/// The most levels of the pyramid above the picture itself: level l has pixels of 2^l × 2^l viewing rays.
pub const LEVELS: u32 = 4;

/// Columns of the picture in which one invocation draws a beam.
pub const BLOCK: u32 = 16;

/// Switches that cost little at run time.
pub mod flag {
    /// Looks belong to triangles; else to materials.
    pub const LOOK_OF_TRIANGLE: u32 = 1;
    /// The medium scatters light.
    pub const SCATTERS: u32 = 2;
    /// Bodies hide the source.
    pub const SHADOWS: u32 = 4;
}

/// Whose rays [`crate::beams::trace`] follows.
pub mod rays {
    /// The light's, one for each texel of the lattice.
    pub const LIGHT: u32 = 0;
    /// The viewer's, one for each pixel.
    pub const VIEW: u32 = 1;
}

/// Modes of [`crate::beams::store_beam`].
pub mod part {
    /// Light behind the surfaces that it met.
    pub const CAUSTIC: u32 = 0;
    /// Light that a body takes out of what would be there without it.
    pub const SHADOW: u32 = 1;
}

/// Modes of [`crate::beams::scatter_beam`].
pub mod medium {
    /// The density is 1 everywhere.
    pub const HOMOGENEOUS: u32 = 0;
    /// The density is given by a volume.
    pub const VARYING: u32 = 1;
    /// Of either kind, by a march along viewing rays, for comparison.
    pub const MARCHED: u32 = 2;
}

/// Steps in the radius of the support of a march's filter, at most.
pub const FILTER_STEPS: i32 = 2;

/// How wide beams are drawn.
pub mod estimator {
    /// As wide as they are.
    pub const BEAMS: u32 = 0;
    /// One pixel wide.
    pub const LINES: u32 = 1;
    /// One pixel wide, with the same weight everywhere, gathered by a march along viewing rays.
    pub const MARCH: u32 = 2;
}

/// Major axes of the beams that a pass of [`crate::beams::scatter_beam`] draws.
pub mod axis {
    /// To the right.
    pub const ACROSS: u32 = 0;
    /// Downwards.
    pub const DOWNWARDS: u32 = 1;
}

impl Dispatched for BeamsUniforms {
    #[inline(always)]
    fn dispatch(&self) -> Dispatch {
        self.dispatch
    }
}

//! The uniform block of the plane sweep's kernels.
//!
//! The sweep frame: x right, y up, z the depth away from the eye, world units, the eye at the origin.

use super::Dispatched;
use super::grid::Grid;
use super::vector::Vec4;
use spirv_std::glam::UVec4;

/// Uniforms of every kernel of the sweep; one block a pass.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct SweepUniforms {
    /// Width and height of the dispatch, mode (see [`mode`]), flags (see [`flag`]).
    pub dispatch: UVec4,
    /// Where the pass runs: its first column and row (`x`, `y`), and those before which it ends (`z`, `w`).
    pub window: UVec4,
    /// Width and height of the picture (`x`, `y`) and of the light grid (`z`, `w`).
    pub size: UVec4,
    /// Where the irradiance of the plane behind starts in its buffer, in words (`x`).
    pub irradiance: UVec4,
    /// Depth of the plane behind (`x`) and ahead (`y`), their distance (`z`), 1 / reference length (`w`).
    pub plane: Vec4,
    /// The volume.
    pub grid: Grid,
    /// The volume that gives η, where there is a second one.
    pub ior_grid: Grid,
    /// Light grid: the corner of texel (0, 0) on the plane at depth `light_shear.z` (`x`, `y`), texel edge (`z`), its inverse (`w`).
    pub light_grid: Vec4,
    /// Shift of the light grid per unit of depth (`x`, `y`); the depth where the shift is 0 (`z`).
    pub light_shear: Vec4,
    /// Unoccluded light as it is stored: plane irradiance, or radiance under [`flag::STORE_RADIANCE`] (`xyz`); the share of it
    /// that one sheet carries (`w`).
    pub light_initial: Vec4,
    /// Initial optical direction.
    pub light_direction: Vec4,
    /// Two of the three filter taps, in texels.
    pub taps_a: Vec4,
    /// The third filter tap.
    pub taps_b: Vec4,
    /// Half width (`x`) and height (`y`) of the picture at depth 1 (perspective) or anywhere (orthographic); depth at which rays
    /// start (`z`); 1 if orthographic (`w`).
    pub camera: Vec4,
    /// Ground: signed distance = xyz · point + w, positive on its visible side. All 0 if there is none.
    pub ground_plane: Vec4,
    /// Ground reflectance.
    pub ground_color: Vec4,
    /// Wall: as the ground.
    pub wall_plane: Vec4,
    /// Wall reflectance.
    pub wall_color: Vec4,
    /// Clipping planes: signed distance = xyz · point + w, positive where it removes. All 0 if unused.
    pub clip_0: Vec4,
    /// See `clip_0`.
    pub clip_1: Vec4,
    /// See `clip_0`.
    pub clip_2: Vec4,
    /// See `clip_0`.
    pub clip_3: Vec4,
    /// For each clipping plane 1 if it removes everything, 0 if opacity only.
    pub clip_everything: Vec4,
    /// Ambient radiance (`xyz`).
    pub ambient: Vec4,
    /// GGX roughness (`x`), specular factor (`y`), smallest v_z / |v| of a ray that goes on (`z`); planes behind this one that are as
    /// far apart (`w`).
    pub shading: Vec4,
    /// Environment: pattern (`x`), map width (`y`), map height (`z`), levels (`w`).
    pub environment: UVec4,
    /// Rows of the rotation from the sweep frame to the environment's frame (z up).
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
}

impl Dispatched for SweepUniforms {
    fn window(&self) -> UVec4 {
        self.window
    }
}

/// What a pass specialises on; each backend may compile one body per mode.
pub mod mode {
    /// η is 1 everywhere: rays are straight, nothing reflects.
    pub const STRAIGHT: u32 = 0;
    /// Refraction, ∇η by central differences of η over six neighbours.
    pub const CENTRAL: u32 = 1;
    /// Refraction, ∇η by the chain rule.
    pub const CHAIN: u32 = 2;
    /// As [`CLEAR_STRAIGHT`], for viewing rays where the light is unoccluded everywhere, so that its buffers are not looked at.
    pub const UNSHADED: u32 = 3;
    /// As [`STRAIGHT`], where the medium is clear, so that light has one colour everywhere.
    pub const CLEAR_STRAIGHT: u32 = 4;
    /// As [`CENTRAL`], where the medium is clear.
    pub const CLEAR_CENTRAL: u32 = 5;

    /// Whether rays are bent in this mode.
    #[must_use]
    #[inline(always)]
    pub fn bends(mode: u32) -> bool {
        (mode == CENTRAL) | (mode == CHAIN) | (mode == CLEAR_CENTRAL)
    }

    /// The mode that computes the same without taking the medium to be clear.
    #[must_use]
    pub fn any_medium(mode: u32) -> u32 {
        match mode {
            CLEAR_STRAIGHT => STRAIGHT,
            CLEAR_CENTRAL => CENTRAL,
            other => other,
        }
    }

    /// Whether the medium is taken to be clear in this mode.
    #[must_use]
    #[inline(always)]
    pub fn is_clear(mode: u32) -> bool {
        mode >= UNSHADED
    }
}

/// Switches that cost little at run time.
pub mod flag {
    /// The paper's Euler step instead of kick–drift–kick.
    pub const EULER: u32 = 1;
    /// Eq. 13 instead of the Jacobian.
    pub const PAPER_INTENSITY: u32 = 2;
    /// No intensity correction.
    pub const NO_INTENSITY: u32 = 4;
    /// The light buffer holds radiance instead of plane irradiance.
    pub const STORE_RADIANCE: u32 = 8;
    /// There are clipping planes.
    pub const CLIP: u32 = 16;
    /// Empty space is skipped.
    pub const SKIP_EMPTY: u32 = 32;
    /// The segment to this plane lies behind the volumes.
    pub const BEHIND_VOLUME: u32 = 64;
    /// All planes behind this one are as far apart.
    pub const LAST_STRETCH: u32 = 128;
}

//! The uniform block of the plane sweep's kernels.
//!
//! They work in the view frame: x right, y up, z the depth away from the eye, world units, the eye at the origin.

use super::Dispatched;
use super::ambient::Ambient;
use super::camera::Camera;
use super::clip::Clip;
use super::dispatch::{Dispatch, Region};
use super::environment::Environment;
use super::grid::Grid;
use super::light::{Light, LightGrid, Taps};
use super::receivers::Receivers;
use super::vector::Size;
use super::wavefront::Wavefront;

/// Uniforms of every kernel of the sweep; one block a pass.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct SweepUniforms {
    /// Size of the dispatch and mode (see [`mode`]).
    pub dispatch: Dispatch,
    /// Switches, see [`flag`].
    pub flags: u32,
    /// Where the pass runs.
    pub region: Region,
    /// Viewing rays of the pass, across and down.
    pub picture: Size,
    /// Viewing rays that the whole picture has, across and down.
    pub sensor: Size,
    /// Rays along each side of a pixel where the pass has those of some pixels alone, see [`place`](crate::sweep::place); 0 where it has all rays.
    pub refined: u32,
    /// Where the irradiance of the plane behind starts in its buffer, in words.
    pub irradiance_start: u32,
    /// The step from the plane behind to the plane ahead.
    pub step: Step,
    /// The volume.
    pub grid: Grid,
    /// The volume that gives η, where there is a second one.
    pub ior_grid: Grid,
    /// The light texels.
    pub light_grid: LightGrid,
    /// The light; its colour is plane irradiance, or radiance under [`flag::STORE_RADIANCE`].
    pub light: Light,
    /// The wavefront that carries the light forward, if one does.
    pub wavefront: Wavefront,
    /// The softness filter's taps.
    pub taps: Taps,
    /// The camera; lengths in world units.
    pub camera: Camera,
    /// Ground and wall.
    pub receivers: Receivers,
    /// The first clipping plane.
    pub clip_0: Clip,
    /// The second clipping plane.
    pub clip_1: Clip,
    /// The third clipping plane.
    pub clip_2: Clip,
    /// The fourth clipping plane.
    pub clip_3: Clip,
    /// Ambient light.
    pub ambient: Ambient,
    /// GGX roughness, 0 to 1.
    pub roughness: f32,
    /// Factor on specular reflection.
    pub specular: f32,
    /// The environment.
    pub environment: Environment,
}

/// A step from plane to plane.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Step {
    /// Depth of the plane behind, world units.
    pub behind: f32,
    /// Depth of the plane ahead.
    pub ahead: f32,
    /// The planes' distance.
    pub distance: f32,
    /// 1 / the reference length of optical depths.
    pub inverse_reference_length: f32,
    /// The smallest v_z / |v| of a ray that goes on.
    pub smallest_cosine: f32,
    /// Length of the run of equally spaced planes after the plane ahead.
    pub alike: f32,
}

impl Dispatched for SweepUniforms {
    #[inline(always)]
    fn dispatch(&self) -> Dispatch {
        self.dispatch
    }

    #[inline(always)]
    fn region(&self) -> Region {
        self.region
    }

    #[inline(always)]
    fn position(&self) -> (f32, f32) {
        (self.step.ahead, self.step.distance)
    }
}

/// Modes of a pass; each backend may compile a body for each.
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
    /// As [`CENTRAL`], for viewing rays that look at light on texels.
    pub const TEXELS_CENTRAL: u32 = 6;
    /// As [`CHAIN`], for viewing rays that look at light on texels.
    pub const TEXELS_CHAIN: u32 = 7;
    /// As [`STRAIGHT`], for viewing rays whose particles are shaded by the scalar's gradient, where the light is unoccluded everywhere.
    pub const SHADED_BY_GRADIENT: u32 = 8;

    /// Whether rays are bent in this mode.
    #[must_use]
    #[inline(always)]
    pub fn bends(mode: u32) -> bool {
        (mode == CENTRAL) | (mode == CLEAR_CENTRAL) | (mode == TEXELS_CENTRAL) | by_chain_rule(mode)
    }

    /// Whether ∇η is computed by the chain rule in this mode.
    #[must_use]
    #[inline(always)]
    pub fn by_chain_rule(mode: u32) -> bool {
        (mode == CHAIN) | (mode == TEXELS_CHAIN)
    }

    /// Whether viewing rays look at light on texels in this mode.
    #[must_use]
    #[inline(always)]
    pub fn is_on_texels(mode: u32) -> bool {
        (mode == TEXELS_CENTRAL) | (mode == TEXELS_CHAIN)
    }

    /// Whether light is unoccluded everywhere in this mode, so that its buffers are not looked at.
    #[must_use]
    #[inline(always)]
    pub fn is_unoccluded(mode: u32) -> bool {
        (mode == UNSHADED) | (mode == SHADED_BY_GRADIENT)
    }

    /// The mode of viewing rays that look at light on texels.
    #[must_use]
    pub fn on_texels(mode: u32) -> u32 {
        match any_medium(mode) {
            // Where nothing bends rays, that mode leaves them straight.
            STRAIGHT | CENTRAL => TEXELS_CENTRAL,
            CHAIN => TEXELS_CHAIN,
            other => other,
        }
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
        (mode == UNSHADED) | (mode == CLEAR_STRAIGHT) | (mode == CLEAR_CENTRAL)
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
    /// Light was carried forward by a wavefront.
    pub const FORWARD: u32 = 256;
    /// Particles are shaded by the scalar's gradient.
    pub const SHADED_BY_GRADIENT: u32 = 512;
    /// There are isosurfaces.
    pub const ISOSURFACES: u32 = 1024;
}

/// The receivers that light lands on: modes of a pass.
pub mod receiver {
    /// The ground.
    pub const GROUND: u32 = 0;
    /// The wall.
    pub const WALL: u32 = 1;
    /// The plane on which the light is an output.
    pub const OBSERVED: u32 = 2;
}

/// The light that is blurred: modes of a pass.
pub mod blurred {
    /// The nodes themselves.
    pub const NODES: u32 = 0;
    /// The result of the pass before.
    pub const AGAIN: u32 = 1;
}

/// The lines along which differences are summed up: modes of a pass.
pub mod along {
    /// Each row from left to right.
    pub const ROWS: u32 = 0;
    /// Each column from the bottom to the top.
    pub const COLUMNS: u32 = 1;
}

/// What a projection takes of the scalars along a viewing ray: modes of a pass.
pub mod blend {
    /// The largest.
    pub const MAXIMUM: u32 = 0;
    /// The smallest.
    pub const MINIMUM: u32 = 1;
    /// The mean over the length of the way.
    pub const MEAN: u32 = 2;
}

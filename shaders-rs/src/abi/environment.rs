//! The environment behind everything, and the layout of an environment map: a chain of equirectangular levels, RGB floats, level 0 first,
//! each half the size of the one before (at least 1), rows from the zenith down.

use super::vector::Vec3;

/// The environment (sweep §4.4).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Environment {
    /// Pattern, one of [`kind`].
    pub kind: u32,
    /// Texels of the map's level 0 along the longitude.
    pub map_width: u32,
    /// Texels of the map's level 0 along the latitude.
    pub map_height: u32,
    /// Levels of the map.
    pub map_levels: u32,
    /// First row of the rotation from the method's frame to the environment's (z up).
    pub row_x: Vec3,
    /// Second row.
    pub row_y: Vec3,
    /// Third row.
    pub row_z: Vec3,
    /// Radiance: the one colour, the zenith's, or that of the first squares.
    pub color: Vec3,
    /// Radiance of the horizon, or of the second squares.
    pub horizon: Vec3,
    /// Radiance of the nadir.
    pub nadir: Vec3,
    /// Edge of a square of the checkerboard, radians.
    pub square: f32,
    /// Factor on the map's radiance.
    pub intensity: f32,
    /// 1 if the environment is visible behind everything, else 0.
    pub visible: f32,
}

/// The environment's pattern.
pub mod kind {
    /// One colour.
    pub const COLOR: u32 = 0;
    /// Nadir, horizon, zenith.
    pub const GRADIENT: u32 = 1;
    /// Squares in longitude and latitude.
    pub const CHECKERBOARD: u32 = 2;
    /// An equirectangular map.
    pub const MAP: u32 = 3;
}

/// The most levels a chain has.
pub const MAX_LEVELS: u32 = 15;

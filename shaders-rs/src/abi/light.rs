//! Light of a distant source, and the grid of texels that carries it from plane to plane.

use super::vector::Vec3;

/// A distant light.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Light {
    /// Unit direction in which it travels.
    pub direction: Vec3,
    /// Radiance where nothing is in its way, linear RGB; the sweep's plane irradiance unless it stores radiance.
    pub color: Vec3,
}

/// The grid of light texels, sheared along the light's direction.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct LightGrid {
    /// Texels along x.
    pub width: u32,
    /// Texels along y.
    pub height: u32,
    /// Corner of texel (0, 0) on the plane at depth `shear_depth`, x.
    pub corner_x: f32,
    /// Corner of that texel, y.
    pub corner_y: f32,
    /// Edge of a texel, world units.
    pub texel: f32,
    /// 1 / `texel`.
    pub inverse_texel: f32,
    /// Shift of the grid per unit of depth along x.
    pub shear_x: f32,
    /// Shift of the grid per unit of depth along y.
    pub shear_y: f32,
    /// Depth at which the shift is 0.
    pub shear_depth: f32,
}

/// Offsets of the three taps of the softness filter, in texels.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Taps {
    /// The first tap, x.
    pub first_x: f32,
    /// The first tap, y.
    pub first_y: f32,
    /// The second tap, x.
    pub second_x: f32,
    /// The second tap, y.
    pub second_y: f32,
    /// The third tap, x.
    pub third_x: f32,
    /// The third tap, y.
    pub third_y: f32,
}

//! Light sources, and the grid of texels that carries a distant one's light from plane to plane.

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

/// A light source of any kind. Positions are in voxels of the grid, directions along its axes.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct LightSource {
    /// Kind of the source, one of [`kind`].
    pub kind: u32,
    /// Unit direction in which a distant light travels; the unit axis of a spot's cone.
    pub direction: Vec3,
    /// Radiance of a white diffuse surface that faces the source and from which nothing hides it, linear RGB: anywhere for a distant light,
    /// at a distance of one voxel for the others.
    pub color: Vec3,
    /// Position of a point or spot.
    pub position: Vec3,
    /// The cone of a spot.
    pub cone: Cone,
}

/// The cone of a spot, and the picture that it projects. Angles are told by their tangents, so that all is linear on a wall across the axis.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Cone {
    /// The picture's right, as a unit vector across the axis.
    pub right: Vec3,
    /// The picture's top, as a unit vector across the axis.
    pub up: Vec3,
    /// Tangent of the half-angle at which the light ends.
    pub tangent: f32,
    /// 1 over the difference of the tangents between which the light fades.
    pub slope: f32,
    /// The number of the picture's first float in the buffer of pictures; RGB floats, rows from the top down.
    pub first: u32,
    /// Texels of the picture across; 0 if there is none.
    pub width: u32,
    /// Texels of the picture down.
    pub height: u32,
}

/// The kinds of light sources.
pub mod kind {
    /// A source infinitely far away.
    pub const DISTANT: u32 = 0;
    /// A point that shines to all sides.
    pub const POINT: u32 = 1;
    /// A point that shines into a cone.
    pub const SPOT: u32 = 2;
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

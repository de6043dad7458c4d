//! Light from all sides, without shadows.

use super::vector::Vec3;

/// Ambient light: the irradiance of a surface over π by its normal n, mean + x nₓ + y n_y + z n_z + nᵀ Q n, in the environment's frame (Ramamoorthi & Hanrahan
/// 2001: spherical harmonics up to the second order). Colours are linear RGB.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Ambient {
    /// Mean radiance over all directions.
    pub mean: Vec3,
    /// Factor of nₓ.
    pub x: Vec3,
    /// Factor of n_y.
    pub y: Vec3,
    /// Factor of n_z.
    pub z: Vec3,
    /// Factor of nₓ².
    pub xx: Vec3,
    /// Factor of n_y².
    pub yy: Vec3,
    /// Factor of n_z².
    pub zz: Vec3,
    /// Factor of nₓ n_y.
    pub xy: Vec3,
    /// Factor of nₓ n_z.
    pub xz: Vec3,
    /// Factor of n_y n_z.
    pub yz: Vec3,
}

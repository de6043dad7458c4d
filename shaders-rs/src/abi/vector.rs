//! Four floats as uniform blocks hold them.

/// Four floats, aligned to 16 bytes.
///
/// Not glam's: on x86-64 that is an SSE register, and a loop over lanes that loads one in a branch does not become vector code.
#[repr(C, align(16))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Vec4 {
    /// First component.
    pub x: f32,
    /// Second component.
    pub y: f32,
    /// Third component.
    pub z: f32,
    /// Fourth component.
    pub w: f32,
}

impl Vec4 {
    /// All components 0.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0, 0.0);

    /// From components.
    pub const fn new(x: f32, y: f32, z: f32, w: f32) -> Self {
        Self { x, y, z, w }
    }
}

#[cfg(not(target_arch = "spirv"))]
impl From<glam::Vec4> for Vec4 {
    fn from(v: glam::Vec4) -> Self {
        Self::new(v.x, v.y, v.z, v.w)
    }
}

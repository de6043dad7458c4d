//! Vectors as uniform blocks hold them.
//!
//! They are structs of scalars and not glam's vectors: on x86-64 some of those are SSE registers, and a loop over lanes that loads one in a
//! branch does not become vector code. Uniform blocks are bound as storage buffers, where scalars may follow one another without gaps.

/// Three floats.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Vec3 {
    /// First component.
    pub x: f32,
    /// Second component.
    pub y: f32,
    /// Third component.
    pub z: f32,
}

impl Vec3 {
    /// All components 0.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);

    /// From components.
    pub const fn new(x: f32, y: f32, z: f32) -> Self {
        Self { x, y, z }
    }
}

#[cfg(not(target_arch = "spirv"))]
impl From<glam::Vec3> for Vec3 {
    fn from(v: glam::Vec3) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

#[cfg(not(target_arch = "spirv"))]
impl From<[f32; 3]> for Vec3 {
    fn from([x, y, z]: [f32; 3]) -> Self {
        Self::new(x, y, z)
    }
}

/// An affine function of a point, factors · point + constant: a row of an affine map, or the signed distance from a plane.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Affine {
    /// Factors of the point's coordinates; the plane's normal.
    pub factors: Vec3,
    /// The value at the origin.
    pub constant: f32,
}

impl Affine {
    /// The function that has the same value everywhere.
    pub const fn constant(value: f32) -> Self {
        Self { factors: Vec3::ZERO, constant: value }
    }
}

#[cfg(not(target_arch = "spirv"))]
impl From<glam::Vec4> for Affine {
    fn from(v: glam::Vec4) -> Self {
        Self { factors: v.truncate().into(), constant: v.w }
    }
}

/// Counts along three axes.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Counts {
    /// Along x.
    pub x: u32,
    /// Along y.
    pub y: u32,
    /// Along z.
    pub z: u32,
}

impl Counts {
    /// From numbers.
    pub const fn new(x: u32, y: u32, z: u32) -> Self {
        Self { x, y, z }
    }
}

/// Width and height.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Size {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

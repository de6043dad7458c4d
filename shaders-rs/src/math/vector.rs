//! Sums in a fixed order (a SIMD `dot` sums in another order than SPIR-V does).

use crate::abi::vector::Vec4;
use spirv_std::glam::Vec3;

/// a·b, summed from x to z.
#[inline(always)]
pub fn dot(a: Vec3, b: Vec3) -> f32 {
    (a.x * b.x + a.y * b.y) + a.z * b.z
}

/// |a|.
#[inline(always)]
pub fn length(a: Vec3) -> f32 {
    super::sqrt(dot(a, a))
}

/// The first three components.
#[inline(always)]
pub fn xyz(v: Vec4) -> Vec3 {
    Vec3::new(v.x, v.y, v.z)
}

//! Sums in a fixed order (a SIMD `dot` sums in another order than SPIR-V does).

use super::{absolute, select};
use crate::abi::vector::{self, Affine};
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

/// a × b.
#[inline(always)]
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}

/// a / |a|; 0 for 0.
#[inline(always)]
pub fn normalize(a: Vec3) -> Vec3 {
    a * (1.0 / super::max(length(a), 1e-20))
}

/// `yes` if `condition`, else `no`, component by component.
#[inline(always)]
pub fn select_vector(condition: bool, yes: Vec3, no: Vec3) -> Vec3 {
    Vec3::new(select(condition, yes.x, no.x), select(condition, yes.y, no.y), select(condition, yes.z, no.z))
}

/// The value of an affine function at a point, summed from x to the constant.
#[inline(always)]
pub fn affine(of: Affine, point: Vec3) -> f32 {
    dot(xyz(of.factors), point) + of.constant
}

/// The absolute values of the components.
#[inline(always)]
pub fn absolute_vector(v: Vec3) -> Vec3 {
    Vec3::new(absolute(v.x), absolute(v.y), absolute(v.z))
}

/// A uniform block's vector.
#[inline(always)]
pub fn xyz(v: vector::Vec3) -> Vec3 {
    Vec3::new(v.x, v.y, v.z)
}

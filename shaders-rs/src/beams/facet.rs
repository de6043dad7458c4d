//! The normal between the corners of a triangle, and its derivative by the position.

use crate::abi::voxels::corner;
use crate::field::access::read_vector;
use crate::math::{cross, dot, length, max, normalize, select, select_vector};
use spirv_std::glam::Vec3;

/// A triangle at a point of it.
#[derive(Clone, Copy)]
pub struct Facet {
    /// Unit normal of its plane.
    pub plane: Vec3,
    /// Unit normal between the corners.
    pub normal: Vec3,
    /// 1 over the length of the sum of the corners' normals by their weights.
    inverse: f32,
    /// Rows of the derivative of the weights of the second and the third corner by the position, 1 / voxel.
    second: Vec3,
    third: Vec3,
    /// Differences of the normals at these corners from the normal at the first one.
    second_normal: Vec3,
    third_normal: Vec3,
}

impl Facet {
    /// Triangle number `triangle` at `position`.
    #[inline(always)]
    pub fn new(corners: &[f32], triangle: i32, position: Vec3) -> Self {
        let at = triangle * corner::SIZE as i32;
        let a = read_vector(corners, at);
        let (first_edge, second_edge) = (read_vector(corners, at + 3) - a, read_vector(corners, at + 6) - a);
        let across = cross(first_edge, second_edge);
        let squared = max(dot(across, across), 1e-30);
        // Weight of a corner: the part of the area that lies at the edge beside it.
        let second = cross(second_edge, across) * (1.0 / squared);
        let third = cross(across, first_edge) * (1.0 / squared);
        let normals = at + corner::NORMALS as i32;
        let normal = read_vector(corners, normals);
        let second_normal = read_vector(corners, normals + 3) - normal;
        let third_normal = read_vector(corners, normals + 6) - normal;
        let offset = position - a;
        let mean = normal + second_normal * dot(second, offset) + third_normal * dot(third, offset);
        let inverse = 1.0 / max(length(mean), 1e-20);
        Self { plane: normalize(across), normal: mean * inverse, inverse, second, third, second_normal, third_normal }
    }

    /// The triangle with its own normal everywhere.
    #[inline(always)]
    #[must_use]
    pub fn flat(self) -> Self {
        let zero = Vec3::new(0.0, 0.0, 0.0);
        Self { normal: self.plane, second: zero, third: zero, ..self }
    }

    /// `smooth` or `flat`.
    #[inline(always)]
    #[must_use]
    pub fn flat_if(self, flat: bool) -> Self {
        let other = self.flat();
        Self {
            normal: select_vector(flat, other.normal, self.normal),
            second: select_vector(flat, other.second, self.second),
            third: select_vector(flat, other.third, self.third),
            ..self
        }
    }

    /// The facet with its normal on the side that a ray along `direction` comes from.
    #[inline(always)]
    #[must_use]
    pub fn facing(self, direction: Vec3) -> Self {
        let side = select(dot(self.normal, direction) > 0.0, -1.0, 1.0);
        Self {
            normal: self.normal * side,
            second_normal: self.second_normal * side,
            third_normal: self.third_normal * side,
            ..self
        }
    }

    /// The change of the unit normal for a change of the position in the plane.
    #[inline(always)]
    pub fn turn(&self, change: Vec3) -> Vec3 {
        let sum = self.second_normal * dot(self.second, change) + self.third_normal * dot(self.third, change);
        let turned = sum * self.inverse;
        turned - self.normal * dot(self.normal, turned)
    }
}

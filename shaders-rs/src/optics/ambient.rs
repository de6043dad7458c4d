//! Ambient light: light from all sides, without shadows.

use super::environment::in_environment;
use crate::abi::ambient::Ambient;
use crate::abi::environment::Environment;
use crate::math::{max, xyz};
use spirv_std::glam::Vec3;

/// The mean radiance over all directions: the ambient light that a particle scatters, whose phase function is the same for all directions.
#[inline(always)]
pub fn mean_radiance(ambient: &Ambient) -> Vec3 {
    xyz(ambient.mean)
}

/// The irradiance over π of a surface of unit normal `normal`, for spherical harmonics up to the second order (Ramamoorthi & Hanrahan 2001, Eq. 12).
#[inline(always)]
pub fn irradiance(ambient: &Ambient, environment: &Environment, normal: Vec3) -> Vec3 {
    let n = in_environment(environment, normal);
    let linear = xyz(ambient.x) * n.x + xyz(ambient.y) * n.y + xyz(ambient.z) * n.z;
    let squares = xyz(ambient.xx) * (n.x * n.x) + xyz(ambient.yy) * (n.y * n.y) + xyz(ambient.zz) * (n.z * n.z);
    let products = xyz(ambient.xy) * (n.x * n.y) + xyz(ambient.xz) * (n.x * n.z) + xyz(ambient.yz) * (n.y * n.z);
    let sum = xyz(ambient.mean) + linear + (squares + products);
    // The series of a bright spot is negative on its far side.
    Vec3::new(max(sum.x, 0.0), max(sum.y, 0.0), max(sum.z, 0.0))
}

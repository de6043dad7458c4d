//! Diffuse reflection of opaque matter by the gradient of its scalar, as of a surface.

use crate::abi::grid::Grid;
use crate::math::{absolute, clamp, dot, length, lerp, max, xyz};
use spirv_std::glam::Vec3;

/// The change of the normalised scalar over a voxel from which on matter is shaded as a surface is; matter that does not change has no normal.
const SURFACE: f32 = 1.0 / 64.0;

/// The cosine between a surface's normal and the way to the light, 0 to 1: of the side of the surface that the viewer sees. `gradient` is that of the
/// normalised scalar over world units, `light` and `view` are travel directions; `least` is the share of what is seen that is a surface, however the scalar changes.
#[inline(always)]
pub fn cosine(grid: &Grid, gradient: Vec3, light: Vec3, view: Vec3, least: f32) -> f32 {
    let size = length(gradient);
    let lit = dot(gradient, light) / max(size * length(light), 1e-20);
    // On the viewer's side: away from the way that the ray travels.
    let seen = if dot(gradient, view) > 0.0 { lit } else { -lit };
    let change = size / length(xyz(grid.row_x.factors));
    lerp(1.0, (seen + absolute(seen)) * 0.5, max(clamp(change * (1.0 / SURFACE), 0.0, 1.0), least))
}

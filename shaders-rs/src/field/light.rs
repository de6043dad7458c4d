//! Bilinear look-ups in the light grid.
//!
//! The grid is sheared along the light's initial direction: unoccluded light stays on its texel from plane to plane, so that
//! interpolation does not blur it.

use super::access::read;
use crate::abi::record::light as record;
use crate::abi::sweep::SweepUniforms;
use crate::math::{floor_to_int, lerp, max, select};
use spirv_std::glam::Vec3;

/// Light at a point.
#[derive(Clone, Copy)]
pub struct Light {
    /// Plane irradiance (or radiance, see [`crate::abi::sweep::flag::STORE_RADIANCE`]), linear RGB.
    pub flux: Vec3,
    /// Optical direction v.
    pub direction: Vec3,
}

/// The light grid's coordinates (texel centres are whole numbers) of a point of the sweep frame.
#[inline(always)]
pub fn texel_coordinates(u: &SweepUniforms, point: Vec3) -> (f32, f32) {
    let depth = point.z - u.light_shear.z;
    (
        (point.x - (u.light_grid.x + u.light_shear.x * depth)) * u.light_grid.w - 0.5,
        (point.y - (u.light_grid.y + u.light_shear.y * depth)) * u.light_grid.w - 0.5,
    )
}

/// The point of the sweep frame at texel (x, y) of the plane at `depth`.
#[inline(always)]
pub fn texel_position(u: &SweepUniforms, x: f32, y: f32, depth: f32) -> Vec3 {
    let shift = depth - u.light_shear.z;
    Vec3::new(
        (u.light_grid.x + u.light_shear.x * shift) + (x + 0.5) * u.light_grid.z,
        (u.light_grid.y + u.light_shear.y * shift) + (y + 0.5) * u.light_grid.z,
        depth,
    )
}

/// Where four texels surround a coordinate.
struct Cell {
    base: i32,
    x: f32,
    y: f32,
    inside: bool,
}

#[inline(always)]
fn cell(u: &SweepUniforms, x: f32, y: f32) -> Cell {
    let (right, top) = (u.size.z as i32 as f32 - 1.0, u.size.w as i32 as f32 - 1.0);
    // On the last column or row the fraction is 0, and what is read beyond it does not count.
    let i = floor_to_int(x, 0.0, right);
    let j = floor_to_int(y, 0.0, top);
    Cell {
        base: j * u.size.z as i32 + i,
        x: x - i as f32,
        y: y - j as f32,
        inside: (x >= 0.0) & (x <= right) & (y >= 0.0) & (y <= top),
    }
}

/// Whether the light grid's `components` planes lie inside `buffer`.
#[inline(always)]
pub fn holds(u: &SweepUniforms, buffer: &[f32], components: usize) -> bool {
    buffer.len() as u32 >= u.size.z * u.size.w * components as u32
}

#[inline(always)]
fn interpolate(u: &SweepUniforms, light: &[f32], cell: &Cell, component: usize, outside: f32) -> f32 {
    let at = component as i32 * (u.size.z * u.size.w) as i32 + cell.base;
    let width = u.size.z as i32;
    let near = lerp(read(light, at), read(light, at + 1), cell.x);
    let far = lerp(read(light, at + width), read(light, at + width + 1), cell.x);
    select(cell.inside, lerp(near, far, cell.y), outside)
}

/// The direction at texel coordinates (x, y); beyond the grid, the initial one.
#[inline(always)]
pub fn direction(u: &SweepUniforms, light: &[f32], x: f32, y: f32) -> Vec3 {
    let cell = cell(u, x, y);
    direction_in(u, light, &cell)
}

#[inline(always)]
fn direction_in(u: &SweepUniforms, light: &[f32], cell: &Cell) -> Vec3 {
    Vec3::new(
        interpolate(u, light, cell, record::DIRECTION_X, u.light_direction.x),
        interpolate(u, light, cell, record::DIRECTION_X + 1, u.light_direction.y),
        interpolate(u, light, cell, record::DIRECTION_X + 2, u.light_direction.z),
    )
}

/// The light at texel coordinates (x, y); beyond the grid, unoccluded.
#[inline(always)]
pub fn light(u: &SweepUniforms, light: &[f32], irradiance: &[f32], x: f32, y: f32) -> Light {
    let cell = cell(u, x, y);
    Light {
        flux: Vec3::new(
            interpolate(u, irradiance, &cell, 0, u.light_initial.x),
            interpolate(u, irradiance, &cell, 1, u.light_initial.y),
            interpolate(u, irradiance, &cell, 2, u.light_initial.z),
        ),
        direction: direction_in(u, light, &cell),
    }
}

/// Texels that light with direction `v` moves over `distance` in depth, relative to the sheared grid.
#[inline(always)]
pub fn shift(u: &SweepUniforms, v: Vec3, distance: f32) -> (f32, f32) {
    let inverse = 1.0 / max(v.z, 1e-6);
    let texels = distance * u.light_grid.w;
    ((v.x * inverse - u.light_shear.x) * texels, (v.y * inverse - u.light_shear.y) * texels)
}

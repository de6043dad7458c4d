//! Bilinear look-ups in the light grid.
//!
//! The grid is sheared along the light's initial direction: unoccluded light stays on its texel from plane to plane, so that
//! interpolation does not blur it.

use super::offset;
use crate::abi::record::irradiance as record;
use crate::abi::sweep::{SweepUniforms, flag};
use crate::field::access::read_float;
use crate::math::{floor_to_int, length, lerp, max, select, xyz};
use crate::optics::ambient::irradiance;
use crate::optics::receiver::diffuse;
use crate::sweep::light::placed::{cone, strength};
use crate::sweep::light::wavefront::{from_frame, in_frame, unrefracted_direction};
use spirv_std::glam::Vec3;

/// Light at a point.
#[derive(Clone, Copy)]
pub struct Light {
    /// Plane irradiance (or radiance, see [`crate::abi::sweep::flag::STORE_RADIANCE`]), linear RGB.
    pub flux: Vec3,
    /// Optical direction v.
    pub direction: Vec3,
}

/// The light grid's coordinates (texel centres are whole numbers) of a point of the view frame.
#[inline(always)]
pub fn texel_coordinates(u: &SweepUniforms, point: Vec3) -> (f32, f32) {
    let depth = point.z - u.light_grid.shear_depth;
    (
        (point.x - (u.light_grid.corner_x + u.light_grid.shear_x * depth)) * u.light_grid.inverse_texel - 0.5,
        (point.y - (u.light_grid.corner_y + u.light_grid.shear_y * depth)) * u.light_grid.inverse_texel - 0.5,
    )
}

/// The point of the view frame at texel (x, y) of the plane at `depth`.
#[inline(always)]
pub fn texel_position(u: &SweepUniforms, x: f32, y: f32, depth: f32) -> Vec3 {
    let shift = depth - u.light_grid.shear_depth;
    Vec3::new(
        (u.light_grid.corner_x + u.light_grid.shear_x * shift) + (x + 0.5) * u.light_grid.texel,
        (u.light_grid.corner_y + u.light_grid.shear_y * shift) + (y + 0.5) * u.light_grid.texel,
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
    let (right, top) = (u.light_grid.width as i32 as f32 - 1.0, u.light_grid.height as i32 as f32 - 1.0);
    // On the last column or row the fraction is 0, and what is read beyond it does not count.
    let i = floor_to_int(x, 0.0, right);
    let j = floor_to_int(y, 0.0, top);
    Cell {
        base: j * u.light_grid.width as i32 + i,
        x: x - i as f32,
        y: y - j as f32,
        inside: (x >= 0.0) & (x <= right) & (y >= 0.0) & (y <= top),
    }
}

/// Whether the light grid's `components` planes lie inside `buffer`.
#[inline(always)]
pub fn holds(u: &SweepUniforms, buffer: &[f32], components: usize) -> bool {
    buffer.len() as u32 >= u.light_grid.width * u.light_grid.height * components as u32
}

/// Where a component of the plane behind starts.
#[inline(always)]
fn plane_behind(u: &SweepUniforms, component: usize) -> i32 {
    u.irradiance_start as i32 + component as i32 * (u.light_grid.width * u.light_grid.height) as i32
}

#[inline(always)]
fn interpolate(u: &SweepUniforms, irradiance: &[u32], cell: &Cell, component: usize, outside: f32) -> f32 {
    let at = plane_behind(u, component) + cell.base;
    let width = u.light_grid.width as i32;
    let near = lerp(read_float(irradiance, at), read_float(irradiance, at + 1), cell.x);
    let far = lerp(read_float(irradiance, at + width), read_float(irradiance, at + width + 1), cell.x);
    select(cell.inside, lerp(near, far, cell.y), outside)
}

/// The direction at texel coordinates (x, y); beyond the grid, the initial one.
#[inline(always)]
pub fn direction(u: &SweepUniforms, irradiance: &[u32], x: f32, y: f32) -> Vec3 {
    let cell = cell(u, x, y);
    let (across, up) = offset_in(u, irradiance, &cell);
    offset::direction(u, across, up)
}

/// The light at texel coordinates (x, y); beyond the grid, unoccluded. In a clear medium its colours are those of unoccluded light.
#[inline(always)]
pub fn light(u: &SweepUniforms, irradiance: &[u32], x: f32, y: f32, clear: bool) -> Light {
    let cell = cell(u, x, y);
    let red = interpolate(u, irradiance, &cell, record::SHARE, 1.0);
    let mut share = Vec3::new(red, red, red);
    if !clear {
        share.y = interpolate(u, irradiance, &cell, record::SHARE + 1, 1.0);
        share.z = interpolate(u, irradiance, &cell, record::SHARE + 2, 1.0);
    }
    let (across, up) = offset_in(u, irradiance, &cell);
    Light { flux: share * xyz(u.light.color), direction: offset::direction(u, across, up) }
}

/// How far the direction is from the initial one, see [`offset`].
#[inline(always)]
fn offset_in(u: &SweepUniforms, irradiance: &[u32], cell: &Cell) -> (f32, f32) {
    let at = plane_behind(u, record::DIRECTION) + cell.base;
    let width = u.light_grid.width as i32;
    let corner = |beyond: i32| offset::unpack(read_float(irradiance, at + beyond));
    let (a, b, c, d) = (corner(0), corner(1), corner(width), corner(width + 1));
    let across = lerp(lerp(a.0, b.0, cell.x), lerp(c.0, d.0, cell.x), cell.y);
    let up = lerp(lerp(a.1, b.1, cell.x), lerp(c.1, d.1, cell.x), cell.y);
    (select(cell.inside, across, 0.0), select(cell.inside, up, 0.0))
}

/// Texels that light with direction `v` moves over `distance` in depth, relative to the sheared grid.
#[inline(always)]
pub fn shift(u: &SweepUniforms, v: Vec3, distance: f32) -> (f32, f32) {
    let inverse = 1.0 / max(v.z, 1e-6);
    let texels = distance * u.light_grid.inverse_texel;
    ((v.x * inverse - u.light_grid.shear_x) * texels, (v.y * inverse - u.light_grid.shear_y) * texels)
}

/// Radiance of light at a point: L = E / cos θ where the light buffer holds plane irradiance.
#[inline(always)]
pub fn radiance(u: &SweepUniforms, light: &Light) -> Vec3 {
    let size = length(light.direction);
    let stored = u.flags & flag::STORE_RADIANCE != 0;
    light.flux * select(stored, 1.0, size / max(light.direction.z, 1e-6 * size))
}

/// Radiance that a receiver sends back.
#[inline(always)]
pub fn shade(u: &SweepUniforms, normal: Vec3, color: Vec3, light: &Light) -> Vec3 {
    let ambient = irradiance(&u.ambient, &u.environment, normal);
    diffuse(color, normal, light.direction, radiance(u, light), ambient)
}

/// The light at a point of the view frame where nothing is in its way.
#[inline(always)]
pub fn unoccluded(u: &SweepUniforms, at: Vec3) -> Light {
    let w = &u.wavefront;
    if w.spherical != 0 {
        let inside = in_frame(w, at);
        let flux = xyz(u.light.color) * (strength(w, inside) * cone(w, inside));
        Light { flux, direction: from_frame(w, unrefracted_direction(w, inside)) }
    } else {
        Light { flux: xyz(u.light.color), direction: xyz(u.light.direction) }
    }
}

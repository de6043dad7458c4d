//! The maps of light on receivers: from a cell's coordinates to texels and back, and look-ups.
//!
//! Within the grid a cell has as many texels everywhere. At o cells beyond the grid's end a texel is (1 + o/f)² times as wide, where f is the width of
//! the margin in cells: o becomes o f / (f + o), so that the margin holds the whole rest of the plane.

use crate::abi::record::received;
use crate::abi::sweep::{SweepUniforms, flag};
use crate::abi::wavefront::Wavefront;
use crate::field::access::read_float;
use crate::math::xyz;
use crate::math::{floor_to_int, lerp, max, min, select};
use crate::sweep::light::look_up::{Light, unoccluded};
use crate::sweep::light::placed::{cone, strength, way};
use crate::sweep::light::wavefront::{coordinates, from_frame, in_frame, unrefracted_direction};
use spirv_std::glam::{Vec2, Vec3};

/// The distance beyond the grid's end as the margin holds it, in the unit of `margin`.
#[inline(always)]
fn compressed(beyond: f32, margin: f32) -> f32 {
    let beyond = max(beyond, 0.0);
    beyond * margin / max(margin + beyond, 1e-12)
}

/// The distance that [`compressed`] makes `within`.
#[inline(always)]
fn stretched(within: f32, margin: f32) -> f32 {
    let within = max(within, 0.0);
    within * margin / max(margin - within, margin * 1e-6)
}

/// Texels from the map's edge to coordinate `x` of a grid of `count` cells.
#[inline(always)]
fn texels(w: &Wavefront, x: f32, count: u32) -> f32 {
    let count = count as i32 as f32;
    let inner = min(max(x, 0.0), count) * w.map.texels;
    let beyond = compressed((x - count) * w.map.texels, w.map.margin) - compressed(-x * w.map.texels, w.map.margin);
    w.map.margin + inner + beyond
}

/// The coordinate that [`texels`] takes to `at`.
#[inline(always)]
fn cells(w: &Wavefront, at: f32, count: u32) -> f32 {
    let inner = count as i32 as f32 * w.map.texels;
    let x = at - w.map.margin;
    let within = min(max(x, 0.0), inner);
    (within + stretched(x - inner, w.map.margin) - stretched(-x, w.map.margin)) / w.map.texels
}

/// The place of coordinates, in texels; centres of texels are whole numbers.
#[inline(always)]
pub fn place(w: &Wavefront, at: Vec2) -> Vec2 {
    Vec2::new(texels(w, at.x, w.cells.width) - 0.5, texels(w, at.y, w.cells.height) - 0.5)
}

/// Coordinates of the middle of texel (x, y), and the texel's area in cells.
#[inline(always)]
pub fn texel(w: &Wavefront, x: u32, y: u32) -> (Vec2, f32) {
    let (i, j) = (x as i32 as f32, y as i32 as f32);
    let (width, height) = (w.cells.width, w.cells.height);
    let area = (cells(w, i + 1.0, width) - cells(w, i, width)) * (cells(w, j + 1.0, height) - cells(w, j, height));
    (Vec2::new(cells(w, i + 0.5, width), cells(w, j + 0.5, height)), area)
}

/// A component between four texels, the first of which is word `at`.
#[inline(always)]
fn between(light: &[u32], at: i32, columns: i32, (s, t): (f32, f32)) -> f32 {
    let below = lerp(read_float(light, at), read_float(light, at + 1), s);
    let above = lerp(read_float(light, at + columns), read_float(light, at + columns + 1), s);
    lerp(below, above, t)
}

/// The irradiance of a receiver at a point of the wavefront's frame over that of unoccluded light, of a point or spot over that of one that shines to all
/// sides.
#[inline(always)]
pub fn share_on(w: &Wavefront, light: &[u32], inside: Vec3, wall: bool) -> Vec3 {
    let (columns, rows) = (w.map.size.width as i32, w.map.size.height as i32);
    let place = place(w, coordinates(w, inside));
    let i = floor_to_int(place.x, 0.0, (columns - 2) as f32);
    let j = floor_to_int(place.y, 0.0, (rows - 2) as f32);
    let (s, t) = (min(max(place.x - i as f32, 0.0), 1.0), min(max(place.y - j as f32, 0.0), 1.0));
    let start = if wall { w.map.wall } else { w.map.ground } as i32 + j * columns + i;
    let texels = columns * rows;
    let share = Vec3::new(
        between(light, start + received::SHARE as i32 * texels, columns, (s, t)),
        between(light, start + (received::SHARE + 1) as i32 * texels, columns, (s, t)),
        between(light, start + (received::SHARE + 2) as i32 * texels, columns, (s, t)),
    );
    if w.spherical != 0 {
        // Of the light of a point or spot the map has what is changed.
        let cone = cone(w, inside);
        // A spherical wavefront has no coordinates behind its source.
        let ahead = select(way(w, inside).z > 0.0, 1.0, 0.0);
        let all = share * ahead + Vec3::new(cone, cone, cone);
        Vec3::new(max(all.x, 0.0), max(all.y, 0.0), max(all.z, 0.0))
    } else {
        share
    }
}

/// The light on a receiver at a point of the view frame: its flux is the radiance of light that has the same irradiance and the direction of
/// unrefracted light.
#[inline(always)]
pub fn light_on(u: &SweepUniforms, light: &[u32], at: Vec3, wall: bool) -> Light {
    let w = &u.wavefront;
    let inside = in_frame(w, at);
    let direction = from_frame(w, unrefracted_direction(w, inside));
    let forward = u.flags & flag::FORWARD != 0;
    if forward {
        let share = share_on(w, light, inside, wall) * strength(w, inside);
        Light { flux: xyz(u.light.color) * share, direction }
    } else {
        unoccluded(u, at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::abi::vector::Size;
    use crate::abi::wavefront::ReceiverMap;

    #[test]
    fn texels_come_back_as_coordinates() {
        let map =
            ReceiverMap { size: Size { width: 48, height: 48 }, texels: 2.0, margin: 8.0, ..ReceiverMap::default() };
        let w = Wavefront { cells: Size { width: 16, height: 16 }, map, ..Wavefront::default() };
        for x in [-1000.0f32, -20.0, -3.5, 0.0, 0.3, 7.75, 16.0, 18.5, 300.0] {
            let at = texels(&w, x, 16);
            assert!((0.0..=48.0).contains(&at), "{x} is at {at}");
            let back = cells(&w, at, 16);
            assert!((back - x).abs() < 1e-3 * (1.0 + x.abs()), "{x} became {back}");
        }
        let areas: f32 = (0..48).map(|i| texel(&w, i, 20).1).sum();
        assert!(areas > 1000.0 && (texel(&w, 20, 20).1 - 0.25).abs() < 1e-6);
    }
}

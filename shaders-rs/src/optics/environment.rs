//! What a ray sees behind everything (sweep §4.4).

use crate::abi::environment::{Environment, kind};
use crate::field::access::read_vector;
use crate::math::{PI, absolute, asin, atan2, clamp, dot, floor_to_int, limit, log2, max, select, sqrt, xyz};
use spirv_std::glam::Vec3;

/// A direction in the environment's frame (z up).
#[inline(always)]
pub fn in_environment(u: &Environment, d: Vec3) -> Vec3 {
    Vec3::new(dot(xyz(u.row_x), d), dot(xyz(u.row_y), d), dot(xyz(u.row_z), d))
}

/// Radiance of the environment in direction `d`, averaged over about `angle` radians.
#[inline(always)]
pub fn environment(u: &Environment, map: &[f32], d: Vec3, angle: f32) -> Vec3 {
    let pattern = u.kind;
    let color = xyz(u.color);
    let horizon = xyz(u.horizon);
    if pattern == kind::COLOR {
        color
    } else if pattern == kind::GRADIENT {
        let up = clamp(d.z, -1.0, 1.0);
        let end = if up > 0.0 { color } else { xyz(u.nadir) };
        horizon + (end - horizon) * sqrt(absolute(up))
    } else if pattern == kind::CHECKERBOARD {
        checkerboard(u, d, angle, color, horizon)
    } else {
        equirectangular(u, map, d, angle) * u.intensity
    }
}

/// Squares in longitude and latitude; where a pixel covers more than a square, their mean.
#[inline(always)]
fn checkerboard(u: &Environment, d: Vec3, angle: f32, even: Vec3, odd: Vec3) -> Vec3 {
    let square = u.square;
    let soft = max(angle / square, 1e-4);
    let across = wave(atan2(d.y, d.x) / square, soft / max(sqrt(1.0 - d.z * d.z), 1e-3));
    let up = wave(asin(d.z) / square, soft);
    let mix = 0.5 + 0.5 * across * up;
    even + (odd - even) * mix
}

/// A square wave of period 2, its edges `width` wide, fading to 0 as `width` grows.
#[inline(always)]
fn wave(x: f32, width: f32) -> f32 {
    let half = x * 0.5;
    let phase = (half - floor_to_int(half, -8e6, 8e6) as f32) * 2.0;
    // Distance to the next edge (at 0, 1 and 2), positive in the first half.
    let distance = select(phase < 0.5, phase, select(phase < 1.5, 1.0 - phase, phase - 2.0));
    clamp(distance * 2.0 / width, -1.0, 1.0) * clamp(2.0 - width, 0.0, 1.0)
}

/// An equirectangular map, trilinear between the two levels whose texels are about `angle` wide.
#[inline(always)]
fn equirectangular(u: &Environment, map: &[f32], d: Vec3, angle: f32) -> Vec3 {
    let width = u.map_width as i32 as f32;
    let levels = u.map_levels as i32 as f32;
    let level = clamp(log2(max(angle * width / (2.0 * PI), 1e-6)), 0.0, levels - 1.0);
    let lower = floor_to_int(level, 0.0, max(levels - 2.0, 0.0));
    let longitude = 0.5 - atan2(d.x, d.y) / (2.0 * PI);
    let latitude = 0.5 - asin(d.z) / PI;
    let a = texel(u, map, longitude, latitude, lower);
    let b = texel(u, map, longitude, latitude, lower + 1);
    a + (b - a) * clamp(level - lower as f32, 0.0, 1.0)
}

/// A column of a map `width` texels wide; columns wrap around.
#[inline(always)]
fn wrap(x: i32, width: i32) -> i32 {
    let x = if x < 0 { x + width } else { x };
    if x >= width { x - width } else { x }
}

/// Bilinear look-up in one level; longitude wraps around.
#[inline(always)]
fn texel(u: &Environment, map: &[f32], longitude: f32, latitude: f32, level: i32) -> Vec3 {
    let mut width = u.map_width as i32;
    let mut height = u.map_height as i32;
    let mut start = 0;
    let mut i = 0;
    while i < level {
        start += width * height;
        width = if width > 1 { width >> 1 } else { 1 };
        height = if height > 1 { height >> 1 } else { 1 };
        i += 1;
    }
    let x = longitude * width as f32 - 0.5;
    let y = latitude * height as f32 - 0.5;
    let left = floor_to_int(x, -1.0, width as f32);
    let top = floor_to_int(y, -1.0, height as f32);
    let (fx, fy) = (x - left as f32, clamp(y - top as f32, 0.0, 1.0));
    let (x0, x1) = (wrap(left, width), wrap(left + 1, width));
    let (y0, y1) = (limit(top, height), limit(top + 1, height));
    let (upper_row, lower_row) = (start + y0 * width, start + y1 * width);
    let (a, b) = (read_vector(map, 3 * (upper_row + x0)), read_vector(map, 3 * (upper_row + x1)));
    let (c, d) = (read_vector(map, 3 * (lower_row + x0)), read_vector(map, 3 * (lower_row + x1)));
    let upper = a + (b - a) * fx;
    let lower = c + (d - c) * fx;
    upper + (lower - upper) * fy
}

//! Finished pixels: receivers beyond the last plane, the environment, the outputs (sweep §4.4).

use crate::abi::environment::kind;
use crate::abi::record::{film, ray, status};
use crate::abi::sweep::SweepUniforms;
use crate::field::access::read;
use crate::math::{
    PI, absolute, asin, atan2, clamp, dot, floor_to_int, length, lerp, log2, max, min, select, sqrt, xyz,
};
use crate::optics::receiver::{first_along, shade, unoccluded};
use crate::optics::step::flight;
use spirv_std::glam::Vec3;

/// A ray's final unit direction in the environment's frame (z up).
#[inline(always)]
fn final_direction(u: &SweepUniforms, rays: &[f32], at: i32) -> Vec3 {
    let count = (u.size.x * u.size.y) as i32;
    let component = |c: usize| read(rays, c as i32 * count + at);
    let v = Vec3::new(component(ray::DIRECTION_X), component(ray::DIRECTION_X + 1), component(ray::DIRECTION_X + 2));
    let unit = v * (1.0 / max(length(v), 1e-20));
    Vec3::new(dot(xyz(u.environment_x), unit), dot(xyz(u.environment_y), unit), dot(xyz(u.environment_z), unit))
}

/// The angle, in radians, over which a pixel gathers directions, from its neighbours' final directions.
#[inline(always)]
fn spread(u: &SweepUniforms, rays: &[f32], x: i32, y: i32) -> f32 {
    let (width, height) = (u.size.x as i32, u.size.y as i32);
    let left = if x > 0 { x - 1 } else { 0 };
    let right = if x < width - 1 { x + 1 } else { width - 1 };
    let above = if y > 0 { y - 1 } else { 0 };
    let below = if y < height - 1 { y + 1 } else { height - 1 };
    let across = length(final_direction(u, rays, y * width + right) - final_direction(u, rays, y * width + left));
    let down = length(final_direction(u, rays, below * width + x) - final_direction(u, rays, above * width + x));
    max(across / max((right - left) as f32, 1.0), down / max((below - above) as f32, 1.0))
}

/// Radiance of the environment in direction `d`, averaged over about `angle` radians.
#[inline(always)]
fn environment(u: &SweepUniforms, map: &[f32], d: Vec3, angle: f32) -> Vec3 {
    let pattern = u.environment.x;
    let color = xyz(u.environment_color);
    let horizon = xyz(u.environment_horizon);
    if pattern == kind::COLOR {
        color
    } else if pattern == kind::GRADIENT {
        let up = clamp(d.z, -1.0, 1.0);
        let end = if up > 0.0 { color } else { xyz(u.environment_nadir) };
        horizon + (end - horizon) * sqrt(absolute(up))
    } else if pattern == kind::CHECKERBOARD {
        checkerboard(u, d, angle, color, horizon)
    } else {
        equirectangular(u, map, d, angle) * u.environment_horizon.w
    }
}

/// Squares in longitude and latitude; where a pixel covers more than a square, their mean.
#[inline(always)]
fn checkerboard(u: &SweepUniforms, d: Vec3, angle: f32, even: Vec3, odd: Vec3) -> Vec3 {
    let square = u.environment_color.w;
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
fn equirectangular(u: &SweepUniforms, map: &[f32], d: Vec3, angle: f32) -> Vec3 {
    let width = u.environment.y as i32 as f32;
    let levels = u.environment.w as i32 as f32;
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

/// A row of a map `height` texels high.
#[inline(always)]
fn limit(y: i32, height: i32) -> i32 {
    let y = if y < 0 { 0 } else { y };
    if y >= height { height - 1 } else { y }
}

#[inline(always)]
fn rgb_at(map: &[f32], at: i32) -> Vec3 {
    Vec3::new(read(map, at), read(map, at + 1), read(map, at + 2))
}

/// Bilinear look-up in one level; longitude wraps around.
#[inline(always)]
fn texel(u: &SweepUniforms, map: &[f32], longitude: f32, latitude: f32, level: i32) -> Vec3 {
    let mut width = u.environment.y as i32;
    let mut height = u.environment.z as i32;
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
    let (a, b) = (rgb_at(map, 3 * (upper_row + x0)), rgb_at(map, 3 * (upper_row + x1)));
    let (c, d) = (rgb_at(map, 3 * (lower_row + x0)), rgb_at(map, 3 * (lower_row + x1)));
    let upper = a + (b - a) * fx;
    let lower = c + (d - c) * fx;
    upper + (lower - upper) * fy
}

/// The finished pixel (x, y).
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &SweepUniforms, _mode: u32, rays: &[f32], map: &[f32]) -> [f32; film::SIZE] {
    let at = (y * u.size.x + x) as i32;
    let count = (u.size.x * u.size.y) as i32;
    let component = |c: usize| read(rays, c as i32 * count + at);
    let vector = |c: usize| Vec3::new(component(c), component(c + 1), component(c + 2));
    let fate = component(ray::STATUS);
    let mut color = vector(ray::COLOR);
    let mut opacity = component(ray::OPACITY);
    let mut depth_sum = component(ray::DEPTH);
    let medium = vector(ray::MEDIUM);
    let v = vector(ray::DIRECTION_X);
    let unit = v * (1.0 / max(length(v), 1e-20));
    let under_way = fate == status::ACTIVE;
    let last = Vec3::new(component(ray::X), component(ray::Y), component(ray::Z));
    let position = last + v * select(under_way, flight(v, u.plane.y - last.z), 0.0);

    // Beyond the last plane rays are straight and light is unoccluded.
    let hit = first_along(u, position, unit);
    let seen = shade(u, &hit, &unoccluded(u));
    let met = under_way & hit.hit;
    let clear = select(met, 1.0 - opacity, 0.0);
    color += (medium * seen) * clear;
    opacity += clear;
    depth_sum += clear * (position.z + unit.z * hit.at);

    let left = 1.0 - opacity;
    let behind = environment(u, map, final_direction(u, rays, at), spread(u, rays, x as i32, y as i32));
    let visible = u.environment_nadir.w;
    color += (medium * behind) * (left * visible);
    // Without an environment the picture is transparent where light would come through.
    let passes = left * ((medium.x + medium.y) + medium.z) * (1.0 / 3.0);
    let coverage = lerp(1.0 - passes, 1.0, visible);
    [
        color.x,
        color.y,
        color.z,
        coverage,
        opacity,
        medium.x,
        medium.y,
        medium.z,
        depth_sum / max(opacity, 1e-12),
        unit.x,
        unit.y,
        -unit.z,
        position.x,
        position.y,
        -position.z,
        min(fate, status::TURNED),
    ]
}

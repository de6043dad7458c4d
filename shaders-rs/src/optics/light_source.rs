//! Light that arrives at a point from a distant light, a point or a spot.

use crate::abi::light::{Cone, LightSource, kind};
use crate::field::access::read_vector;
use crate::math::{clamp, dot, floor_to_int, max, select, sqrt, xyz};
use spirv_std::glam::Vec3;

/// The least squared distance from a light, in voxels: nothing is as near.
const NEAREST: f32 = 1e-12;

/// Light that arrives at a point from which nothing hides its source.
#[derive(Clone, Copy)]
pub struct Arriving {
    /// Unit direction in which it travels.
    pub direction: Vec3,
    /// Radiance of a white diffuse surface that faces it: irradiance over π, linear RGB.
    pub radiance: Vec3,
}

/// The light that arrives at `position` from a source. Of points and spots it falls with the square of the distance.
#[inline(always)]
pub fn arriving(source: &LightSource, pictures: &[f32], position: Vec3) -> Arriving {
    let color = xyz(source.color);
    if source.kind == kind::DISTANT {
        Arriving { direction: xyz(source.direction), radiance: color }
    } else {
        let way = position - xyz(source.position);
        let squared = max(dot(way, way), NEAREST);
        let radiance = color * (1.0 / squared);
        let shaped = if source.kind == kind::SPOT {
            radiance * in_cone(&source.cone, xyz(source.direction), pictures, way)
        } else {
            radiance
        };
        Arriving { direction: way * (1.0 / sqrt(squared)), radiance: shaped }
    }
}

/// Radiance of a white diffuse surface at `position` that faces the source, from which nothing hides it, as if it shone to all sides.
#[inline(always)]
pub fn to_all_sides(source: &LightSource, position: Vec3) -> Vec3 {
    let color = xyz(source.color);
    let way = position - xyz(source.position);
    let falls = 1.0 / max(dot(way, way), NEAREST);
    color * select(source.kind == kind::DISTANT, 1.0, falls)
}

/// The share of a spot's light along `way`, linear RGB: its cone and the picture that it projects.
#[inline(always)]
fn in_cone(cone: &Cone, axis: Vec3, pictures: &[f32], way: Vec3) -> Vec3 {
    let along = dot(axis, way);
    let inverse = 1.0 / max(along, 1e-20);
    let (x, y) = (dot(xyz(cone.right), way) * inverse, dot(xyz(cone.up), way) * inverse);
    let inside = clamp((cone.tangent - sqrt(x * x + y * y)) * cone.slope, 0.0, 1.0);
    let share = select(along > 0.0, inside * inside * (3.0 - 2.0 * inside), 0.0);
    if (cone.width > 0) & (share > 0.0) {
        let half = 0.5 / cone.tangent;
        texel(cone, pictures, 0.5 + x * half, 0.5 - y * half) * share
    } else {
        Vec3::new(share, share, share)
    }
}

/// Bilinear look-up in a spot's picture; `across` and `down` run from 0 to 1 over it.
#[inline(always)]
fn texel(cone: &Cone, pictures: &[f32], across: f32, down: f32) -> Vec3 {
    let (width, height) = (cone.width as i32, cone.height as i32);
    let (right, bottom) = ((width - 1) as f32, (height - 1) as f32);
    let (x, y) = (clamp(across * width as f32 - 0.5, 0.0, right), clamp(down * height as f32 - 0.5, 0.0, bottom));
    let (column, row) = (floor_to_int(x, 0.0, right), floor_to_int(y, 0.0, bottom));
    let (fx, fy) = (x - column as f32, y - row as f32);
    let next_column = if column + 1 < width { column + 1 } else { column };
    let next_row = if row + 1 < height { row + 1 } else { row };
    let at = |column: i32, row: i32| read_vector(pictures, cone.first as i32 + 3 * (row * width + column));
    let (a, b) = (at(column, row), at(next_column, row));
    let (c, d) = (at(column, next_row), at(next_column, next_row));
    let (upper, lower) = (a + (b - a) * fx, c + (d - c) * fx);
    upper + (lower - upper) * fy
}

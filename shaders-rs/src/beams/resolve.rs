//! Finished pixels: surfaces and environment, airlight, volume caustics without the volumetric shadow (the composition A + B + C of Hu et al. 2010,
//! Fig. 2).

use super::pyramid::{size, sums_of};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{BeamPixel, Sight, beam_pixel, sight};
use crate::abi::vector::Size;
use crate::field::sums::sum;
use crate::kernel::record;
use crate::math::{clamp, dot, floor_to_int, length, limit, max, select, xyz};
use crate::optics::receiver::FAR;
use spirv_std::glam::Vec3;

/// The sums of a pixel of a level, radiance; the pixel is limited to the level.
#[inline(always)]
fn level_at(u: &BeamsUniforms, sums: &[u32], level: u32, column: i32, row: i32) -> Vec3 {
    let Size { width, height } = size(u.picture, level);
    let at = sums_of(u, level, limit(column, width as i32), limit(row, height as i32));
    Vec3::new(sum(sums, at), sum(sums, at + 2), sum(sums, at + 4))
}

/// The in-scattered radiance of a pixel: the sum over the levels, each interpolated between the centres of its pixels.
#[inline(always)]
fn inscattered(u: &BeamsUniforms, sums: &[u32], column: i32, row: i32) -> Vec3 {
    let mut whole = level_at(u, sums, 0, column, row);
    let mut level = 1;
    while level <= u.sums.levels {
        let inverse = 1.0 / (1 << level) as f32;
        let (x, y) = ((column as f32 + 0.5) * inverse - 0.5, (row as f32 + 0.5) * inverse - 0.5);
        let (left, top) = (floor_to_int(x, -1.0, 1e6), floor_to_int(y, -1.0, 1e6));
        let (fx, fy) = (x - left as f32, y - top as f32);
        let upper = level_at(u, sums, level, left, top) * (1.0 - fx) + level_at(u, sums, level, left + 1, top) * fx;
        let lower =
            level_at(u, sums, level, left, top + 1) * (1.0 - fx) + level_at(u, sums, level, left + 1, top + 1) * fx;
        whole += upper * (1.0 - fy) + lower * fy;
        level += 1;
    }
    whole * (1.0 / u.sums.scale)
}

/// The finished pixel (x, y).
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    sights: &[f32],
    caustics: &[u32],
    shadows: &[u32],
) -> [f32; beam_pixel::SIZE] {
    let count = u.dispatch.width * u.dispatch.height;
    let seen = Sight::load(&record::load::<{ sight::SIZE }>(sights, y * u.dispatch.width + x, count));
    let caustics = inscattered(u, caustics, x as i32, y as i32) + seen.caustics;
    let shadow = inscattered(u, shadows, x as i32, y as i32) + seen.shadow;
    let lit = seen.airlight - shadow;
    // Where all light is taken away, what rounding leaves may be negative.
    let lit = Vec3::new(max(lit.x, 0.0), max(lit.y, 0.0), max(lit.z, 0.0));
    let (across, upwards) = super::viewing::on_plane(u, x as i32 as f32, y as i32 as f32);
    let (_, aim) = super::viewing::through(u, across, upwards);
    let cosine = dot(xyz(u.away), aim) / length(aim);
    let normal = Vec3::new(dot(xyz(u.right), seen.normal), dot(xyz(u.up), seen.normal), -dot(xyz(u.away), seen.normal));
    BeamPixel {
        color: seen.radiance + lit + caustics + seen.multiple,
        coverage: clamp(seen.coverage, 0.0, 1.0),
        surfaces: seen.radiance,
        airlight: seen.airlight,
        caustics,
        shadow,
        multiple: seen.multiple,
        depth: select(seen.depth < 0.5 * FAR, seen.depth * cosine * u.voxel, 0.0),
        normal,
    }
    .store()
}

//! Viewing rays on the first plane (Algorithm 1, line 1).

use super::tiles::pixel;
use crate::abi::record::{ray, status};
use crate::abi::sweep::SweepUniforms;
use crate::math::{length, select};
use crate::optics::receiver::{first_between, shade, unoccluded};
use spirv_std::glam::Vec3;

/// Viewing ray (x, y), that of [`pixel`], row 0 on top, where it meets the first plane. A receiver in front of that plane ends it.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &SweepUniforms, _mode: u32) -> [f32; ray::SIZE] {
    let (x, y) = pixel(u.size.x, u.size.y, x, y);
    let across = ((x as i32 as f32 + 0.5) / (u.size.x as i32 as f32) * 2.0 - 1.0) * u.camera.x;
    let up = (1.0 - (y as i32 as f32 + 0.5) / (u.size.y as i32 as f32) * 2.0) * u.camera.y;
    let orthographic = u.camera.w > 0.5;
    let depth = u.camera.z;
    let direction = Vec3::new(select(orthographic, 0.0, across), select(orthographic, 0.0, up), 1.0);
    let origin = Vec3::new(select(orthographic, across, 0.0), select(orthographic, up, 0.0), 0.0);
    let start = origin + direction * depth;
    // Outside every volume η is 1: the optical direction has unit length.
    let v = direction * (1.0 / length(direction));

    let hit = first_between(u, origin, start);
    let seen = shade(u, &hit, &unoccluded(u));
    [
        start.x,
        start.y,
        v.x,
        v.y,
        v.z,
        0.0,
        select(hit.hit, status::ENDED, status::ACTIVE),
        select(hit.hit, hit.at * depth, 0.0),
        select(hit.hit, seen.x, 0.0),
        select(hit.hit, seen.y, 0.0),
        select(hit.hit, seen.z, 0.0),
        select(hit.hit, 1.0, 0.0),
        1.0,
        1.0,
        1.0,
        1.0,
        start.z,
        ray::NOWHERE,
    ]
}

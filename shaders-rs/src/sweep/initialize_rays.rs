//! Viewing rays on the first plane (Algorithm 1, line 1).

use super::place::place;
use super::tiles::pixel;
use crate::abi::record::{Ray, ray, status};
use crate::abi::sweep::SweepUniforms;
use crate::math::{min, normalize, select, select_vector};
use crate::optics::receiver::first_between;
use crate::sweep::light::look_up::shade;
use crate::sweep::light::receiver_map::light_on;
use spirv_std::glam::Vec3;

/// The viewing ray at the [`place`] of [`pixel`] (x, y), row 0 on top, where it meets the first plane. A receiver in front of that plane ends it.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &SweepUniforms, _mode: u32, light: &[u32], pixels: &[u32]) -> [f32; ray::SIZE] {
    let (x, y) = pixel(u.picture.width, u.picture.height, x, y);
    let (x, y) = place(u, pixels, x, y);
    let across = ((x as i32 as f32 + 0.5) / (u.sensor.width as i32 as f32) * 2.0 - 1.0) * u.camera.half_width;
    let up = (1.0 - (y as i32 as f32 + 0.5) / (u.sensor.height as i32 as f32) * 2.0) * u.camera.half_height;
    let orthographic = u.camera.orthographic != 0;
    let depth = u.camera.start;
    let direction = Vec3::new(select(orthographic, 0.0, across), select(orthographic, 0.0, up), 1.0);
    let origin = Vec3::new(select(orthographic, across, 0.0), select(orthographic, up, 0.0), 0.0);
    let start = origin + direction * depth;
    // Outside every volume η is 1: the optical direction has unit length. A ray that begins inside one gets the length there with its first
    // sample.
    let v = normalize(direction);

    let hit = first_between(&u.receivers, origin, start);
    let seen =
        shade(u, hit.normal, hit.color, &light_on(u, light, origin + (start - origin) * min(hit.at, 1.0), hit.is_wall));
    let ray = Ray {
        position: start,
        direction: v,
        scalar: 0.0,
        status: select(hit.hit, status::ENDED, status::ACTIVE),
        depth: select(hit.hit, hit.at * depth, 0.0),
        color: select_vector(hit.hit, seen, Vec3::new(0.0, 0.0, 0.0)),
        opacity: select(hit.hit, 1.0, 0.0),
        transmittance: Vec3::new(1.0, 1.0, 1.0),
        ior: 0.0,
        sampled: ray::NOWHERE,
        layer_ior: 0.0,
        reflectance: 0.0,
        mirrored: Vec3::new(0.0, 0.0, 0.0),
    };
    ray.store()
}

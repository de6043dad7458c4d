//! Viewing rays from the eye to the box of all surfaces, or to a receiver in front of it (Chang et al. 2010, §4.1.1: a ray through the
//! centre of each pixel).

use super::ray::{Ray, bounds, first_receiver, reciprocal, slab};
use crate::abi::receivers::ahead;
use crate::abi::record::{fate, path};
use crate::abi::voxels::{VoxelsUniforms, flag};
use crate::math::{max, normalize, select, xyz};
use spirv_std::glam::Vec3;

/// The viewing ray through the centre of pixel (x, y), row 0 on top.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &VoxelsUniforms, _mode: u32) -> [f32; path::SIZE] {
    let (width, height) = (u.dispatch.width as i32 as f32, u.dispatch.height as i32 as f32);
    let across = ((x as i32 as f32 + 0.5) / width * 2.0 - 1.0) * u.camera.half_width;
    let upwards = (1.0 - (y as i32 as f32 + 0.5) / height * 2.0) * u.camera.half_height;
    let eye = xyz(u.eye);
    let side = xyz(u.right) * across + xyz(u.up) * upwards;
    let orthographic = u.camera.orthographic != 0;
    let aim = if orthographic { xyz(u.away) } else { xyz(u.away) + side };
    let from = if orthographic { eye + side } else { eye };
    let direction = normalize(aim);
    let inverse = Vec3::new(reciprocal(direction.x), reciprocal(direction.y), reciprocal(direction.z));
    let (low, high) = bounds(u);
    let (enters, leaves) = slab(from, inverse, low, high);
    let receiver = first_receiver(u, from, direction);
    let enters_at = max(enters, 0.0);
    let met = receiver.which != ahead::NOTHING;
    let misses = (leaves <= enters) | (leaves <= 0.0) | (met & (receiver.distance <= enters_at));
    let distance = select(misses, select(met, receiver.distance, 0.0), enters_at);
    let under_way = select(u.flags & flag::SEEKS != 0, fate::SEEKS, fate::ACTIVE);
    let ray = Ray {
        status: select(misses, select(met, fate::MET, fate::LEFT), under_way),
        depth: distance,
        triangle: receiver.which,
        distance: receiver.distance - distance,
        ..Ray::straight(from + direction * distance, direction)
    };
    ray.store()
}

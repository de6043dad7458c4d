//! Viewing rays as they start at the eye, through the centres of pixels.

use super::emission::Start;
use super::spread::Spread;
use crate::abi::beams::BeamsUniforms;
use crate::math::{dot, length, select_vector, xyz};
use spirv_std::glam::Vec3;

/// The viewing ray through the point (`across`, `upwards`) of the picture's plane, in the camera's unit, from the eye on.
#[inline(always)]
pub fn through(u: &BeamsUniforms, across: f32, upwards: f32) -> (Vec3, Vec3) {
    let side = xyz(u.right) * across + xyz(u.up) * upwards;
    let orthographic = u.camera.orthographic != 0;
    let aim = select_vector(orthographic, xyz(u.away), xyz(u.away) + side);
    let from = select_vector(orthographic, xyz(u.eye) + side, xyz(u.eye));
    (from, aim)
}

/// The coordinates in the picture's plane, in the camera's unit, of the point (`x`, `y`) in pixels, from the centre of the first pixel on.
#[inline(always)]
pub fn on_plane(u: &BeamsUniforms, x: f32, y: f32) -> (f32, f32) {
    let (width, height) = (u.picture.width as i32 as f32, u.picture.height as i32 as f32);
    let across = ((x + 0.5) / width * 2.0 - 1.0) * u.camera.half_width;
    let upwards = (1.0 - (y + 0.5) / height * 2.0) * u.camera.half_height;
    (across, upwards)
}

/// The viewing ray of pixel (`column`, `row`).
#[inline(always)]
pub fn start(u: &BeamsUniforms, column: i32, row: i32) -> Start {
    let (width, height) = (u.picture.width as i32 as f32, u.picture.height as i32 as f32);
    let (across, upwards) = on_plane(u, column as f32, row as f32);
    let (position, aim) = through(u, across, upwards);
    let inverse = 1.0 / length(aim);
    let direction = aim * inverse;
    let step_u = xyz(u.right) * (2.0 * u.camera.half_width / width);
    let step_v = xyz(u.up) * (-2.0 * u.camera.half_height / height);
    let orthographic = u.camera.orthographic != 0;
    let zero = Vec3::new(0.0, 0.0, 0.0);
    let turned = |step: Vec3| (step - direction * dot(step, direction)) * inverse;
    Start {
        position,
        direction,
        spread: Spread {
            position_u: select_vector(orthographic, step_u, zero),
            position_v: select_vector(orthographic, step_v, zero),
            direction_u: select_vector(orthographic, zero, turned(step_u)),
            direction_v: select_vector(orthographic, zero, turned(step_v)),
        },
    }
}

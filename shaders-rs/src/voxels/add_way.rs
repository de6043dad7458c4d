//! Pixels with the light of one way more ([`super::follow`]).

use super::ending::{Beside, brought};
use super::mirror::vector;
use super::surface::sum;
use crate::abi::record::{MeshPixel, path, view};
use crate::abi::voxels::VoxelsUniforms;
use crate::field::access::read;

pub use super::ray::level;

#[inline(always)]
fn place(x: u32, y: u32, u: &VoxelsUniforms) -> i32 {
    (y * u.dispatch.width + x) as i32
}

/// Whether the pixel's ray brings any light.
#[inline(always)]
pub fn level(
    x: u32,
    y: u32,
    u: &VoxelsUniforms,
    _mode: u32,
    _before: [f32; view::SIZE],
    rays: &[f32],
    _pictures: &[f32],
    _corners: &[f32],
    _looks: &[f32],
    _shadow: &[u32],
) -> u32 {
    let at = place(x, y, u);
    let left = sum(vector(u, rays, at, path::TRANSMITTANCE)) + sum(vector(u, rays, at, path::REST));
    if left > 0.0 { level::WORK } else { level::ENDED }
}

/// The pixel, with that light.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &VoxelsUniforms,
    mode: u32,
    before: [f32; view::SIZE],
    rays: &[f32],
    pictures: &[f32],
    corners: &[f32],
    looks: &[f32],
    shadow: &[u32],
) -> [f32; view::SIZE] {
    let at = place(x, y, u);
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    let component = |c: usize| read(rays, c as i32 * count + at);
    let beside = Beside::new(u, rays, x as i32, y as i32, component(path::BOUNCES), component(path::STATUS));
    let mut pixel = MeshPixel::load(&before);
    pixel.color += brought(u, mode, at, &beside, rays, pictures, corners, looks, shadow).radiance;
    pixel.store()
}

//! Finished pixels: receivers beyond the last plane, the environment, the outputs (sweep §4.4).

use super::place::beside;
use super::tiles;
use crate::abi::receivers::ahead;
use crate::abi::record::{Pixel, film, ray, status};
use crate::abi::sweep::{SweepUniforms, mode};
use crate::field::access::read;
use crate::math::{length, lerp, max, normalize, select, select_vector};
use crate::optics::environment::{environment, in_environment};
use crate::optics::receiver::{first_ahead, surface};
use crate::optics::step::flight;
use crate::sweep::light::look_up::shade;
use crate::sweep::light::receiver_map::light_on;
use spirv_std::glam::Vec3;

/// A direction of a ray's record, from component `of` on, in the environment's frame (z up): not of unit length.
#[inline(always)]
fn direction(u: &SweepUniforms, rays: &[f32], at: i32, of: usize) -> Vec3 {
    let count = (u.picture.width * u.picture.height) as i32;
    let component = |c: usize| read(rays, c as i32 * count + at);
    in_environment(&u.environment, Vec3::new(component(of), component(of + 1), component(of + 2)))
}

/// The angle, in radians, over which a pixel gathers directions, from the directions that its neighbours have in component `of` on, if they have any.
#[inline(always)]
fn spread(u: &SweepUniforms, rays: &[f32], x: i32, y: i32, of: usize) -> f32 {
    let (width, height) = (u.picture.width as i32, u.picture.height as i32);
    let (left, right) = beside(u, x, width);
    let (above, below) = beside(u, y, height);
    let difference = |x: i32, y: i32, other_x: i32, other_y: i32, pixels: i32| {
        let at = |x: i32, y: i32| {
            let number = tiles::ray(u.picture.width, u.picture.height, x as u32, y as u32);
            direction(u, rays, number as i32, of)
        };
        let (a, b) = (at(x, y), at(other_x, other_y));
        let (first, second) = (length(a), length(b));
        let apart = length(b * (1.0 / max(second, 1e-9)) - a * (1.0 / max(first, 1e-9)));
        select((first > 1e-9) & (second > 1e-9), apart / max(pixels as f32, 1.0), 0.0)
    };
    max(difference(left, y, right, y, right - left), difference(x, above, x, below, below - above))
}

/// The finished pixel (x, y).
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    chosen: u32,
    rays: &[f32],
    map: &[f32],
    light: &[u32],
) -> [f32; film::SIZE] {
    let number = tiles::ray(u.picture.width, u.picture.height, x, y) as i32;
    let count = (u.picture.width * u.picture.height) as i32;
    let component = |c: usize| read(rays, c as i32 * count + number);
    let vector = |c: usize| Vec3::new(component(c), component(c + 1), component(c + 2));
    let fate = component(ray::STATUS);
    let mut color = vector(ray::COLOR);
    let mut opacity = component(ray::OPACITY);
    let mut depth_sum = component(ray::DEPTH);
    let medium = vector(ray::TRANSMITTANCE);
    let v = vector(ray::DIRECTION);
    let unit = normalize(v);
    let under_way = fate == status::ACTIVE;
    let last = vector(ray::POSITION);
    let position = last + v * select(under_way, flight(v, u.step.ahead - last.z), 0.0);

    // Beyond the last plane rays are straight, and light on texels is unoccluded.
    let receiver = first_ahead(&u.receivers, position, unit, 0.0);
    let (normal, reflectance) = surface(&u.receivers, receiver.which == ahead::WALL);
    let at = position + unit * select(receiver.which == ahead::NOTHING, 0.0, receiver.distance);
    let seen = shade(u, normal, reflectance, &light_on(u, light, at, receiver.which == ahead::WALL));
    let met = (under_way | (fate == status::LEFT)) & (receiver.which != ahead::NOTHING);
    let ended = select_vector(met, at, position);
    let clear = select(met, 1.0 - opacity, 0.0);
    let through = 1.0 - component(ray::REFLECTANCE);
    color += (medium * seen) * (clear * through);
    opacity += clear;
    depth_sum += clear * (position.z + unit.z * receiver.distance);

    let left = (1.0 - opacity) * through;
    let spread = |of: usize| spread(u, rays, x as i32, y as i32, of);
    let behind = normalize(direction(u, rays, number, ray::DIRECTION));
    let behind = environment(&u.environment, map, behind, spread(ray::DIRECTION));
    let visible = u.environment.visible;
    color += (medium * behind) * (left * visible);
    if mode::bends(chosen) {
        // A rough surface mirrors the environment blurred, over about the width of its lobe.
        let mirrored = direction(u, rays, number, ray::MIRRORED);
        let weight = length(mirrored);
        let width = max(spread(ray::MIRRORED), 2.0 * (u.roughness * u.roughness));
        let unit = select_vector(weight > 0.0, mirrored * (1.0 / max(weight, 1e-20)), Vec3::new(0.0, 0.0, 1.0));
        color += environment(&u.environment, map, unit, width) * weight;
    }
    // Without an environment the picture is transparent where light would come through.
    let passes = left * ((medium.x + medium.y) + medium.z) * (1.0 / 3.0);
    let coverage = lerp(1.0 - passes, 1.0, visible);
    let pixel = Pixel {
        color,
        coverage,
        opacity,
        transmittance: medium,
        depth: depth_sum / max(opacity, 1e-12),
        direction: Vec3::new(unit.x, unit.y, -unit.z),
        position: Vec3::new(ended.x, ended.y, -ended.z),
        status: select(met, status::ENDED, select(fate == status::FOLLOWED, status::TURNED, fate)),
    };
    pixel.store()
}

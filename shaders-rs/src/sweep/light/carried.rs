//! Look-ups of the light that a wavefront has carried: between eight samples of a brick.

use crate::abi::sweep::{SweepUniforms, mode};
use crate::abi::wavefront::{BRICK, LAYER, STORED, Wavefront, plane_words};
use crate::field::access::read_float;
use crate::math::{floor_to_int, lerp, max, select, sqrt, xyz};
use crate::sweep::light::bricks::brick;
use crate::sweep::light::look_up::Light;
use crate::sweep::light::offset;
use crate::sweep::light::placed::{cone, strength};
use crate::sweep::light::wavefront::{coordinates, from_frame, in_frame, unrefracted_direction};
use spirv_std::glam::Vec3;

/// Farther than any sample.
const FAR: f32 = 65536.0;

/// The samples around a point.
struct Around {
    /// The first word of the first of them.
    at: i32,
    /// Words between components.
    component: i32,
    /// Words between planes.
    plane: i32,
    /// Place among them, 0 to 1.
    x: f32,
    y: f32,
    z: f32,
    /// Whether there are samples.
    stored: bool,
}

#[inline(always)]
fn around(w: &Wavefront, light: &[u32], inside: Vec3) -> Around {
    let cells = coordinates(w, inside);
    let (x, y) = (cells.x - w.first_sample, cells.y - w.first_sample);
    let z = (inside.z - w.first_depth) * w.inverse_step;
    let (i, j, k) = (floor_to_int(x, -FAR, FAR), floor_to_int(y, -FAR, FAR), floor_to_int(z, -FAR, FAR));
    let brick = brick(w, light, i, j, k >> BRICK.trailing_zeros());
    let within = BRICK as i32 - 1;
    let plane = plane_words(brick.bricks, w.components) as i32;
    Around {
        at: brick.start + (k & within) * plane + (j & within) * STORED as i32 + (i & within),
        component: (brick.bricks * LAYER) as i32,
        plane,
        x: x - i as f32,
        y: y - j as f32,
        z: z - k as f32,
        stored: brick.bricks != 0,
    }
}

/// A component between two samples, the first of which is word `at`.
#[inline(always)]
fn in_row(light: &[u32], at: i32, around: &Around) -> f32 {
    lerp(read_float(light, at), read_float(light, at + 1), around.x)
}

/// A component between four samples of a plane.
#[inline(always)]
fn in_plane(light: &[u32], at: i32, around: &Around) -> f32 {
    lerp(in_row(light, at, around), in_row(light, at + STORED as i32, around), around.y)
}

/// Component `component` between the samples.
#[inline(always)]
fn between(light: &[u32], around: &Around, component: i32) -> f32 {
    let at = around.at + component * around.component;
    lerp(in_plane(light, at, around), in_plane(light, at + around.plane, around), around.z)
}

/// The difference of the direction from the direction of unrefracted light between two samples, in units of [`offset`].
#[inline(always)]
fn aside_in_row(light: &[u32], at: i32, around: &Around) -> (f32, f32) {
    let (a, b) = (offset::unpack(read_float(light, at)), offset::unpack(read_float(light, at + 1)));
    (lerp(a.0, b.0, around.x), lerp(a.1, b.1, around.x))
}

/// As [`aside_in_row`], between four samples of a plane.
#[inline(always)]
fn aside_in_plane(light: &[u32], at: i32, around: &Around) -> (f32, f32) {
    let (a, b) = (aside_in_row(light, at, around), aside_in_row(light, at + STORED as i32, around));
    (lerp(a.0, b.0, around.y), lerp(a.1, b.1, around.y))
}

/// As [`aside_in_row`], between the eight samples; component `component` has the direction.
#[inline(always)]
fn aside(light: &[u32], around: &Around, component: i32) -> (f32, f32) {
    let at = around.at + component * around.component;
    let (a, b) = (aside_in_plane(light, at, around), aside_in_plane(light, at + around.plane, around));
    (lerp(a.0, b.0, around.z), lerp(a.1, b.1, around.z))
}

/// The light at a point of the view frame: its flux is the radiance of light that has the same fluence. Where there are no samples, unoccluded light.
#[inline(always)]
pub fn light_at(u: &SweepUniforms, light: &[u32], at: Vec3, chosen: u32) -> Light {
    let w = &u.wavefront;
    let inside = in_frame(w, at);
    let around = around(w, light, inside);
    let red = select(around.stored, between(light, &around, 0), 1.0);
    let mut share = Vec3::new(red, red, red);
    if !mode::is_clear(chosen) {
        // In a clear medium there is one colour.
        let (green, blue) = if w.colors > 1 { (1, 2) } else { (0, 0) };
        share.y = select(around.stored, between(light, &around, green), 1.0);
        share.z = select(around.stored, between(light, &around, blue), 1.0);
    }
    let mut direction = unrefracted_direction(w, inside);
    if mode::bends(chosen) {
        let (across, up) = aside(light, &around, w.components as i32 - 1);
        let x = direction.x + select(around.stored, across * offset::UNIT, 0.0);
        let y = direction.y + select(around.stored, up * offset::UNIT, 0.0);
        // Light goes forward in its frame.
        direction = Vec3::new(x, y, sqrt(max(1.0 - (x * x + y * y), 1e-4)));
    }
    // Where light bends, what is stored has a spot's cone.
    let shaped = select(mode::bends(chosen) & around.stored, 1.0, cone(w, inside));
    Light { flux: share * xyz(u.light.color) * (strength(w, inside) * shaped), direction: from_frame(w, direction) }
}

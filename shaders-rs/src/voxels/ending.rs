//! Where a ray has ended: the radiance of an opaque body, a receiver or the environment there, as wide as a pixel sees it.

use super::mirror::{mirrored, vector, viewing};
use super::shade::{Point, facing, on_receiver, on_triangle, shade};
use crate::abi::record::{fate, path};
use crate::abi::voxels::{VoxelsUniforms, flag, seen};
use crate::field::access::read;
use crate::math::{length, max, min, select, xyz};
use crate::optics::environment::{environment, in_environment};
use spirv_std::glam::Vec3;

/// A pixel next to another.
#[derive(Clone, Copy)]
struct Neighbour {
    /// Whether the pixel lies in the picture and its ray took the same way.
    alike: bool,
    /// Whether the pixel lies in the picture and its ray was bent and has left.
    leaves_at_all: bool,
    /// The direction in which its ray left.
    leaves: Vec3,
    /// Whether the pixel's first surface mirrors its surroundings, too.
    mirrors: bool,
    /// The direction from which the mirrored light comes.
    mirrored: Vec3,
}

/// Pixel (x, y), beside a pixel whose ray met `bounces` surfaces and has status `status`.
#[inline(always)]
fn neighbour(u: &VoxelsUniforms, rays: &[f32], x: i32, y: i32, bounces: f32, status: f32) -> Neighbour {
    let (width, height) = (u.dispatch.width as i32, u.dispatch.height as i32);
    let there = (x >= 0) & (x < width) & (y >= 0) & (y < height);
    let at = if there { y * width + x } else { 0 };
    let component = |c: usize| read(rays, c as i32 * (width * height) + at);
    Neighbour {
        alike: there & (component(path::BOUNCES) == bounces) & (component(path::STATUS) == status),
        leaves_at_all: there & (component(path::BOUNCES) > 0.0) & (component(path::STATUS) == fate::LEFT),
        leaves: vector(u, rays, at, path::DIRECTION),
        mirrors: there & (component(path::REFLECTANCE) > 0.0),
        mirrored: mirrored(u, rays, x, y),
    }
}

/// The difference from one unit direction to those of the two pixels beside it, radians.
#[derive(Clone, Copy)]
struct Apart {
    /// The mean over the pixels that count; 0 if none does.
    counted: f32,
    /// Whether one does.
    counts: bool,
    /// The smaller one over the pixels that have such a direction at all, whether they count or not; [`NONE`] if none has.
    nearest: f32,
}

/// More than any difference of unit directions.
const NONE: f32 = 4.0;

/// A direction beside another: whether it is there, and whether it counts.
type Side = (Vec3, bool, bool);

#[inline(always)]
fn apart(own: Vec3, (first, first_there, first_counts): Side, (last, last_there, last_counts): Side) -> Apart {
    let (a, b) = (length(own - first), length(last - own));
    let (counted_a, counted_b) = (select(first_counts, a, 0.0), select(last_counts, b, 0.0));
    let halves = select(first_counts & last_counts, 0.5, 1.0);
    Apart {
        counted: (counted_a + counted_b) * halves,
        counts: first_counts | last_counts,
        nearest: min(select(first_there, a, NONE), select(last_there, b, NONE)),
    }
}

/// The angle over which a pixel looks, radians, from what is beside it: the larger change of direction across or down, over pixels that count. Where none
/// does, its ray is one of many that go different ways, of which the pixel sees one for all that are as near as the nearest of them; `usual` if that is
/// nearer still or there is none.
#[inline(always)]
fn angle(across: Apart, down: Apart, usual: f32) -> f32 {
    let counted = max(across.counted, down.counted);
    let nearest = min(across.nearest, down.nearest);
    let alone = select(nearest < NONE, max(nearest, usual), usual);
    select(across.counts | down.counts, counted, alone)
}

/// The environment in direction `d`, over an angle.
#[inline(always)]
pub fn surroundings(u: &VoxelsUniforms, pictures: &[f32], d: Vec3, angle: f32) -> Vec3 {
    environment(&u.environment, pictures, in_environment(&u.environment, d), angle)
}

/// The point at which a ray ended.
#[inline(always)]
pub fn point(u: &VoxelsUniforms, corners: &[f32], looks: &[f32], triangle: i32, position: Vec3) -> Point {
    if triangle < 0 {
        on_receiver(&u.receivers, triangle, position)
    } else {
        let of_triangle = u.flags & flag::LOOK_OF_TRIANGLE != 0;
        on_triangle(of_triangle, corners, looks, triangle, position)
    }
}

/// The four pixels beside one.
#[derive(Clone, Copy)]
pub struct Beside {
    left: Neighbour,
    right: Neighbour,
    above: Neighbour,
    below: Neighbour,
    /// The change of direction from pixel to pixel where no ray is bent, radians.
    usual: f32,
}

impl Beside {
    /// The pixels beside (x, y), whose ray met `bounces` surfaces and has status `status`.
    #[inline(always)]
    pub fn new(u: &VoxelsUniforms, rays: &[f32], x: i32, y: i32, bounces: f32, status: f32) -> Self {
        Self {
            left: neighbour(u, rays, x - 1, y, bounces, status),
            right: neighbour(u, rays, x + 1, y, bounces, status),
            above: neighbour(u, rays, x, y - 1, bounces, status),
            below: neighbour(u, rays, x, y + 1, bounces, status),
            usual: length(viewing(u, x + 1, y) - viewing(u, x, y)),
        }
    }

    /// The angle over which a pixel's ray that left along `own` looks, radians.
    #[inline(always)]
    fn leaving(&self, own: Vec3) -> f32 {
        let side = |pixel: &Neighbour| (pixel.leaves, pixel.leaves_at_all, pixel.alike);
        let across = apart(own, side(&self.left), side(&self.right));
        let down = apart(own, side(&self.above), side(&self.below));
        angle(across, down, self.usual)
    }

    /// The angle over which a pixel looks whose first surface mirrors it along `own`, radians.
    #[inline(always)]
    pub fn mirrored(&self, own: Vec3) -> f32 {
        let side = |pixel: &Neighbour| (pixel.mirrored, pixel.mirrors, pixel.mirrors);
        let across = apart(own, side(&self.left), side(&self.right));
        let down = apart(own, side(&self.above), side(&self.below));
        angle(across, down, self.usual)
    }
}

/// What a ray brings.
#[derive(Clone, Copy)]
pub struct Brought {
    /// Linear radiance: that of the ray's end, and of what it has left to the environment's mean.
    pub radiance: Vec3,
    /// Unit normal of the opaque surface or receiver at the end, on the side that is seen; 0 if there is none.
    pub normal: Vec3,
}

/// What the ray of pixel (x, y) brings.
#[inline(always)]
pub fn brought(
    u: &VoxelsUniforms,
    mode: u32,
    at: i32,
    beside: &Beside,
    rays: &[f32],
    pictures: &[f32],
    corners: &[f32],
    looks: &[f32],
    shadow: &[u32],
) -> Brought {
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    let component = |c: usize| read(rays, c as i32 * count + at);
    let direction = vector(u, rays, at, path::DIRECTION);
    // What is behind nothing does not depend on what is beside it.
    let angle = select(component(path::BOUNCES) > 0.0, beside.leaving(direction), beside.usual);
    let mut end = surroundings(u, pictures, direction, angle);
    let mut normal = Vec3::new(0.0, 0.0, 0.0);
    if (mode == seen::SURFACES) & (component(path::STATUS) == fate::MET) {
        let triangle = component(path::TRIANGLE) as i32;
        let point = point(u, corners, looks, triangle, vector(u, rays, at, path::POSITION));
        end = shade(u, pictures, shadow, &point, direction);
        normal = facing(&point, direction);
    }
    let rest = vector(u, rays, at, path::REST) * xyz(u.mean_radiance);
    Brought { radiance: end * vector(u, rays, at, path::TRANSMITTANCE) + rest, normal }
}

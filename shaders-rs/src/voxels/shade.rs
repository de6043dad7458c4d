//! Shading of diffuse surfaces: opaque triangles and receivers in the light (Lambert's law; the shadow: Chang et al. 2010, §3).

use crate::abi::receivers::{Receivers, ahead};
use crate::abi::voxels::{VoxelsUniforms, corner, flag, look};
use crate::field::access::{read, read_vector};
use crate::math::{cross, dot, max, min, normalize, select, select_vector};
use crate::optics::ambient::irradiance;
use crate::optics::light_source::{Arriving, arriving, to_all_sides};
use crate::optics::receiver::surface;
use crate::shadow::look_up::{behind_opaque, bias, transmittance};
use crate::sweep::light::receiver_map::share_on;
use crate::sweep::light::wavefront::in_frame;
use spirv_std::glam::Vec3;

/// A point of a diffuse surface.
#[derive(Clone, Copy)]
pub struct Point {
    /// Position, in voxels.
    pub position: Vec3,
    /// Unit normal of its plane.
    pub plane: Vec3,
    /// Unit normal, interpolated between the corners of the triangle.
    pub normal: Vec3,
    /// Reflectance.
    pub color: Vec3,
    /// Transmittance of the triangle, 0 to 1.
    pub transmittance: f32,
    /// Whether the shadow map contains the surface.
    pub casts: bool,
    /// Whether the surface is the wall.
    pub is_wall: bool,
}

/// The weighted sum of three vectors that lie next to each other.
#[inline(always)]
fn mean(floats: &[f32], at: i32, weights: Vec3) -> Vec3 {
    read_vector(floats, at) * weights.x
        + read_vector(floats, at + 3) * weights.y
        + read_vector(floats, at + 6) * weights.z
}

/// The point at `position` of triangle number `index`; `of_triangle` says whether looks belong to triangles, else to materials.
#[inline(always)]
pub fn on_triangle(of_triangle: bool, corners: &[f32], looks: &[f32], index: i32, position: Vec3) -> Point {
    let at = index * corner::SIZE as i32;
    let (a, b, c) = (read_vector(corners, at), read_vector(corners, at + 3), read_vector(corners, at + 6));
    let normal = cross(b - a, c - a);
    // Weights of the corners are parts of the area.
    let part = |p: Vec3, q: Vec3| max(dot(cross(p - position, q - position), normal), 0.0);
    let (first, second, third) = (part(b, c), part(c, a), part(a, b));
    let sum = max((first + second) + third, 1e-30);
    let weights = Vec3::new(first / sum, second / sum, third / sum);
    let plane = normalize(normal);
    let smooth = normalize(mean(corners, at + corner::NORMALS as i32, weights));
    let material = read(corners, at + corner::MATERIAL as i32) as i32;
    let from = if of_triangle { index } else { material } * look::SIZE as i32;
    Point {
        position,
        plane,
        normal: smooth,
        color: mean(looks, from + look::COLORS as i32, weights),
        transmittance: read(looks, from + look::TRANSMITTANCE as i32),
        casts: true,
        is_wall: false,
    }
}

/// The point at `position` of a receiver, one of [`ahead`].
#[inline(always)]
pub fn on_receiver(receivers: &Receivers, which: i32, position: Vec3) -> Point {
    let wall = which == ahead::WALL;
    let (normal, color) = surface(receivers, wall);
    Point { position, plane: normal, normal, color, transmittance: 0.0, casts: false, is_wall: wall }
}

/// The unit normal of a point on the side from which a ray along `direction` sees it.
#[inline(always)]
pub fn facing(point: &Point, direction: Vec3) -> Vec3 {
    let side = select(dot(point.plane, direction) > 0.0, -1.0, 1.0);
    // Smooth normals may lie beyond the plane of a triangle that is seen at a grazing angle.
    let normal = point.normal * select(dot(point.normal, point.plane) < 0.0, -side, side);
    let plane = point.plane * side;
    let beyond = dot(normal, direction) > 0.0;
    select_vector(beyond, plane, normal)
}

/// The share of the light along `light` that a point sends back to a ray along `direction`, over its reflectance (Lambert's law); `normal` is the one on
/// the ray's side. By its plane a triangle is lit from the side that it is seen from, or from the other one.
#[inline(always)]
pub fn share(point: &Point, normal: Vec3, direction: Vec3, light: Vec3) -> f32 {
    let cosine = -dot(normal, light);
    let same = dot(point.plane, light) * dot(point.plane, direction) > 0.0;
    select(same, max(cosine, 0.0), max(-cosine, 0.0) * point.transmittance)
}

/// Radiance of a white diffuse receiver at a point that faces the light, by the light that a wavefront has carried there, without what opaque bodies take.
#[inline(always)]
fn carried(u: &VoxelsUniforms, shadow: &[u32], point: &Point) -> Vec3 {
    let inside = in_frame(&u.wavefront, point.position);
    let share = share_on(&u.wavefront, shadow, inside, point.is_wall);
    share * to_all_sides(&u.light, point.position) * behind_opaque(u, shadow, point.position)
}

/// Radiance along a ray that meets a point from direction `direction`: reflectance · (L cos θ + ambient), where a surface that is lit
/// from its other side has the light that it lets through.
#[inline(always)]
pub fn shade(u: &VoxelsUniforms, pictures: &[f32], shadow: &[u32], point: &Point, direction: Vec3) -> Vec3 {
    let normal = facing(point, direction);
    let Arriving { direction: light, radiance } = arriving(&u.light, pictures, point.position);
    let strength = share(point, normal, direction, light);
    let plane = -dot(point.plane, light);
    let slope = min(max(plane, -plane), 1.0);
    let bias = bias(&u.shadow, point.position, point.plane, slope);
    let above = point.plane * (select(plane < 0.0, -1.0, 1.0) * bias);
    let lifted = select(point.casts, 1.0, 0.0);
    let straight = radiance * (transmittance(u, shadow, point.position + above * lifted) * strength);
    let lit = if u.flags & flag::CAUSTICS != 0 {
        select_vector(point.casts, straight, carried(u, shadow, point) * strength)
    } else {
        straight
    };
    point.color * (lit + irradiance(&u.ambient, &u.environment, normal))
}

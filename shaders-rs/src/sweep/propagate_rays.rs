//! Viewing rays from the plane behind to this one (sweep §4.3, Eq. 14, Algorithm 1, lines 21 to 36).

use crate::abi::record::{ray, status};
use crate::abi::sweep::{SweepUniforms, flag, mode};
use crate::field::empty::is_empty;
use crate::field::light::{light, texel_coordinates};
use crate::field::stencil::{scalar, voxel_coordinates};
use crate::field::tables::{ior, segment};
use crate::math::{length, lerp, max, min, select, xyz};
use crate::optics::clip::keep;
use crate::optics::composite::{Gathered, layer, over};
use crate::optics::medium::{medium, share_inside};
use crate::optics::receiver::{Hit, first_between, radiance, shade};
use crate::optics::specular::cook_torrance;
use crate::optics::step::{flight, kick, kick_euler};
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The ray has ended.
    pub const ENDED: u32 = 0;
    /// It crosses empty space and meets no receiver.
    pub const EMPTY: u32 = 1;
    /// The scalar at its position is known.
    pub const FULL: u32 = 2;
    /// It comes from empty space, where its scalar was not sampled.
    pub const ENTERING: u32 = 3;
}

/// Rays that let less than this through have ended.
const OPAQUE: f32 = 1.0 / 1024.0;

/// One plane's step.
struct Flight {
    from: Vec3,
    to: Vec3,
    v: Vec3,
    sigma: f32,
}

#[inline(always)]
fn fly(u: &SweepUniforms, r: &[f32; ray::SIZE]) -> Flight {
    let v = Vec3::new(r[ray::DIRECTION_X], r[ray::DIRECTION_X + 1], r[ray::DIRECTION_X + 2]);
    let sigma = flight(v, u.plane.z);
    let from = Vec3::new(r[ray::X], r[ray::Y], u.plane.x);
    let to = Vec3::new(from.x + v.x * sigma, from.y + v.y * sigma, u.plane.y);
    Flight { from, to, v, sigma }
}

#[inline(always)]
fn empty<const SECOND: bool>(u: &SweepUniforms, occupancy: &[u32], from: Vec3, to: Vec3) -> bool {
    let shown = is_empty(occupancy, &u.grid, voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    let bending = !SECOND
        || is_empty(occupancy, &u.ior_grid, voxel_coordinates(&u.ior_grid, from), voxel_coordinates(&u.ior_grid, to));
    shown & bending & (u.dispatch.w & flag::SKIP_EMPTY != 0)
}

/// The level that the ray `r` needs.
#[inline(always)]
pub fn level<const FORMAT: u32, const SECOND: bool>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    _mode: u32,
    r: [f32; ray::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    occupancy: &[u32],
    _tables: &[u32],
    _light: &[f32],
) -> u32 {
    let flight = fly(u, &r);
    let hit = first_between(u, flight.from, flight.to);
    let empty = empty::<SECOND>(u, occupancy, flight.from, flight.to) & !hit.hit;
    let sampled = if r[ray::FRONT] < 0.0 { level::ENTERING } else { level::FULL };
    let needed = if empty { level::EMPTY } else { sampled };
    if r[ray::STATUS] == status::ACTIVE { needed } else { level::ENDED }
}

/// The ray `r` one plane further.
#[inline(always)]
pub fn invoke<const FORMAT: u32, const SECOND: bool, const LEVEL: u32>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    chosen: u32,
    r: [f32; ray::SIZE],
    voxels: &[u32],
    ior_voxels: &[u32],
    occupancy: &[u32],
    tables: &[u32],
    light_behind: &[f32],
) -> [f32; ray::SIZE] {
    let Flight { from, to, v, sigma } = fly(u, &r);
    if LEVEL == level::EMPTY {
        return crossed(r, to);
    }
    let hit = first_between(u, from, to);
    let skipped = empty::<SECOND>(u, occupancy, from, to) & !hit.hit;
    let (voxel_from, voxel_to) = (voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    let ior_to = voxel_coordinates(&u.ior_grid, to);
    let here = medium::<FORMAT, SECOND>((&u.grid, &u.ior_grid), chosen, voxels, ior_voxels, tables, voxel_to, ior_to);
    let mut front = r[ray::FRONT];
    let mut ior_front = r[ray::IOR];
    if LEVEL == level::ENTERING {
        let unknown = front < 0.0;
        let sampled = scalar::<FORMAT>(voxels, &u.grid, voxel_from);
        front = select(unknown, sampled, front);
        if chosen != mode::STRAIGHT {
            let bending = if SECOND {
                scalar::<FORMAT>(ior_voxels, &u.ior_grid, voxel_coordinates(&u.ior_grid, from))
            } else {
                sampled
            };
            ior_front = select(unknown, ior(tables, bending), ior_front);
        }
    }

    // The segment ends on a receiver if it meets one.
    let part = select(hit.hit, min(hit.at, 1.0), 1.0);
    let kept = keep(u, from, to);
    let path = length(to - from) * share_inside(&u.grid, voxel_from, voxel_to) * part * u.plane.w;
    let layer = layer(&segment(tables, front, here.scalar), path * kept.particles, path * kept.medium);

    let lit = from + (to - from) * select(hit.hit, part, 0.0);
    let (texel_x, texel_y) = texel_coordinates(u, lit);
    let light = light(u, light_behind, texel_x, texel_y);
    let radiance = radiance(u, &light);
    let mut specular = Vec3::new(0.0, 0.0, 0.0);
    if chosen != mode::STRAIGHT {
        let reflected = cook_torrance(here.scalar_gradient, light.direction, v, u.shading.x, ior_front, here.ior);
        specular = radiance * (reflected * u.shading.y * select(hit.hit, 0.0, kept.refraction));
    }
    let before = Gathered {
        color: Vec3::new(r[ray::COLOR], r[ray::COLOR + 1], r[ray::COLOR + 2]),
        opacity: r[ray::OPACITY],
        medium: Vec3::new(r[ray::MEDIUM], r[ray::MEDIUM + 1], r[ray::MEDIUM + 2]),
    };
    let after = over(before, &layer, radiance + xyz(u.ambient), specular);
    let depth = r[ray::DEPTH] + (after.opacity - before.opacity) * lerp(from.z, to.z, 0.5);
    let (after, depth) = end_on_receiver(&hit, after, depth, shade(u, &hit, &light), lit.z);

    let mut out = v;
    let mut turned = false;
    if chosen != mode::STRAIGHT {
        let keeps = kept.refraction;
        let symplectic = kick(v, here.acceleration * keeps, sigma, u.plane.z, u.shading.z);
        let euler = kick_euler(v, here.ior_gradient * keeps, u.plane.z, u.shading.z);
        let use_euler = u.dispatch.w & flag::EULER != 0;
        turned = if use_euler { euler.turned } else { symplectic.turned };
        out = Vec3::new(
            select(use_euler, euler.direction.x, symplectic.direction.x),
            select(use_euler, euler.direction.y, symplectic.direction.y),
            select(use_euler, euler.direction.z, symplectic.direction.z),
        );
    }
    let clearest = max(max(after.medium.x, after.medium.y), after.medium.z);
    let ended = hit.hit | ((1.0 - after.opacity) * clearest < OPAQUE);
    let fate = select(ended, status::ENDED, select(turned, status::TURNED, status::ACTIVE));

    // A lane that needs less is carried along with its block; it must end up as if it had been alone.
    let active = r[ray::STATUS] == status::ACTIVE;
    let passing = crossed(r, to);
    let pick = |component: usize, next: f32| {
        let moved = select(skipped, passing[component], next);
        select(active, moved, r[component])
    };
    [
        pick(ray::X, stay(&hit, lit.x, to.x)),
        pick(ray::Y, stay(&hit, lit.y, to.y)),
        pick(ray::DIRECTION_X, out.x),
        pick(ray::DIRECTION_X + 1, out.y),
        pick(ray::DIRECTION_X + 2, out.z),
        pick(ray::FRONT, here.scalar),
        pick(ray::STATUS, fate),
        pick(ray::DEPTH, depth),
        pick(ray::COLOR, after.color.x),
        pick(ray::COLOR + 1, after.color.y),
        pick(ray::COLOR + 2, after.color.z),
        pick(ray::OPACITY, after.opacity),
        pick(ray::MEDIUM, after.medium.x),
        pick(ray::MEDIUM + 1, after.medium.y),
        pick(ray::MEDIUM + 2, after.medium.z),
        pick(ray::IOR, here.ior),
    ]
}

/// A ray that ended on a receiver stays there.
#[inline(always)]
fn stay(hit: &Hit, there: f32, next: f32) -> f32 {
    select(hit.hit, there, next)
}

/// A ray that crossed empty space: moved, its scalar unknown.
#[inline(always)]
fn crossed(r: [f32; ray::SIZE], to: Vec3) -> [f32; ray::SIZE] {
    let mut next = r;
    let active = r[ray::STATUS] == status::ACTIVE;
    next[ray::X] = select(active, to.x, r[ray::X]);
    next[ray::Y] = select(active, to.y, r[ray::Y]);
    next[ray::FRONT] = select(active, -1.0, r[ray::FRONT]);
    next[ray::IOR] = select(active, 1.0, r[ray::IOR]);
    next
}

/// A receiver is opaque: what is left of the ray shows it.
#[inline(always)]
fn end_on_receiver(hit: &Hit, g: Gathered, depth: f32, seen: Vec3, hit_depth: f32) -> (Gathered, f32) {
    let clear = 1.0 - g.opacity;
    let color = g.color + (g.medium * seen) * clear;
    (
        Gathered {
            color: Vec3::new(
                select(hit.hit, color.x, g.color.x),
                select(hit.hit, color.y, g.color.y),
                select(hit.hit, color.z, g.color.z),
            ),
            opacity: select(hit.hit, 1.0, g.opacity),
            medium: g.medium,
        },
        select(hit.hit, depth + clear * hit_depth, depth),
    )
}

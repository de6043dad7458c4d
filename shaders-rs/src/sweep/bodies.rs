//! Opaque bodies within the volume, as a segment meets them: diffuse receivers of any shape (not in the paper).
//!
//! A body ends viewing rays and light at its surface. Where its bricks are known to be empty nothing is looked up.

use crate::abi::format::VoxelFormat;
use crate::abi::sweep::{SweepUniforms, flag};
use crate::field::bodies::{SURFACE, gradient, reflectance, share};
use crate::field::colors::between;
use crate::field::empty::is_empty;
use crate::field::stencil::voxel_coordinates;
use crate::math::{length, max, select};
use crate::optics::receiver::Hit;
use spirv_std::glam::Vec3;

/// Parts of a segment at whose ends bodies are looked for: a part is about as long as a voxel of theirs.
const PARTS: i32 = 4;
/// Halvings of the part in which a surface lies.
const HALVINGS: i32 = 3;
/// A share of a segment that no place on it has.
const NEVER: f32 = 2.0;

/// Whether a body may be on the way from `from` to `to` in the view frame.
#[inline(always)]
pub fn may_be_met<V: VoxelFormat>(u: &SweepUniforms, occupancy: &[u32], from: Vec3, to: Vec3) -> bool {
    if !V::BODIES {
        return false;
    }
    let grid = &u.ior_grid;
    let empty = is_empty(occupancy, grid, voxel_coordinates(grid, from), voxel_coordinates(grid, to));
    !(empty & (u.flags & flag::SKIP_EMPTY != 0))
}

/// Whether a body is on the way between two points of the view frame.
#[inline(always)]
pub fn is_met<V: VoxelFormat>(u: &SweepUniforms, bodies: &[u32], from: Vec3, to: Vec3) -> bool {
    if !V::BODIES {
        return false;
    }
    let grid = &u.ior_grid;
    let (from, to) = (voxel_coordinates(grid, from), voxel_coordinates(grid, to));
    let mut greatest = 0.0;
    let mut part = 0;
    while part < PARTS {
        part += 1;
        let at = between(from, to, part as f32 * (1.0 / PARTS as f32));
        greatest = max(greatest, share::<V>(bodies, grid, at));
    }
    greatest >= SURFACE
}

/// The first body between `from` and `to`; one around `from` is met there.
#[inline(always)]
pub fn first_body<V: VoxelFormat>(u: &SweepUniforms, bodies: &[u32], from: Vec3, to: Vec3) -> Hit {
    let grid = &u.ior_grid;
    let (start, end) = (voxel_coordinates(grid, from), voxel_coordinates(grid, to));
    let share_at = |at: f32| share::<V>(bodies, grid, between(start, end, at));

    // A surface lies between `outside` and `inside`.
    let (mut outside, mut inside) = (0.0, select(share_at(0.0) >= SURFACE, 0.0, NEVER));
    let mut part = 0;
    while part < PARTS {
        part += 1;
        let at = part as f32 * (1.0 / PARTS as f32);
        let sought = inside >= NEVER;
        let met = share_at(at) >= SURFACE;
        inside = select(sought & met, at, inside);
        outside = select(sought & !met, at, outside);
    }
    let hit = inside < NEVER;
    let mut halving = 0;
    while halving < HALVINGS {
        halving += 1;
        let middle = 0.5 * (outside + inside);
        let met = share_at(middle) >= SURFACE;
        inside = select(met, middle, inside);
        outside = select(met, outside, middle);
    }
    // In so short a part the share rises in a straight line.
    let (before, behind) = (share_at(outside), share_at(inside));
    let rise = max(behind - before, 1e-6);
    let within = max(SURFACE - before, 0.0) / rise;
    let at = select(inside > outside, outside + (inside - outside) * select(within < 1.0, within, 1.0), inside);

    let place = between(start, end, at);
    let gradient = gradient::<V>(bodies, grid, place);
    let steep = length(gradient);
    let way = to - from;
    // In the middle of a body, where a ray may begin, no side is nearer.
    let normal =
        if steep > 1e-12 { gradient * (-1.0 / max(steep, 1e-20)) } else { way * (-1.0 / max(length(way), 1e-20)) };
    Hit { hit, is_wall: false, is_body: hit, at, normal, color: reflectance::<V>(bodies, grid, place) }
}

//! The maximum, the minimum or the mean of the scalar along viewing rays, from the plane behind to this one (not in the paper).
//!
//! Rays are straight: nothing bends them, and no light, filter or receiver counts. What counts of a ray is its part inside the box of the grid
//! and on the kept side of all clipping planes, whatever these remove.
//!
//! The scalar is looked up every [`SPACING`] of a plane's step. An extremum is the largest or smallest scalar at the ends of such parts, the
//! beginning of the whole way included: that of the interpolated scalar is at most half a part away. A mean is by the parts' midpoints.
//!
//! Until [`color_projected`](crate::sweep::color_projected) looks them up in the transfer function, the ray's record holds in `scalar` the extremum
//! so far, and in `depth` its depth; of a mean, in `scalar` the integral of the scalar over the way, and in `depth` the way's length.
//! `sampled` is the depth of the last plane on the way to which the scalar was looked up.
//!
//! Instead of occupancy there is a bound for each brick: no scalar in reach is larger, or smaller. Where no scalar can replace the extremum, none
//! is looked up. A mean skips what is outside the volume alone.

use crate::abi::clip::Clip;
use crate::abi::format::VoxelFormat;
use crate::abi::record::{Ray, ray, status};
use crate::abi::sweep::{SweepUniforms, blend, flag};
use crate::field::empty::{steps_outside, told};
use crate::field::stencil::{scalar, voxel_coordinates};
use crate::math::{absolute, affine, clamp, length, max, min, select};
use crate::optics::medium::is_well_inside;
use crate::optics::step::flight;
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// A receiver in front of the first plane has ended the ray.
    pub const ENDED: u32 = 0;
    /// Nothing on the way changes what is known.
    pub const EMPTY: u32 = 1;
    /// The whole step counts, as the one before did.
    pub const FULL: u32 = 3;
    /// A part of it may not count, or nothing was looked up before.
    pub const BORDER: u32 = 7;
}

/// The distance of look-ups, as a share of a plane's step.
pub const SPACING: f32 = 0.25;

/// What no scalar reaches: they are no further from 0 than 10⁹.
const BEYOND: f32 = 2e9;

/// The way from the plane behind to this one.
#[inline(always)]
fn way(u: &SweepUniforms, ray: &Ray) -> (Vec3, Vec3) {
    let (v, last) = (ray.direction, ray.position);
    let (straight, sigma) = (flight(v, u.step.behind - last.z), flight(v, u.step.distance));
    let from = Vec3::new(last.x + v.x * straight, last.y + v.y * straight, u.step.behind);
    (from, Vec3::new(from.x + v.x * sigma, from.y + v.y * sigma, u.step.ahead))
}

/// The level that a ray needs.
#[inline(always)]
pub fn level<V: VoxelFormat>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    chosen: u32,
    record: [f32; ray::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    bounds: &[u32],
    _tables: &[u32],
) -> u32 {
    let ray = Ray::load(&record);
    let (from, to) = way(u, &ray);
    let (voxel_from, voxel_to) = (voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    let told = told(bounds, &u.grid, voxel_from, voxel_to);
    let bound = f32::from_bits(told.word);
    let new = ray.sampled == ray::NOWHERE;
    let bounded = if chosen == blend::MAXIMUM { bound <= ray.scalar } else { bound >= ray.scalar };
    let known = (chosen != blend::MEAN) & !new & told.holds & bounded & (u.flags & flag::SKIP_EMPTY != 0);
    let empty = told.outside | known | (u.flags & flag::BEHIND_VOLUME != 0);
    let whole = is_well_inside(&u.grid, voxel_from, voxel_to) & (u.flags & flag::CLIP == 0) & !new;
    let needed = if whole { level::FULL } else { level::BORDER };
    let active = if empty { level::EMPTY } else { needed };
    if ray.status == status::ACTIVE { active } else { level::ENDED }
}

/// How many planes behind the next one a ray at level `EMPTY` will be at that level for certain, if they are as far apart and it is so on the
/// first `known` of them; without end if that is all planes there are.
#[inline(always)]
pub fn until<V: VoxelFormat>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    _mode: u32,
    record: [f32; ray::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    _bounds: &[u32],
    _tables: &[u32],
    known: f32,
) -> f32 {
    let ray = Ray::load(&record);
    let (from, to) = way(u, &ray);
    let step = (to - from) * known;
    let (next_from, next_to) = (voxel_coordinates(&u.grid, from + step), voxel_coordinates(&u.grid, to + step));
    let outside = known + steps_outside(&u.grid, next_from, next_to);
    let behind = u.flags & flag::BEHIND_VOLUME != 0;
    let free = min(select(behind, f32::MAX, outside), u.step.alike);
    let to_the_end = (u.flags & flag::LAST_STRETCH != 0) & (free >= u.step.alike);
    select((ray.status == status::ACTIVE) & !to_the_end, free, f32::MAX)
}

/// The part of a step that counts: the shares of the step at which it begins and ends.
#[derive(Clone, Copy)]
struct Part {
    begin: f32,
    end: f32,
}

impl Part {
    /// The part in the half-space of one more plane, from which the step's ends have the signed distances `a` and `b`; positive ones do not count.
    #[inline(always)]
    fn within(self, a: f32, b: f32) -> Self {
        let crossed = clamp(absolute(a) / max(absolute(a - b), 1e-30), 0.0, 1.0);
        let begin = select(a > 0.0, select(b > 0.0, 2.0, crossed), 0.0);
        let end = select((b > 0.0) & (a <= 0.0), crossed, 1.0);
        Self { begin: max(self.begin, begin), end: min(self.end, end) }
    }

    /// The part on the kept side of a clipping plane.
    #[inline(always)]
    fn clipped(self, clip: &Clip, from: Vec3, to: Vec3) -> Self {
        self.within(affine(clip.plane, from), affine(clip.plane, to))
    }
}

/// The part of the step from `from` to `to` inside the grid's box and the clipping planes.
#[inline(always)]
fn counting(u: &SweepUniforms, from: Vec3, to: Vec3) -> Part {
    let (a, b) = (voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    let (low, high) = (u.grid.low, u.grid.high);
    let mut part = Part { begin: 0.0, end: 1.0 };
    part = part.within(low.x - a.x, low.x - b.x).within(a.x - high.x, b.x - high.x);
    part = part.within(low.y - a.y, low.y - b.y).within(a.y - high.y, b.y - high.y);
    part = part.within(low.z - a.z, low.z - b.z).within(a.z - high.z, b.z - high.z);
    if u.flags & flag::CLIP != 0 {
        part = part.clipped(&u.clip_0, from, to);
        part = part.clipped(&u.clip_1, from, to);
        part = part.clipped(&u.clip_2, from, to);
        part = part.clipped(&u.clip_3, from, to);
    }
    part
}

/// An extremum, and its depth.
#[derive(Clone, Copy)]
struct Extremum {
    scalar: f32,
    depth: f32,
}

impl Extremum {
    /// The extremum of these scalars and one more, if it `counts`. Of equal ones the first stays.
    #[inline(always)]
    fn with(self, chosen: u32, other: Extremum, counts: bool) -> Self {
        let further = if chosen == blend::MAXIMUM { other.scalar > self.scalar } else { other.scalar < self.scalar };
        let takes = counts & further;
        Self { scalar: select(takes, other.scalar, self.scalar), depth: select(takes, other.depth, self.depth) }
    }
}

/// The scalar at the share `along` of the part of a step that counts, and the depth there.
#[inline(always)]
fn look_up<V: VoxelFormat>(
    u: &SweepUniforms,
    voxels: &[u32],
    (from, way, part): (Vec3, Vec3, Part),
    along: f32,
) -> Extremum {
    let at = from + way * (part.begin + (part.end - part.begin) * along);
    Extremum { scalar: scalar::<V>(voxels, &u.grid, voxel_coordinates(&u.grid, at)), depth: at.z }
}

/// The ray one plane further.
#[inline(always)]
pub fn invoke<V: VoxelFormat, const LEVEL: u32>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    chosen: u32,
    record: [f32; ray::SIZE],
    voxels: &[u32],
    _ior_voxels: &[u32],
    _bounds: &[u32],
    _tables: &[u32],
) -> [f32; ray::SIZE] {
    let ray = Ray::load(&record);
    let (from, to) = way(u, &ray);
    let part = if LEVEL >= level::BORDER { counting(u, from, to) } else { Part { begin: 0.0, end: 1.0 } };
    let counts = part.end > part.begin;
    let step = (from, to - from, part);
    let new = ray.sampled == ray::NOWHERE;
    let (gathered, depth) = if chosen == blend::MEAN {
        let first = look_up::<V>(u, voxels, step, 0.5 * SPACING).scalar;
        let second = look_up::<V>(u, voxels, step, 1.5 * SPACING).scalar;
        let third = look_up::<V>(u, voxels, step, 2.5 * SPACING).scalar;
        let fourth = look_up::<V>(u, voxels, step, 3.5 * SPACING).scalar;
        let path = select(counts, length(to - from) * (part.end - part.begin), 0.0);
        let mean = ((first + second) + (third + fourth)) * SPACING;
        (ray.scalar + mean * path, ray.depth + path)
    } else {
        let nothing = if chosen == blend::MAXIMUM { -BEYOND } else { BEYOND };
        let mut found = Extremum { scalar: select(new, nothing, ray.scalar), depth: ray.depth };
        if LEVEL >= level::BORDER {
            let first = look_up::<V>(u, voxels, step, 0.0);
            found = found.with(chosen, first, counts & (new | (part.begin > 0.0)));
        }
        found = found.with(chosen, look_up::<V>(u, voxels, step, SPACING), counts);
        found = found.with(chosen, look_up::<V>(u, voxels, step, 2.0 * SPACING), counts);
        found = found.with(chosen, look_up::<V>(u, voxels, step, 3.0 * SPACING), counts);
        found = found.with(chosen, look_up::<V>(u, voxels, step, 1.0), counts);
        (found.scalar, found.depth)
    };
    let after = Ray {
        scalar: select(counts, gathered, ray.scalar),
        depth: select(counts, depth, ray.depth),
        sampled: select(counts, u.step.ahead, ray.sampled),
        ..ray
    };
    after.store()
}

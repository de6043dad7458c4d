//! The state of a ray through a mesh, and its steps.

use crate::abi::receivers::ahead;
use crate::abi::record::{fate, path};
use crate::abi::voxels::{AIR, VoxelsUniforms, material};
use crate::field::access::read;
use crate::math::{absolute, exp, max, min, select};
use crate::optics::receiver::{Ahead, FAR, first_ahead};
use spirv_std::glam::Vec3;

/// A ray; see [`path`].
#[derive(Clone, Copy)]
pub struct Ray {
    /// Position, in voxels.
    pub position: Vec3,
    /// Unit direction.
    pub direction: Vec3,
    /// Transmittance so far, linear RGB, 0 to 1.
    pub transmittance: Vec3,
    /// Unit normal at the first surface.
    pub normal: Vec3,
    /// Unit normal at the last surface.
    pub last_normal: Vec3,
    /// Distance since the last surface, in voxels.
    pub since: f32,
    /// Status, one of [`fate`].
    pub status: f32,
    /// Number of the material around the ray.
    pub medium: i32,
    /// Number of surfaces so far.
    pub bounces: f32,
    /// Length of the way within materials, in voxels.
    pub length: f32,
    /// Distance to the first surface, in voxels.
    pub depth: f32,
    /// Fresnel reflectance of the first surface, 0 to 1.
    pub reflectance: f32,
    /// The next node of the tree of triangles.
    pub node: i32,
    /// Number of the triangle that ends the straight way, or one of [`ahead`].
    pub triangle: i32,
    /// Distance to that triangle or receiver, in voxels.
    pub distance: f32,
}

#[inline(always)]
fn vector(record: &[f32; path::SIZE], at: [usize; 3]) -> Vec3 {
    Vec3::new(record[at[0]], record[at[1]], record[at[2]])
}

impl Ray {
    /// A ray that has met nothing yet, from `position` along `direction`, with nothing ahead.
    #[inline(always)]
    pub fn straight(position: Vec3, direction: Vec3) -> Self {
        Self {
            position,
            direction,
            transmittance: Vec3::new(1.0, 1.0, 1.0),
            normal: Vec3::new(0.0, 0.0, 0.0),
            last_normal: Vec3::new(0.0, 0.0, 0.0),
            since: 1e9,
            status: fate::ACTIVE,
            medium: AIR,
            bounces: 0.0,
            length: 0.0,
            depth: 0.0,
            reflectance: 0.0,
            node: 0,
            triangle: ahead::NOTHING,
            distance: FAR,
        }
    }

    /// The ray of a record.
    #[inline(always)]
    pub fn load(r: &[f32; path::SIZE]) -> Self {
        Self {
            position: vector(r, [0, 1, 2]),
            direction: vector(r, [3, 4, 5]),
            transmittance: vector(r, [6, 7, 8]),
            normal: vector(r, [9, 10, 11]),
            last_normal: vector(r, [12, 13, 14]),
            since: r[path::SINCE],
            status: r[path::STATUS],
            medium: r[path::MEDIUM] as i32,
            bounces: r[path::BOUNCES],
            length: r[path::LENGTH],
            depth: r[path::DEPTH],
            reflectance: r[path::REFLECTANCE],
            node: r[path::NODE] as i32,
            triangle: r[path::TRIANGLE] as i32,
            distance: r[path::DISTANCE],
        }
    }

    /// The record of the ray.
    #[inline(always)]
    pub fn store(&self) -> [f32; path::SIZE] {
        let (p, d, t) = (self.position, self.direction, self.transmittance);
        let (n, l) = (self.normal, self.last_normal);
        [
            p.x,
            p.y,
            p.z,
            d.x,
            d.y,
            d.z,
            t.x,
            t.y,
            t.z,
            n.x,
            n.y,
            n.z,
            l.x,
            l.y,
            l.z,
            self.since,
            self.status,
            self.medium as f32,
            self.bounces,
            self.length,
            self.depth,
            self.reflectance,
            self.node as f32,
            self.triangle as f32,
            self.distance,
        ]
    }

    /// Moves the ray by `distance` voxels through material `medium`; the light is attenuated by e^(−σ d) (Chang et al. 2010, §4.2, with
    /// the minus sign that it lacks there).
    #[inline(always)]
    pub fn advance(&mut self, distance: f32, medium: i32, materials: &[f32]) {
        self.position += self.direction * distance;
        self.since += distance;
        self.distance -= distance;
        self.depth += select(self.bounces == 0.0, distance, 0.0);
        if medium != AIR {
            self.length += distance;
            let at = medium * material::SIZE as i32 + material::ABSORPTION as i32;
            self.transmittance.x *= exp(-(read(materials, at) * distance));
            self.transmittance.y *= exp(-(read(materials, at + 1) * distance));
            self.transmittance.z *= exp(-(read(materials, at + 2) * distance));
        }
    }

    /// Ends the ray, in air: at the receiver ahead if there is one.
    #[inline(always)]
    pub fn end(&mut self, materials: &[f32]) {
        if self.triangle == ahead::NOTHING {
            self.status = fate::LEFT;
        } else {
            self.meet(AIR, materials);
        }
    }

    /// Ends the ray at the triangle or receiver ahead, through material `medium`.
    #[inline(always)]
    pub fn meet(&mut self, medium: i32, materials: &[f32]) {
        self.advance(self.distance, medium, materials);
        self.status = fate::MET;
    }

    /// Looks ahead as far as receivers go, on a new straight way; triangles are still to be looked for.
    #[inline(always)]
    pub fn turn(&mut self, u: &VoxelsUniforms) {
        let receiver = first_receiver(u, self.position, self.direction);
        self.node = 0;
        self.triangle = receiver.which;
        self.distance = receiver.distance;
    }
}

/// Levels of work of kernels that follow rays.
pub mod level {
    /// The ray has ended.
    pub const ENDED: u32 = 0;
    /// The ray waits for another kernel.
    pub const WAITING: u32 = 1;
    /// The kernel follows the ray.
    pub const WORK: u32 = 3;
}

/// The level of a ray of status `status` for a kernel that follows active rays; rays that seek wait for [`super::seek`].
#[inline(always)]
pub fn level_of(status: f32) -> u32 {
    if status == fate::ACTIVE {
        level::WORK
    } else if status == fate::SEEKS {
        level::WAITING
    } else {
        level::ENDED
    }
}

/// Distance by which receivers are taken to be nearer, in voxels: a body that stands on one is in contact with it, and no ray inside of
/// the body gets between them.
const CONTACT: f32 = 1.0 / 64.0;

/// The first receiver from `position` along `direction`, with its distance in voxels.
#[inline(always)]
pub fn first_receiver(u: &VoxelsUniforms, position: Vec3, direction: Vec3) -> Ahead {
    first_ahead(&u.receivers, position, direction, CONTACT)
}

/// 1 / `x`, large where `x` is 0.
#[inline(always)]
pub fn reciprocal(x: f32) -> f32 {
    let small = absolute(x) < 1e-12;
    1.0 / select(small, select(x < 0.0, -1e-12, 1e-12), x)
}

/// Distances along a line at which it enters and leaves a box (the slab method, Kay & Kajiya 1986).
#[inline(always)]
pub fn slab(from: Vec3, inverse: Vec3, low: Vec3, high: Vec3) -> (f32, f32) {
    let (ax, bx) = ((low.x - from.x) * inverse.x, (high.x - from.x) * inverse.x);
    let (ay, by) = ((low.y - from.y) * inverse.y, (high.y - from.y) * inverse.y);
    let (az, bz) = ((low.z - from.z) * inverse.z, (high.z - from.z) * inverse.z);
    let enters = max(max(min(ax, bx), min(ay, by)), min(az, bz));
    let leaves = min(min(max(ax, bx), max(ay, by)), max(az, bz));
    (enters, leaves)
}

/// The box of all surfaces.
#[inline(always)]
pub fn bounds(u: &VoxelsUniforms) -> (Vec3, Vec3) {
    (crate::math::xyz(u.low), crate::math::xyz(u.high))
}

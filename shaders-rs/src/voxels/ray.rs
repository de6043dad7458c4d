//! The state of a ray through a mesh, and its steps.

use crate::abi::receivers::ahead;
use crate::abi::record::fate;
use crate::abi::voxels::{AIR, VoxelsUniforms, material};
use crate::field::access::read;
use crate::math::{absolute, exp, max, min, select};
use crate::optics::receiver::{Ahead, FAR, first_ahead};
use spirv_std::glam::Vec3;

pub use crate::abi::record::Path as Ray;

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
            rest: Vec3::new(0.0, 0.0, 0.0),
            kept: Vec3::new(0.0, 0.0, 0.0),
            turns: 0,
            node: 0,
            triangle: ahead::NOTHING,
            distance: FAR,
        }
    }

    /// Moves the ray by `distance` voxels through material `medium`.
    #[inline(always)]
    pub fn advance(&mut self, distance: f32, medium: i32, materials: &[f32]) {
        self.position += self.direction * distance;
        self.since += distance;
        self.distance -= distance;
        self.depth += select(self.bounces == 0.0, distance, 0.0);
        self.attenuate(distance, medium, materials);
    }

    /// Attenuates the light by e^(−σ d) over `distance` voxels of material `medium` (Chang et al. 2010, §4.2, with the minus sign that it lacks
    /// there).
    #[inline(always)]
    pub fn attenuate(&mut self, distance: f32, medium: i32, materials: &[f32]) {
        if medium != AIR {
            self.length += distance;
            self.transmittance *= attenuation(medium, distance, materials);
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

/// Transmittance e^(−σ d) of `distance` voxels of a material (Beer–Lambert).
#[inline(always)]
pub fn attenuation(medium: i32, distance: f32, materials: &[f32]) -> Vec3 {
    let at = medium * material::SIZE as i32 + material::ABSORPTION as i32;
    Vec3::new(
        exp(-(read(materials, at) * distance)),
        exp(-(read(materials, at + 1) * distance)),
        exp(-(read(materials, at + 2) * distance)),
    )
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
pub const CONTACT: f32 = 1.0 / 64.0;

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

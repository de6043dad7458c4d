//! What [`project_rays`](crate::sweep::project_rays) has gathered, as colour and opacity: those that the transfer function gives its scalar, for a
//! way of one reference length, without light.

use crate::abi::record::{Ray, ray};
use crate::abi::sweep::{SweepUniforms, blend};
use crate::field::tables::segment_of_particles;
use crate::math::{max, select};
use crate::optics::composite::layer_of_particles;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The ray missed all that counts.
    pub const ENDED: u32 = 0;
    /// It has a scalar.
    pub const WORK: u32 = 3;
}

/// The level that a ray needs.
#[inline(always)]
pub fn level(_x: u32, _y: u32, _u: &SweepUniforms, _mode: u32, record: [f32; ray::SIZE], _tables: &[u32]) -> u32 {
    if record[ray::SAMPLED] == ray::NOWHERE { level::ENDED } else { level::WORK }
}

/// The ray with its colour, opacity and, unless it has a mean, the extremum's depth.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    _x: u32,
    _y: u32,
    _u: &SweepUniforms,
    chosen: u32,
    record: [f32; ray::SIZE],
    tables: &[u32],
) -> [f32; ray::SIZE] {
    let ray = Ray::load(&record);
    let is_mean = chosen == blend::MEAN;
    let scalar = select(is_mean, ray.scalar / max(ray.depth, 1e-30), ray.scalar);
    let layer = layer_of_particles(&segment_of_particles(tables, scalar, scalar), 1.0);
    let after = Ray {
        scalar,
        color: layer.color,
        opacity: layer.opacity,
        depth: select(is_mean, 0.0, ray.depth * layer.opacity),
        ..ray
    };
    after.store()
}

//! The ground and the wall.

use super::triangle::FAR;
use crate::abi::record::path::ahead;
use crate::abi::vector::Vec4;
use crate::abi::voxels::VoxelsUniforms;
use crate::math::{dot, max, select, xyz};
use spirv_std::glam::Vec3;

/// By how much receivers are nearer than they are, in voxels: a body that stands on one is in contact with it, and a ray inside of it
/// does not get between.
const NEARER: f32 = 1.0 / 64.0;

/// A receiver ahead of a ray.
#[derive(Clone, Copy)]
pub struct Ahead {
    /// One of [`ahead`].
    pub which: i32,
    /// How far it is; [`FAR`] if there is none.
    pub distance: f32,
}

/// How far a plane is, from its visible side; [`FAR`] for one that is absent, which has the equation 0 = 0.
#[inline(always)]
fn distance(plane: Vec4, position: Vec3, direction: Vec3) -> f32 {
    let height = dot(xyz(plane), position) + plane.w;
    let speed = -dot(xyz(plane), direction);
    let met = (height > 0.0) & (speed > 1e-9);
    select(met, max(height / max(speed, 1e-9) - NEARER, 0.0), FAR)
}

/// The first receiver from `position` along `direction`.
#[inline(always)]
pub fn first(u: &VoxelsUniforms, position: Vec3, direction: Vec3) -> Ahead {
    let ground = distance(u.ground, position, direction);
    let wall = distance(u.wall, position, direction);
    let nothing = (ground >= FAR) & (wall >= FAR);
    let which = if wall < ground { ahead::WALL } else { ahead::GROUND };
    Ahead { which: if nothing { ahead::NOTHING } else { which }, distance: select(wall < ground, wall, ground) }
}

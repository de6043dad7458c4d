//! The sweep's step through the medium.

use crate::abi::sweep::{Step, SweepUniforms, flag};
use crate::math::select_vector;
use crate::optics::medium::Medium;
use crate::optics::step::{Kicked, kick, kick_euler};
use spirv_std::glam::Vec3;

/// The step that the uniforms choose, for light and viewing rays alike: direction `v` at a plane where the medium is `here`, of
/// which the share `kept` bends; `sigma_behind` is dσ of the step behind, and `ahead` the share of the kick ahead that is due here (see
/// [`kick`]).
#[inline(always)]
pub fn turn(u: &SweepUniforms, v: Vec3, here: &Medium, kept: f32, sigma_behind: f32, ahead: f32) -> Kicked {
    let Step { distance, smallest_cosine, .. } = u.step;
    let symplectic = kick(v, here.acceleration * kept, sigma_behind, distance, ahead, smallest_cosine);
    let euler = kick_euler(v, here.ior_gradient * kept, distance, smallest_cosine);
    let use_euler = u.flags & flag::EULER != 0;
    Kicked {
        direction: select_vector(use_euler, euler.direction, symplectic.direction),
        turned: if use_euler { euler.turned } else { symplectic.turned },
    }
}

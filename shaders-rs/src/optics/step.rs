//! Advancing a ray from plane to plane.
//!
//! State: position x, optical direction v = η dx/ds. With dσ = ds/η the ray equation is dx/dσ = v, dv/dσ = ½∇(η²), which is
//! Hamiltonian. A ray keeps the direction with which it leaves its plane ("drift"), so one gradient a plane is enough:
//! on arrival it gets the second half kick of the step behind and the first half kick of the step ahead.

use crate::math::{dot, max, select_vector, sqrt};
use spirv_std::glam::Vec3;

/// A ray after its kick.
#[derive(Clone, Copy)]
pub struct Kicked {
    /// The direction with which it leaves the plane.
    pub direction: Vec3,
    /// Whether it turned: its depth component fell to `smallest_cosine` · |v| or below.
    pub turned: bool,
}

/// dσ of the straight flight over `distance` in depth with direction `v`.
#[inline(always)]
pub fn flight(v: Vec3, distance: f32) -> f32 {
    distance / v.z
}

/// Kick–drift–kick, the kicks at one plane: the second half kick over `sigma_behind`, the first one of the step ahead, whose
/// dσ solves distance = dσ v_z + ½ dσ² a_z, with the acceleration a = ½∇(η²). The share `ahead` of that step's kick is due here: ½, or
/// all that happens inside the volume if the ray leaves it within the step.
#[inline(always)]
pub fn kick(v: Vec3, acceleration: Vec3, sigma_behind: f32, distance: f32, ahead: f32, smallest_cosine: f32) -> Kicked {
    let arrived = v + acceleration * (0.5 * sigma_behind);
    let discriminant = arrived.z * arrived.z + 2.0 * distance * acceleration.z;
    let sigma_ahead = 2.0 * distance / max(arrived.z + sqrt(discriminant), 1e-6);
    let leaving = arrived + acceleration * (ahead * sigma_ahead);
    let turned = (arrived.z <= 0.0) | (discriminant <= 0.0) | grazes(leaving, smallest_cosine);
    Kicked { direction: select_vector(turned, arrived, leaving), turned }
}

/// The paper's explicit Euler step (Eqs. 8 and 10, Δs = plane distance), kept for comparison.
#[inline(always)]
pub fn kick_euler(v: Vec3, ior_gradient: Vec3, distance: f32, smallest_cosine: f32) -> Kicked {
    let direction = v + ior_gradient * distance;
    Kicked { direction, turned: grazes(direction, smallest_cosine) }
}

#[inline(always)]
fn grazes(v: Vec3, smallest_cosine: f32) -> bool {
    let limit = smallest_cosine * smallest_cosine;
    (v.z <= 0.0) | (v.z * v.z <= limit * dot(v, v))
}

//! Light of a line of light as a march along the viewing ray in even steps gathers it, for comparison (Hu et al. 2010, Eq. 3 and §5.2).
//!
//! The light that the line scatters where it meets the viewing ray is handed to the step points around that place, each
//! weighted by a Gaussian filter whose integral is 1. Where the filter's support is narrower than the steps, some lines have no step
//! point and are missing: the paper's noise of small supports (Fig. 10).

use super::medium::transmittance;
use super::nearest::Nearest;
use super::scattered::Sightline;
use super::shares::Drawing;
use crate::abi::beams::FILTER_STEPS;
use crate::math::{absolute, exp, floor_to_int, max, min, select};
use spirv_std::glam::Vec3;

/// β of the Gaussian filter (Jensen 2001).
const BETA: f32 = 1.953;
/// 1 / (1 − e^(−β)).
const INVERSE: f32 = 1.165_295_4;
/// 1 over the integral over −1…1 of the filter that is 1 in its middle.
const NORMAL: f32 = 0.704_030_45;

/// The Gaussian filter of a line's distance from a step point, over the radius of its support: its integral is 1 (Jensen 2001, in one dimension).
#[inline(always)]
fn filter(x: f32) -> f32 {
    let inside = absolute(x) <= 1.0;
    select(inside, NORMAL * (1.0 - (1.0 - exp(-0.5 * BETA * (x * x))) * INVERSE), 0.0)
}

impl Drawing<'_> {
    /// What step point number `number` gets of a line's light: its transmittance on the way over the point, times the filter.
    #[inline(always)]
    fn step(&self, nearest: &Nearest, line: &Sightline, number: i32) -> Vec3 {
        let Self { u, .. } = self;
        let (step, radius) = (u.limits.step, u.limits.filter_radius);
        let at = number as f32 * step;
        let weight = filter((at - nearest.t) / radius) * (step / radius);
        let (along, towards) = if u.medium.nodes == 0 {
            (nearest.s, max(at - line.enters, 0.0))
        } else {
            self.depths_at(nearest.s, at, line)
        };
        let marches = (at >= line.enters) & (at <= min(line.leaves, line.depth));
        transmittance(&u.medium, along + towards) * select(marches, weight, 0.0)
    }

    /// The transmittance of the line's light on its way over the step points to where the viewing ray enters the medium, by their weights: about
    /// the transmittance at the place where the lines are nearest.
    #[inline(always)]
    pub fn marched(&self, nearest: &Nearest, line: &Sightline) -> Vec3 {
        const { assert!(FILTER_STEPS == 2, "four step points are within the filter's radius at most") };
        let before = floor_to_int(nearest.t / self.u.limits.step, -1e9, 1e9);
        // Without a loop, which would keep the loop over pixels from becoming vector code.
        let near = self.step(nearest, line, before) + self.step(nearest, line, before + 1);
        near + (self.step(nearest, line, before - 1) + self.step(nearest, line, before + 2))
    }
}

//! A homogeneous medium in a box.

use super::Random;
use std::f64::consts::PI;
use vitrum_kernels::glam::DVec3;

/// A homogeneous medium in a box along the axes, with Henyey and Greenstein's phase function (1941). Its extinction is
/// above 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Medium {
    /// The box's corner of the least coordinates.
    pub low: DVec3,
    /// The box's corner of the greatest coordinates.
    pub high: DVec3,
    /// Scattering coefficient σ_s, in 1 / world unit.
    pub scattering: f64,
    /// Absorption coefficient σ_a, in 1 / world unit.
    pub absorption: f64,
    /// Mean cosine g of the angle by which light is scattered: 0 is equally to all sides.
    pub anisotropy: f64,
}

impl Medium {
    /// Extinction coefficient σ_t = σ_s + σ_a, in 1 / world unit.
    #[must_use]
    pub fn extinction(&self) -> f64 {
        self.scattering + self.absorption
    }

    /// The share σ_s / σ_t of the light that goes on after a collision.
    #[must_use]
    pub fn albedo(&self) -> f64 {
        self.scattering / self.extinction()
    }

    /// The distances along a ray, not below 0, at which it enters and leaves the box; `None` if it misses it.
    #[must_use]
    pub fn crossing(&self, from: DVec3, towards: DVec3) -> Option<[f64; 2]> {
        let (mut enters, mut leaves) = (0.0_f64, f64::INFINITY);
        for axis in 0..3 {
            if towards[axis] == 0.0 {
                if !(self.low[axis]..=self.high[axis]).contains(&from[axis]) {
                    return None;
                }
            } else {
                let [a, b] = [self.low, self.high].map(|face| (face[axis] - from[axis]) / towards[axis]);
                enters = enters.max(a.min(b));
                leaves = leaves.min(a.max(b));
            }
        }
        (enters < leaves).then_some([enters, leaves])
    }

    /// The share of light that a length of the medium lets through (Beer and Lambert).
    #[must_use]
    pub fn behind(&self, length: f64) -> f64 {
        (-self.extinction() * length).exp()
    }

    /// The share of light that gets from one point to another: only what lies in the box attenuates it.
    #[must_use]
    pub fn transmittance(&self, from: DVec3, to: DVec3) -> f64 {
        let distance = (to - from).length();
        if distance == 0.0 {
            return 1.0;
        }
        let crossing = self.crossing(from, (to - from) / distance);
        crossing.map_or(1.0, |[enters, leaves]| self.behind((leaves.min(distance) - enters).max(0.0)))
    }

    /// The phase function, in 1/sr, by the cosine of the angle between the light's directions before and after.
    #[must_use]
    pub fn phase(&self, cosine: f64) -> f64 {
        let g = self.anisotropy;
        let square = 1.0 + g * g - 2.0 * g * cosine;
        (1.0 - g * g) / (4.0 * PI * square * square.sqrt())
    }

    /// A direction after a collision, distributed as the phase function says: the inverse of its distribution function.
    pub fn scatter(&self, towards: DVec3, random: &mut Random) -> DVec3 {
        let (g, even) = (self.anisotropy, 2.0 * random.share() - 1.0);
        let cosine = if g.abs() < 1e-4 {
            even
        } else {
            let ratio = (1.0 - g * g) / (1.0 + g * even);
            (1.0 + g * g - ratio * ratio) / (2.0 * g)
        };
        random.around(towards, cosine.clamp(-1.0, 1.0))
    }
}

//! What paths from the eye gave, with so many of them that a test need not follow them anew.

use super::{Estimate, Lamp, Medium, Orders, Scene, radiance};
use vitrum_kernels::glam::DVec3;

/// The eye of all rows.
pub const EYE: DVec3 = DVec3::new(0.0, -9.0, 0.5);

/// Points of their viewing rays, spread over a view of the origin 40° high.
pub const THROUGH: [DVec3; 6] = [
    DVec3::new(0.0, 0.0, 2.8),
    DVec3::new(1.5, 0.0, 2.0),
    DVec3::new(-2.5, 0.0, 1.0),
    DVec3::new(1.0, 0.0, 0.0),
    DVec3::new(0.0, 0.0, -1.5),
    DVec3::new(-2.5, 0.0, -2.8),
];

/// A medium and what is seen along rays through each of [`THROUGH`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Set {
    /// Scattering coefficient σ_s, in 1 / world unit.
    pub scattering: f64,
    /// Absorption coefficient σ_a, in 1 / world unit.
    pub absorption: f64,
    /// Mean cosine g of the phase function.
    pub anisotropy: f64,
    /// Radiance of light that was scattered once, exactly twice, and twice or more often, in W / (sr · world unit²),
    /// each with its standard error.
    radiance: [[[f64; 2]; 3]; 6],
}

impl Set {
    /// The set's scene: a lamp of 40 W at (0, 0, 4) that shines equally to all sides, in the medium, which fills the
    /// cube from −5 to 5.
    #[must_use]
    pub fn scene(&self) -> Scene {
        let &Self { scattering, absorption, anisotropy, .. } = self;
        let [low, high] = [-5.0, 5.0].map(DVec3::splat);
        let lamp = Lamp::Point { position: DVec3::Z * 4.0, intensity: 10.0 / std::f64::consts::PI };
        Scene { medium: Medium { low, high, scattering, absorption, anisotropy }, lamp, ball: None }
    }

    /// Radiance along the rays, of light that was scattered once, exactly twice, and twice or more often, in W / (sr ·
    /// world unit²).
    #[must_use]
    pub fn radiance(&self) -> [[Estimate; 3]; 6] {
        self.radiance.map(|ray| ray.map(|[mean, error]| Estimate { mean, error }))
    }

    /// What paths give now along one of the rays, of light that was scattered up to `highest` times.
    #[must_use]
    pub fn look(&self, ray: usize, highest: u32, samples: u64, seed: u64) -> Orders {
        radiance(&self.scene(), EYE, (THROUGH[ray] - EYE).normalize(), highest, samples, seed)
    }
}

const fn set(scattering: f64, absorption: f64, anisotropy: f64, radiance: [[[f64; 2]; 3]; 6]) -> Set {
    Set { scattering, absorption, anisotropy, radiance }
}

/// Thin and dense fog, each with light scattered equally to all sides, and forwards: [`Set::look`] with 2²⁰ samples for
/// g = 0 and 2²² for 0.7.
#[rustfmt::skip]
pub const SETS: [Set; 4] = [
    set(0.1, 0.02, 0.0, [
        [[2.5030e-02, 1.0e-06], [7.4815e-03, 5.8e-06], [1.0170e-02, 7.7e-06]],
        [[8.5150e-03, 2.6e-07], [3.8863e-03, 3.2e-06], [5.8762e-03, 5.3e-06]],
        [[4.0684e-03, 1.6e-07], [2.2916e-03, 1.9e-06], [3.7497e-03, 3.9e-06]],
        [[3.5894e-03, 1.4e-07], [2.1179e-03, 1.8e-06], [3.5501e-03, 4.4e-06]],
        [[2.0806e-03, 8.3e-08], [1.3863e-03, 1.3e-06], [2.4601e-03, 2.7e-06]],
        [[1.2396e-03, 6.2e-08], [8.8436e-04, 8.8e-07], [1.6338e-03, 3.1e-06]],
    ]),
    set(0.1, 0.02, 0.7, [
        [[3.7588e-02, 1.1e-05], [1.1040e-02, 1.7e-05], [1.3292e-02, 2.0e-05]],
        [[7.3832e-03, 1.3e-06], [3.6778e-03, 4.9e-06], [4.9227e-03, 6.3e-06]],
        [[2.2243e-03, 3.3e-07], [1.5041e-03, 1.9e-06], [2.2366e-03, 4.0e-06]],
        [[1.8971e-03, 2.3e-07], [1.3466e-03, 1.5e-06], [2.0530e-03, 3.8e-06]],
        [[7.9509e-04, 6.4e-08], [6.8164e-04, 7.0e-07], [1.1476e-03, 2.5e-06]],
        [[3.4555e-04, 2.1e-08], [3.4497e-04, 3.6e-07], [6.3761e-04, 1.7e-06]],
    ]),
    set(0.5, 0.05, 0.0, [
        [[7.3086e-03, 4.4e-07], [7.5778e-03, 9.4e-06], [3.0015e-02, 6.2e-05]],
        [[1.8545e-03, 1.7e-07], [2.7373e-03, 3.8e-06], [1.7618e-02, 6.6e-05]],
        [[6.8537e-04, 8.9e-08], [1.1834e-03, 1.6e-06], [1.0865e-02, 4.2e-05]],
        [[5.5673e-04, 7.2e-08], [9.8796e-04, 1.4e-06], [9.9573e-03, 4.2e-05]],
        [[2.4949e-04, 4.5e-08], [4.8008e-04, 7.1e-07], [6.4754e-03, 3.5e-05]],
        [[1.1126e-04, 2.3e-08], [2.2626e-04, 3.5e-07], [3.8586e-03, 2.2e-05]],
    ]),
    set(0.5, 0.05, 0.7, [
        [[1.5442e-02, 5.1e-06], [2.1237e-02, 3.5e-05], [5.7958e-02, 1.2e-04]],
        [[2.4407e-03, 6.6e-07], [5.4336e-03, 7.2e-06], [2.4858e-02, 6.3e-05]],
        [[5.5823e-04, 1.3e-07], [1.6073e-03, 2.3e-06], [1.2086e-02, 5.1e-05]],
        [[4.3437e-04, 7.8e-08], [1.3026e-03, 1.8e-06], [1.0990e-02, 4.4e-05]],
        [[1.3353e-04, 2.8e-08], [4.6236e-04, 6.2e-07], [6.1413e-03, 3.0e-05]],
        [[4.0704e-05, 6.1e-09], [1.5733e-04, 2.2e-07], [3.2944e-03, 2.1e-05]],
    ]),
];

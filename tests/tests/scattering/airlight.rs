//! Airlight of a lamp: light that was scattered once.

use super::{EYE, LAMP, fog};
use vitrum_conformance::scattering::{Scene, radiance};
use vitrum_kernels::glam::DVec3;

/// Paths for each viewing ray.
const SAMPLES: u64 = 1 << 18;

/// The largest error, as a share.
const LARGEST: f64 = 0.005;

/// The largest error, in standard errors: of nine, one in forty would be off by more.
const STANDARD_ERRORS: f64 = 3.0;

/// The length of viewing rays, at which the fog ends.
const LENGTH: f64 = 20.0;

/// A point on a viewing ray from the eye, and its airlight for g = 0, 0.7 and −0.7: Sun et al.'s (2005) closed form for
/// g = 0 and a quadrature of its integrand, which agree to 10⁻¹⁴.
#[rustfmt::skip]
const RAYS: [(DVec3, [f64; 3]); 3] = [
    (DVec3::new(0.0, 0.0, 3.0), [2.01190842e-2, 4.10172046e-2, 2.04721163e-2]),
    (DVec3::new(1.0, 0.0, 0.0), [2.82732222e-3, 2.74454766e-3, 1.24755203e-3]),
    (DVec3::new(2.5, 1.0, 4.2), [7.00641145e-3, 1.09372074e-2, 4.50256897e-3]),
];

#[test]
fn airlight_is_that_of_the_closed_form() {
    for (through, expected) in RAYS {
        let direction = (through - EYE).normalize();
        // The face of the box ends the ray.
        let [low, high] = [DVec3::splat(-15.0), DVec3::new(15.0, (EYE + direction * LENGTH).y, 15.0)];
        for (anisotropy, expected) in [0.0, 0.7, -0.7].into_iter().zip(expected) {
            let scene = Scene { medium: fog(low, high, anisotropy), lamp: LAMP, ball: None };
            let found = radiance(&scene, EYE, direction, 1, SAMPLES, 1).once;
            let (error, sure) = (found.mean / expected - 1.0, found.error / expected);
            println!("g = {anisotropy}, through {through}: {error:.1e} ± {sure:.1e}");
            assert!(error.abs() <= LARGEST, "g = {anisotropy}, through {through}: {found:?}, not {expected}");
            assert!(found.off(expected).abs() <= STANDARD_ERRORS, "g = {anisotropy}, through {through}: {found:?}");
        }
    }
}

//! Light that the inside of a ring mirrors once: irradiance of the floor, and radiance of fog, by single scattering to nine digits.
//!
//! The ring is the cylinder x² + y² = 1, 0 ≤ z ≤ 0.7, without thickness, of reflectance 0.9. It stands on a floor in a cube of fog of half edge 3 around its
//! middle, σ_s = 0.1 and σ_a = 0.02. The light comes along (cos 40°, 0, −sin 40°) over the near rim, of an irradiance of 1 in front of the
//! fog: its caustic is a nephroid. Or it comes from a lamp of intensity 10 at (−1, 0, 1.5), above the rim: a cardioid.
//!
//! At the wall's point P(a, z) light of the flux F da dz is mirrored along d. Floor: the rays that reach a point were found by bisection in a; each has F over
//! the Jacobian of its place on the floor. Fog: σ_s ∬ F p(θ) e^(−σ_t s) δ(w · ((P − O) × d)) da dz along the viewing ray O + t w, s all of the way; the
//! integral over z is a root, the one over a was integrated by adaptive quadrature.

/// A point through which the ray goes, and its radiance, for Henyey and Greenstein's phase function of g = 0 and 0.7.
pub type Row = ([f64; 3], [f64; 2]);

/// A point of the floor, and its irradiance.
pub type Place = ([f64; 2], f64);

/// The eye.
pub const EYE: [f64; 3] = [-1.0, -1.6, 2.9];

/// Through fog, in light of one direction.
pub const SUN: [Row; 10] = [
    ([0.5, 0.1, 0.0], [2.51098322e-3, 4.67173111e-4]),
    ([0.45, 0.02, 0.0], [2.43407523e-3, 5.41107175e-4]),
    ([0.52, -0.03, 0.0], [1.08018302e-3, 2.81781965e-4]),
    ([0.7, -0.2, 0.02], [1.32265505e-3, 1.79517707e-4]),
    ([0.8, 0.1, 0.1], [3.12048694e-3, 7.47179721e-4]),
    ([0.55, 0.0, 0.1], [8.76311189e-3, 2.05971006e-3]),
    ([0.6, 0.1, 0.05], [5.06182953e-3, 1.04095016e-3]),
    ([0.66, -0.1, 0.02], [1.78639237e-3, 2.78426743e-4]),
    ([0.4, 0.05, 0.1], [1.63442428e-3, 2.90050381e-4]),
    ([0.75, 0.25, 0.1], [4.57985948e-3, 1.26067854e-3]),
];

/// Through fog, in the lamp's light.
pub const LAMP: [Row; 14] = [
    ([0.5, 0.1, 0.0], [2.52519926e-2, 7.07576782e-3]),
    ([0.45, 0.02, 0.0], [1.55160642e-2, 4.00959850e-3]),
    ([0.52, -0.03, 0.0], [1.24733436e-2, 2.56645815e-3]),
    ([0.7, -0.2, 0.02], [1.77279370e-2, 2.49018889e-3]),
    ([0.8, 0.1, 0.1], [7.91067017e-3, 2.23864254e-3]),
    ([0.55, 0.0, 0.1], [1.74980416e-2, 3.64101003e-3]),
    ([0.6, 0.1, 0.05], [2.08601962e-2, 4.75173177e-3]),
    ([0.66, -0.1, 0.02], [1.54868196e-2, 2.45595171e-3]),
    ([0.4, 0.05, 0.1], [2.36785297e-2, 7.13804125e-3]),
    ([0.75, 0.25, 0.1], [9.28989969e-3, 3.31225397e-3]),
    ([0.3, 0.2, 0.0], [6.82031920e-3, 1.47109095e-3]),
    ([0.1, -0.3, 0.0], [1.18453440e-3, 3.87403637e-4]),
    ([-0.2, 0.2, 0.05], [1.10096054e-3, 2.22237148e-4]),
    ([0.2, 0.5, 0.0], [1.28146967e-3, 1.83503037e-4]),
];

/// Without fog, in light of one direction. The cusp is at (0.5, 0).
pub const FLOOR: [Place; 8] = [
    ([0.47, 0.1], 1.13771276),
    ([0.4, 0.2], 7.20776255e-1),
    ([0.62, 0.3], 0.0),
    ([0.25, 0.0], 1.15701770),
    ([0.45, 0.0], 5.78508849),
    ([0.6, 0.0], 5.52212992),
    ([0.7, -0.2], 3.90830141),
    ([0.3, -0.5], 0.0),
];

/// Behind fog, in the lamp's light.
pub const FLOOR_BY_LAMP: [Place; 6] = [
    ([0.3, 0.1], 1.29595165),
    ([0.1, 0.2], 6.58195591e-1),
    ([0.4, 0.3], 4.83759705e-1),
    ([-0.1, 0.1], 4.96376548e-1),
    ([0.6, 0.2], 2.75107379),
    ([0.2, -0.4], 3.98737454e-1),
];

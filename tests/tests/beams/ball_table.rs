//! Radiance that fog scatters out of the light of a clear ball, and irradiance of the floor below it: single scattering to nine digits.
//!
//! A ball of radius 1 and index 1.5 around the origin; fog of σ_s = 0.1 and σ_a = 0.02 in |x|, |y| ≤ 12, −3 ≤ z ≤ 12; a black floor at z = −3, which
//! ends light and viewing rays, as the ball ends viewing rays. The light is a lamp of 40 W at (0, 0, 4), or comes straight down, of an irradiance
//! of 1 at z = 12. It is refracted twice, or mirrored by the outside, or mirrored once or twice by the inside on its way, each time by Fresnel's
//! equations for light without polarization.
//!
//! A light ray that leaves the ball at P(u, v) along d(u, v) with the flux F du dv makes the radiance
//! σ_s ∬ F p(θ) e^(−σ_t (t + s)) δ(w · ((P − O) × d)) du dv of the viewing ray O + t w, where t and s are the ways to where the two come closest. The ball
//! is round, so that the integral over its azimuth v is a sum over two roots; the one over u was integrated by adaptive quadrature.

/// A viewing ray and its radiance.
pub struct Row {
    /// Its eye.
    pub eye: [f64; 3],
    /// A point on it.
    pub through: [f64; 3],
    /// Radiance by the lamp, for Henyey and Greenstein's phase function of g = 0 and 0.7.
    pub lamp: [f64; 2],
    /// Radiance by light straight down, for the same.
    pub sun: [f64; 2],
}

const fn row(eye: [f64; 3], through: [f64; 3], lamp: [f64; 2], sun: [f64; 2]) -> Row {
    Row { eye, through, lamp, sun }
}

/// In front of the ball.
const FRONT: [f64; 3] = [0.0, -9.0, 0.5];
/// Beside the focus.
const SIDE: [f64; 3] = [4.0, 3.0, -2.2];
/// In the light behind the focus.
const BELOW: [f64; 3] = [0.35, -0.25, -2.9];
/// Almost on the axis: rays go against the light.
const AXIS: [f64; 3] = [0.03, 0.02, -2.95];

/// Viewing rays: around the focus, against the light, and above the ball.
#[rustfmt::skip]
pub const RAYS: [Row; 25] = [
    row(FRONT, [0.03, 0.0, -1.3], [2.87672539e-3, 8.53848464e-4], [1.43933534e-2, 3.93018436e-3]),
    row(FRONT, [0.08, 0.0, -1.3], [2.44249975e-3, 6.40821827e-4], [2.08360109e-3, 9.39521747e-4]),
    row(FRONT, [0.15, 0.0, -1.3], [2.20628981e-3, 5.23702217e-4], [1.19894433e-3, 5.55344539e-4]),
    row(FRONT, [0.4, 0.0, -1.3], [3.72715748e-5, 1.95918675e-5], [3.49092377e-4, 1.47344420e-4]),
    row(FRONT, [0.02, 0.0, -1.8], [4.86604043e-3, 1.12749602e-3], [3.69420302e-3, 1.02679016e-3]),
    row(FRONT, [0.06, 0.0, -1.8], [3.63690432e-3, 8.20007215e-4], [3.06761953e-3, 8.84566741e-4]),
    row(FRONT, [0.2, 0.0, -1.8], [3.55535778e-4, 1.11005350e-4], [1.50291201e-3, 4.96545978e-4]),
    row(FRONT, [0.5, 0.0, -1.8], [1.12654001e-4, 3.81326223e-5], [5.49484453e-4, 2.03305661e-4]),
    row(FRONT, [0.01, 0.0, -2.4], [3.40869026e-3, 7.07955316e-4], [1.33834370e-3, 3.76152770e-4]),
    row(FRONT, [0.04, 0.0, -2.4], [1.64838782e-3, 3.62621970e-4], [1.32668573e-3, 3.73464638e-4]),
    row(FRONT, [0.12, 0.0, -2.4], [7.94081579e-4, 1.88970611e-4], [1.23729810e-3, 3.52682029e-4]),
    row(FRONT, [0.3, 0.0, -2.4], [3.50477874e-4, 9.20264452e-5], [9.13663034e-4, 2.74344934e-4]),
    row(FRONT, [-0.7, 0.0, -2.0], [8.39276611e-5, 2.78183063e-5], [3.86144259e-4, 1.38271735e-4]),
    row(FRONT, [1.2, 0.0, -2.5], [4.47149055e-5, 1.50632569e-5], [1.93250473e-4, 6.79356877e-5]),
    row(FRONT, [0.0, 0.3, -2.7], [2.87995663e-3, 5.83257205e-4], [1.04974432e-3, 2.97948819e-4]),
    row(SIDE, [0.1, 0.0, -1.6], [5.24349519e-3, 2.31898890e-3], [6.01340610e-3, 3.85506509e-3]),
    row(SIDE, [0.0, 0.05, -2.0], [2.16052123e-3, 9.20251333e-4], [3.83452079e-3, 1.89199985e-3]),
    row(SIDE, [-0.1, -0.2, -2.5], [1.56010953e-3, 5.16795592e-4], [1.95504233e-3, 8.35592460e-4]),
    row(BELOW, [0.05, 0.02, -1.2], [1.11836538e-2, 5.63899725e-2], [4.19622812e-2, 2.22670072e-1]),
    row(BELOW, [0.2, -0.1, -1.4], [4.75815526e-3, 2.37275284e-2], [8.06535704e-3, 3.75487526e-2]),
    row(AXIS, [0.025, 0.01, -2.2], [1.07781506e-1, 1.13260147], [1.89454631e-1, 1.60706229]),
    row(FRONT, [1.0, 0.0, 1.5], [2.92773394e-5, 3.27489718e-5], [6.01631245e-5, 7.22998282e-5]),
    row(FRONT, [0.6, 0.0, 1.3], [3.94857190e-5, 5.66678846e-5], [6.72947773e-5, 1.22432062e-4]),
    row(FRONT, [0.3, 0.0, 1.6], [3.00995068e-5, 5.05504763e-5], [5.57642383e-5, 9.01289750e-5]),
    row(FRONT, [1.4, 0.0, 0.8], [4.02523360e-5, 2.98005404e-5], [2.84039559e-5, 5.19880119e-5]),
];

/// Irradiance of the floor in the ball's shadow, behind fog: distance from the axis, by the lamp, by light straight down.
pub const FLOOR: [(f64, f64, f64); 6] = [
    (0.02, 1.50592912, 1.93417734e-1),
    (0.05, 1.14543974, 1.92115170e-1),
    (0.1, 6.62809588e-1, 1.87594838e-1),
    (0.2, 2.79160518e-1, 1.71346878e-1),
    (0.4, 9.18226714e-2, 1.26181631e-1),
    (0.8, 2.28292676e-2, 5.70180410e-2),
];

//! Airlight of a lamp in fog, and the shadows of opaque bodies in it, along single viewing rays.

use super::thin::Thin;
use super::{LAMP, case, on_the_cpu, sheet};
use vitrum::backend::Backend;
use vitrum_conformance::Failure;
use vitrum_conformance::case::Case;
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::refraction::ball;
use vitrum_io::Mesh;
use vitrum_kernels::glam::DVec3;

/// g of the phase functions.
const ANISOTROPIES: [f64; 3] = [0.0, 0.7, -0.7];

/// The eye.
const EYE: DVec3 = DVec3::new(0.0, -9.0, 0.5);

/// The length of viewing rays.
const LENGTH: f64 = 20.0;

/// The largest error of airlight, as a share: 24 points of Gauss's rule leave up to 3 · 10⁻⁵ where the ray passes the lamp, and f32 as much.
const AIRLIGHT: f64 = 1e-4;

/// The largest error of a shadow, as a share of it. The outline of a shadow is that of texels, and a viewing ray crosses 100 or more of the 256 that
/// a body is wide: it gains or loses half a texel at each end.
const SHADOW: f64 = 0.015;

/// The least radiance whose error is a share of it.
const DIM: f64 = 1e-6;

/// A viewing ray from [`EYE`] through a point; its airlight, and the part of it that the body takes away, for each of [`ANISOTROPIES`].
///
/// Single scattering: fog of σ_s = 0.1 and σ_a = 0.02 everywhere, a lamp of 40 W at (0, 0, 4), a ray of length 20. Airlight between the distances t₁ and
/// t₂ is σ_s I / h ∫ p(−sin q) e^(−σ_t (t + h / cos q)) dq with t = t₀ + h tan q, where the foot of the lamp's perpendicular, of length h, is at t₀. It was
/// integrated by adaptive quadrature to 10⁻¹⁴; a shadow is the airlight of the part of the ray within the cone behind the body.
type Row = ([f64; 3], [[f64; 2]; 3]);

const FREE: [Row; 3] = [
    ([0.0, 0.0, 3.0], [[2.01190842e-2, 0.0], [4.10172046e-2, 0.0], [2.04721163e-2, 0.0]]),
    ([1.0, 0.0, 0.0], [[2.82732222e-3, 0.0], [2.74454766e-3, 0.0], [1.24755203e-3, 0.0]]),
    ([2.5, 1.0, 4.2], [[7.00641145e-3, 0.0], [1.09372074e-2, 0.0], [4.50256897e-3, 0.0]]),
];

/// Behind a level disk of radius 0.6, 2 below the lamp.
const DISK: [Row; 4] = [
    ([0.1, 0.0, 0.0], [[2.95661522e-3, 7.69456379e-4], [2.95311525e-3, 2.12905917e-4], [1.32464451e-3, 2.40787790e-4]]),
    (
        [0.9, 0.0, -0.5],
        [[2.39805231e-3, 4.69157619e-4], [2.08764458e-3, 1.17175101e-4], [1.00501263e-3, 1.57868822e-4]],
    ),
    ([1.6, 0.0, 1.0], [[3.79089277e-3, 0.0], [4.39791116e-3, 0.0], [1.86395149e-3, 0.0]]),
    ([0.0, 0.0, 1.8], [[7.14866293e-3, 1.74516961e-3], [1.12470472e-2, 6.51413233e-4], [4.63636702e-3, 4.17654707e-4]]),
];

/// Behind a disk of radius 0.5 across the direction (0.3, 0.2, 1), 1.5 from the lamp.
const TILTED: [Row; 2] = [
    (
        [0.1, 0.0, -1.0],
        [[2.09791240e-3, 2.28215753e-4], [1.66487615e-3, 6.80113476e-5], [8.48280758e-4, 6.10902998e-5]],
    ),
    ([1.0, 0.0, -2.0], [[1.56129929e-3, 0.0], [9.98173272e-4, 0.0], [5.96573450e-4, 0.0]]),
];

/// Behind the unit ball around the origin.
const BALL: [Row; 3] = [
    (
        [0.2, 0.0, -1.5],
        [[1.81199582e-3, 4.01665557e-4], [1.29424266e-3, 8.92124088e-5], [7.09426223e-4, 1.61449652e-4]],
    ),
    (
        [1.0, 0.0, -1.2],
        [[1.92592789e-3, 2.90734233e-4], [1.43793152e-3, 6.52069094e-5], [7.63496779e-4, 1.10029210e-4]],
    ),
    (
        [1.3, 0.0, -2.5],
        [[1.37703043e-3, 1.87907300e-4], [7.99582826e-4, 3.62068669e-5], [5.19274109e-4, 9.04595967e-5]],
    ),
];

/// A disk of 512 sides.
fn disk(middle: DVec3, normal: DVec3, radius: f64) -> Mesh {
    const SIDES: u32 = 512;
    let (right, up) = normal.normalize().any_orthonormal_pair();
    let corner = |side: u32| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(side) / f64::from(SIDES)).sin_cos();
        middle + (right * cos + up * sin) * radius
    };
    let corners: Vec<DVec3> = std::iter::once(middle).chain((0..SIDES).map(corner)).collect();
    let triangles: Vec<[u32; 3]> = (0..SIDES).map(|side| [0, 1 + side, 1 + (side + 1) % SIDES]).collect();
    sheet(&corners, &triangles)
}

fn in_fog(body: &Mesh, anisotropy: f64) -> Result<Case, Failure> {
    let medium =
        format!("medium={{absorption=[0.02,0.02,0.02],scattering=[0.1,0.1,0.1],anisotropy={anisotropy},extent=15}}");
    case(body.clone(), 1, &[LAMP, &medium, "beams.rays=256", "material=[{opaque=true,color=[0,0,0]}]"])
}

/// A black wall that ends the viewing ray through a point, at a right angle to it as seen from above.
fn wall(body: &Mesh, through: DVec3) -> String {
    let towards = (through - EYE).normalize();
    let level = DVec3::new(towards.x, towards.y, 0.0).normalize();
    let [low, high] = body.bounds().map(|corner| DVec3::from_array(corner.map(f64::from)));
    let distance = (EYE + towards * LENGTH - (low + high) * 0.5).dot(level);
    // The wall faces the eye; azimuth 0 is +y, and 90° is −x.
    let azimuth = level.x.atan2(-level.y).to_degrees();
    format!("wall={{azimuth={azimuth},distance={distance},color=[0,0,0]}}")
}

/// Holds airlight and shadow along rays, and their largest errors to a line of the table if it is of them.
fn hold(
    bodies: &[(Mesh, &[Row])],
    airlight: Option<table::ErrorBound>,
    shadow: Option<table::ErrorBound>,
) -> Result<(), Failure> {
    on_the_cpu(|backend| {
        let mut worst = [0.0; 2];
        for (body, rows) in bodies {
            worst = errors(body, rows, worst, backend)?;
        }
        for (line, worst) in [airlight, shadow].into_iter().zip(worst) {
            line.into_iter().for_each(|line| line.hold(worst, backend));
        }
        Ok(())
    })
}

/// The largest errors of airlight and shadow behind a body, if they are larger than `worst`.
fn errors(body: &Mesh, rows: &[Row], mut worst: [f64; 2], backend: &mut dyn Backend) -> Result<[f64; 2], Failure> {
    for (number, anisotropy) in ANISOTROPIES.into_iter().enumerate() {
        let mut thin = Thin::new(in_fog(body, anisotropy)?, backend);
        for (through, values) in rows {
            let (through, [airlight, shadow]) = (DVec3::from_array(*through), values[number]);
            thin.set(&wall(body, through))?;
            let found = thin.look(EYE, through)?;
            let errors = [found.airlight[0] / airlight - 1.0, (found.shadow[0] - shadow) / shadow.max(DIM)];
            println!("g = {anisotropy}, through {through}: {:.1e}, {:.1e}", errors[0], errors[1]);
            assert!(errors[0].abs() <= AIRLIGHT, "g = {anisotropy}, through {through}: {found:?}");
            assert!(errors[1].abs() <= SHADOW, "g = {anisotropy}, through {through}: {found:?}, not {shadow}");
            worst = [0, 1].map(|part| larger(errors[part].abs(), worst[part]));
        }
    }
    Ok(worst)
}

#[test]
fn airlight_of_a_lamp_in_fog() -> Result<(), Failure> {
    // In nobody's way.
    hold(&[(disk(DVec3::ZERO, DVec3::Z, 0.05), &FREE)], Some(table::BEAMS_AIRLIGHT), None)
}

#[test]
fn disks_cast_shadows_in_fog() -> Result<(), Failure> {
    let normal = DVec3::new(0.3, 0.2, 1.0);
    let level = disk(DVec3::Z * 2.0, DVec3::Z, 0.6);
    let tilted = disk(DVec3::Z * 4.0 - normal.normalize() * 1.5, normal, 0.5);
    hold(&[(level, &DISK), (tilted, &TILTED)], None, Some(table::BEAMS_SHADOW_OF_DISKS))
}

#[test]
fn a_ball_casts_a_shadow_in_fog() -> Result<(), Failure> {
    hold(&[(ball(256), &BALL)], None, Some(table::BEAMS_SHADOW_OF_A_BALL))
}

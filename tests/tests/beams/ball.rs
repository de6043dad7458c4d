//! A clear ball in fog: the light that it sends through the fog and onto the floor, ray by ray.

use super::ball_table::{FLOOR, RAYS, Row};
use super::thin::Thin;
use super::{LAMP, SUN, case, on_the_cpu, rms};
use vitrum::backend::{Backend, CpuBackend};
use vitrum_conformance::case::Case;
use vitrum_conformance::closed_forms::table::{self, ErrorBound};
use vitrum_conformance::refraction::ball;
use vitrum_conformance::{Failure, adapter};
use vitrum_kernels::glam::DVec3;

/// The least radiance whose error is a share of it; errors of dimmer rays are shares of this.
/// Above it are no rays that see mirrored light alone, above the ball, which with g = 0.7 is up to 6 % off.
const BRIGHT: f64 = 1.25e-4;

/// The largest error with 256 rays of light along an edge. Light is linear over a beam's cross-section, and some of the rays come within a beam's
/// width of the edge of a caustic, where the light is least linear.
const LARGEST: f64 = 0.02;

/// The largest error, root mean square over the rays, with 256 rays of light along an edge: few rays come as close to an edge.
const LARGEST_RMS: f64 = 0.01;

/// The least order of convergence. It is 2 where light is smooth, and less at the edge of a caustic, behind which there is no light.
const ORDER: f64 = 1.4;

/// The least order by light straight down: several rays of the table look at the rim of its caustics, where the texels of a square lattice end in steps, and
/// the error falls with the texel's edge. Found is 0.98.
const ORDER_BY_SUN: f64 = 0.9;

/// The rays that the GPU looks along, and its rays of light along an edge, fewer of which only make errors larger: kernels write the same bits on both
/// backends, and light takes its time on a software adapter.
const EVERY: usize = 12;
const RAYS_ON_GPU: u32 = 128;

/// A ball of index 1.5 in fog up to |x|, |y|, z ≤ 12, above a floor at z = −3 of a reflectance.
pub fn in_fog(light: &str, anisotropy: f64, floor: f64, rays: u32) -> Result<Case, Failure> {
    let medium =
        format!("medium={{absorption=[0.02,0.02,0.02],scattering=[0.1,0.1,0.1],anisotropy={anisotropy},extent=12}}");
    let (ground, rays) = (format!("ground={{height=-3,color={:?}}}", [floor; 3]), format!("beams.rays={rays}"));
    case(ball(256), 1, &[light, &medium, &ground, &rays, "material=[{ior=1.5}]", "beams.pyramid=false"])
}

/// What is looked at: a light, and g of the phase function.
type Set = (&'static str, f64, fn(&Row) -> f64);

const SETS: [Set; 4] = [
    (LAMP, 0.0, |row| row.lamp[0]),
    (LAMP, 0.7, |row| row.lamp[1]),
    (SUN, 0.0, |row| row.sun[0]),
    (SUN, 0.7, |row| row.sun[1]),
];

/// The caustics that every `step`th ray of the table sees, and what the table says.
fn looks(set: &Set, rays: u32, step: usize, backend: &mut dyn Backend) -> Result<Vec<[f64; 2]>, Failure> {
    let &(light, anisotropy, expected) = set;
    let mut thin = Thin::new(in_fog(light, anisotropy, 0.0, rays)?, backend);
    let look = |row: &Row| {
        let seen = thin.look(DVec3::from_array(row.eye), DVec3::from_array(row.through))?;
        Ok([seen.caustics[0], expected(row)])
    };
    RAYS.iter().step_by(step).filter(|row| expected(row) > BRIGHT).map(look).collect()
}

/// The error, as a share.
fn error([found, expected]: [f64; 2]) -> f64 {
    found / expected - 1.0
}

/// Holds every `step`th ray by `rays` rays of light along an edge, and their root mean square; gives that.
fn hold(set: &Set, rays: u32, step: usize, backend: &mut dyn Backend) -> Result<f64, Failure> {
    let errors: Vec<f64> = looks(set, rays, step, backend)?.into_iter().map(error).collect();
    let mean = rms(errors.iter().copied());
    println!("{}, g = {}: {mean:.2e} on {}, {errors:.4?}", set.0, set.1, backend.name());
    for (error, row) in errors.iter().zip(RAYS.iter().step_by(step).filter(|row| set.2(row) > BRIGHT)) {
        assert!(
            error.abs() <= LARGEST,
            "{}, g = {}: off by {error:.2e} from {:?} through {:?}",
            set.0,
            set.1,
            row.eye,
            row.through
        );
    }
    assert!(mean <= LARGEST_RMS, "{}, g = {}: off by {mean:.2e}", set.0, set.1);
    Ok(mean)
}

#[test]
fn thin_rays_see_the_light_of_a_ball() -> Result<(), Failure> {
    let (mut cpu, mut gpu) = (CpuBackend::new(None)?, adapter::for_test());
    // Light straight down is held by the order of convergence and on the floor.
    let lines: [ErrorBound; 2] = [table::BEAMS_BALL, table::BEAMS_BALL_FORWARD];
    for (set, line) in SETS.iter().zip(lines) {
        line.hold(hold(set, 256, 1, &mut cpu)?, &cpu);
        gpu.as_mut().map_or(Ok(0.0), |gpu| hold(set, RAYS_ON_GPU, EVERY, gpu))?;
    }
    Ok(())
}

/// Errors fall with a power of the number of rays of light along an edge.
#[test]
fn errors_converge_with_the_rays_of_light() -> Result<(), Failure> {
    let mut cpu = CpuBackend::new(None)?;
    for (set, least) in [(&SETS[0], ORDER), (&SETS[2], ORDER_BY_SUN)] {
        let mut of = |rays: u32| Ok::<f64, Failure>(rms(looks(set, rays, 1, &mut cpu)?.into_iter().map(error)));
        let [coarse, middle, fine] = [of(32)?, of(64)?, of(128)?];
        let order = (coarse / fine).log2() / 2.0;
        println!("{}: {coarse:.2e}, {middle:.2e}, {fine:.2e}, of order {order:.2}", set.0);
        assert!(order >= least, "{}: {coarse:.2e} to {fine:.2e} is of order {order:.2}", set.0);
    }
    Ok(())
}

/// The floor in the ball's shadow has a radiance of E / π times the transmittance of the fog in front of it.
#[test]
fn the_floor_is_lit_through_the_ball() -> Result<(), Failure> {
    on_the_cpu(|backend| {
        for (light, expected) in [(LAMP, FLOOR.map(|(r, lamp, _)| (r, lamp))), (SUN, FLOOR.map(|(r, _, sun)| (r, sun)))]
        {
            let mut thin = Thin::new(in_fog(light, 0.0, 1.0, 256)?, backend);
            // What is reflected twice within the ball comes to the floor, too, and is not in the table.
            thin.set("beams.threshold=0.01")?;
            for (r, expected) in expected {
                let (eye, point) = (DVec3::new(0.2, -4.0, -2.0), DVec3::new(r, 0.0, -3.0));
                let fog = (-0.12 * (point - eye).length()).exp();
                let found = thin.look(eye, point)?.surfaces[0] * std::f64::consts::PI / fog;
                println!("{light}, r = {r}: {:.2e}", found / expected - 1.0);
                assert!((found / expected - 1.0).abs() <= LARGEST, "{light}, r = {r}: {found}, not {expected}");
            }
        }
        Ok(())
    })
}

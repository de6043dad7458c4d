//! Light that the medium scatters more than once: the estimate beside paths of light, in fog around a lamp and in fog around a clear ball.

use super::thin::Thin;
use super::{LAMP, case, on_both, on_the_cpu, red, rms};
use vitrum::backend::Backend;
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction::{ball, cuboid};
use vitrum_conformance::scattering::table::{EYE, SETS, Set, THROUGH};
use vitrum_conformance::scattering::{Ball, Camera, Scene, picture};
use vitrum_conformance::{Failure, frames};
use vitrum_io::Mesh;
use vitrum_kernels::glam::{DQuat, DVec3};

/// The largest error of a ray in fog that scatters equally to all sides, as a share: it is the one of the ray that passes the lamp at a distance of two
/// cells, whose light falls by half from cell to cell. The others are up to 4.2 % off.
const LARGEST: f64 = 0.08;

/// The largest error, root mean square over rays, in such fog: over all six it is 4.1 %, over the three that are followed to 32 orders, of which one is the ray that
/// passes the lamp, 5.0 %.
const LARGEST_RMS: f64 = 0.055;

/// The same in fog that scatters forward (g = 0.7): a cell knows one direction of its light, and the peak is narrower than cells beside each other are apart. Over
/// all six rays it is 15 %, over the three 17 %.
const LARGEST_FORWARD: f64 = 0.24;
const LARGEST_RMS_FORWARD: f64 = 0.18;

/// Sets, the largest error of all light around a ball, as a share, and the largest error of a pixel, root mean square over the mean. Light that has been scattered
/// goes straight through the ball in the estimate; a cell of the denser fog is a third of a mean free path wide. Photons leave noise of 0.03.
const AROUND_BALL: [(Set, f64, f64); 2] = [(SETS[0], 0.02, 0.05), (SETS[2], 0.05, 0.07)];

/// Pixels of pictures along each edge.
const EDGE: usize = 16;

/// Fog of a set from −5 to 5 around a body, where light is scattered up to `orders` times.
fn in_fog(set: &Set, orders: u32, mesh: Mesh, edge: u32, body: &str) -> Result<Case, Failure> {
    let &Set { scattering, absorption, anisotropy, .. } = set;
    let medium = format!(
        "medium={{scattering={:?},absorption={:?},anisotropy={anisotropy},extent=5}}",
        [scattering; 3], [absorption; 3]
    );
    let orders = format!("beams.orders={orders}");
    case(mesh, edge, &[LAMP, &medium, &orders, body, "beams.rays=32"])
}

/// Errors of the radiance along every `step`th ray, of light that is scattered up to `orders` times in fog with a black speck, which number `column` of the set holds.
fn errors(
    set: &Set,
    (orders, column): (u32, usize),
    step: usize,
    backend: &mut dyn Backend,
) -> Result<Vec<f64>, Failure> {
    let speck = cuboid(DVec3::splat(0.01), DQuat::IDENTITY);
    let mut thin = Thin::new(in_fog(set, orders, speck, 1, "material=[{opaque=true,color=[0,0,0]}]")?, backend);
    let looks = THROUGH.into_iter().zip(set.radiance()).step_by(step);
    looks.map(|(through, expected)| Ok(thin.look(EYE, through)?.multiple[0] / expected[column].mean - 1.0)).collect()
}

/// Light that fog scatters exactly twice, and all that it scatters more than once: of what is scattered more than 32 times a ten-thousandth is left.
#[test]
fn fog_around_a_lamp() -> Result<(), Failure> {
    on_the_cpu(|backend| {
        for set in &SETS {
            // Many orders take their time.
            for (look, step) in [((2, 1), 1), ((32, 2), 2)] {
                let errors = errors(set, look, step, backend)?;
                let mean = rms(errors.iter().copied());
                println!("σ_s {}, g {}, {look:?}: {mean:.3}, {errors:.3?}", set.scattering, set.anisotropy);
                let forward = set.anisotropy > 0.0;
                let (largest, most) =
                    if forward { (LARGEST_FORWARD, LARGEST_RMS_FORWARD) } else { (LARGEST, LARGEST_RMS) };
                assert!(errors.iter().all(|error| error.abs() <= largest), "{set:?}, {look:?}: {errors:?}");
                assert!(mean <= most, "{set:?}, {look:?}: {mean}");
            }
        }
        Ok(())
    })
}

/// One ray of it on both backends, and no such light without further orders.
#[test]
fn orders_are_scattered_on_both_backends() -> Result<(), Failure> {
    on_both(|backend| {
        assert!(errors(&SETS[0], (2, 1), THROUGH.len(), backend)?[0].abs() <= LARGEST);
        assert_eq!(errors(&SETS[0], (1, 1), THROUGH.len(), backend)?, [-1.0]);
        Ok(())
    })
}

/// Fog around a clear ball: its caustic and its shadow are sources of such light.
#[test]
fn fog_around_a_ball() -> Result<(), Failure> {
    let target = DVec3::new(0.0, 0.0, -0.3);
    on_the_cpu(|backend| {
        for (set, largest, most) in &AROUND_BALL {
            let mut case = in_fog(set, 32, ball(64), 4 * EDGE as u32, "material=[{ior=1.5}]")?;
            for setting in ["camera.position=[0,-9,0.5]", "camera.target=[0,0,-0.3]", "camera.field_of_view=40"] {
                case.scene.set(setting)?;
            }
            let fine = red(&frames::render(&case, backend)?, "multiple");
            let block = |number: usize| {
                let (column, row) = (number % EDGE * 4, number / EDGE * 4);
                let rows = (row..row + 4).flat_map(|row| &fine[row * 4 * EDGE + column..][..4]);
                rows.sum::<f64>() / 16.0
            };
            let body = Ball { centre: DVec3::ZERO, radius: 1.0, ior: 1.5 };
            let scene = Scene { ball: Some(body), ..set.scene() };
            let photons = picture(&scene, &Camera::new(EYE, target, 40.0, [EDGE; 2]), 1 << 20, 3).pixels;
            let found: Vec<f64> = (0..EDGE * EDGE).map(block).collect();
            let right: Vec<f64> = photons.iter().map(|pixel| pixel.more.mean).collect();
            let [sum, mean] = [&found, &right].map(|values| values.iter().sum::<f64>() / values.len() as f64);
            let noise = rms(photons.iter().map(|pixel| pixel.more.error)) / mean;
            let pixels = rms(found.iter().zip(&right).map(|(found, right)| found - right)) / mean;
            println!("σ_s {}: {:.3}, pixels {pixels:.3}, of photons {noise:.3}", set.scattering, sum / mean - 1.0);
            assert!((sum / mean - 1.0).abs() <= *largest, "{sum}, not {mean}");
            assert!(pixels <= *most, "{pixels:.3}");
        }
        Ok(())
    })
}

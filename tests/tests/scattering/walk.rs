//! The random walks of photons: where they are after some collisions, how many are absorbed at each, and that none is
//! lost.

use super::{LAMP, lamp_in_fog};
use std::f64::consts::PI;
use vitrum_conformance::scattering::{Ball, Camera, Lamp, Ledger, Medium, Photon, Random, Scene, picture};
use vitrum_kernels::glam::DVec3;

/// Photons of a walk.
const PHOTONS: u64 = 200_000;

/// The largest error, in standard errors: of a hundred, one in three hundred would be off by more.
const STANDARD_ERRORS: f64 = 4.0;

/// What sums of a million numbers lose.
const ROUNDING: f64 = 1e-9;

/// A lamp in the middle of a cube.
fn in_cube(half: f64, scattering: f64, absorption: f64, anisotropy: f64) -> Scene {
    let medium = Medium { low: DVec3::splat(-half), high: DVec3::splat(half), scattering, absorption, anisotropy };
    Scene { medium, lamp: Lamp::Point { position: DVec3::ZERO, intensity: 1.0 }, ball: None }
}

fn ledger(scene: &Scene) -> Ledger {
    let camera = Camera::new(DVec3::Y * -1e5, DVec3::ZERO, 40.0, [1; 2]);
    picture(scene, &camera, PHOTONS, 3).ledger
}

/// In a medium without end a share (1 − ω) ωᵏ⁻¹ of all light is absorbed at its kth collision.
#[test]
fn collisions_absorb_a_series_of_albedos() {
    let scene = in_cube(1e6, 0.8, 0.2, 0.3);
    let Ledger { emitted, escaped, absorbed } = ledger(&scene);
    assert!((emitted / (4.0 * PI) - 1.0).abs() < ROUNDING && escaped == 0.0);
    let mut expected = 0.2;
    for (number, flux) in absorbed.iter().take(20).enumerate() {
        let error = (expected * (1.0 - expected) / PHOTONS as f64).sqrt();
        let off = (flux / emitted - expected) / error;
        println!("collision {}: {:.5} of {expected:.5}, {off:.1} standard errors", number + 1, flux / emitted);
        assert!(off.abs() < STANDARD_ERRORS, "collision {}", number + 1);
        expected *= 0.8;
    }
}

/// After n free paths of mean ℓ a photon has come ℓ (1 + g + … + gⁿ⁻¹) in its first direction, and the mean square of
/// its distance is 2 ℓ² (n + (n − 1) g + (n − 2) g² + … + gⁿ⁻¹): free paths have a mean square of 2 ℓ², and directions
/// k collisions apart a mean cosine of gᵏ.
#[test]
fn photons_walk_as_far_as_they_should() {
    const LAST: u32 = 8;
    for (batch, anisotropy) in (0..).zip([0.0, 0.7, -0.5]) {
        let scene = in_cube(1e6, 0.45, 0.05, anisotropy);
        let mut random = Random::new(4, batch);
        // For each collision: photons; sums and sums of squares of the way ahead and of the square of the distance.
        let mut sums = [[0.0; 5]; LAST as usize];
        for _ in 0..PHOTONS {
            let photon = Photon::start(&scene, &mut random);
            photon.follow(&scene, &mut random, |now, _, collision, _| {
                if (1..=LAST).contains(&collision) {
                    let (ahead, square) = (now.at.dot(photon.towards), now.at.length_squared());
                    let sums = &mut sums[collision as usize - 1];
                    let values = [1.0, ahead, ahead * ahead, square, square * square];
                    *sums = std::array::from_fn(|index| sums[index] + values[index]);
                }
            });
        }
        for (n, [count, ahead, ahead_squares, square, square_squares]) in (1..).zip(sums) {
            let power = |k: i32| f64::powi(anisotropy, k);
            let path = 2.0;
            let expected = [
                path * (0..n).map(power).sum::<f64>(),
                2.0 * path * path * (f64::from(n) + (1..n).map(|k| f64::from(n - k) * power(k)).sum::<f64>()),
            ];
            let found = [[ahead, ahead_squares], [square, square_squares]].map(|sums| sums.map(|sum| sum / count));
            let off = [0, 1].map(|index: usize| {
                let [mean, squares] = found[index];
                (mean - expected[index]) / ((squares - mean * mean) / count).sqrt()
            });
            println!("g = {anisotropy}, {n} paths: {off:.1?} standard errors of {expected:.3?}");
            assert!(off.iter().all(|off| off.abs() < STANDARD_ERRORS), "g = {anisotropy}, {n} paths: {off:?}");
        }
    }
}

/// Where nothing absorbs all light escapes, however often it is scattered before: across 20 free paths hundreds of
/// times.
#[test]
fn light_escapes_where_nothing_absorbs_it() {
    let Ledger { emitted, escaped, absorbed } = ledger(&in_cube(10.0, 1.0, 0.0, 0.0));
    assert!((escaped / emitted - 1.0).abs() < ROUNDING && absorbed.is_empty(), "{escaped} of {emitted} escapes");
}

/// Light of either source ends as escaped or absorbed, with a ball in its way, too; halves of photons that go to it and
/// past it carry the source's flux.
#[test]
fn no_light_is_lost() {
    let ball = Some(Ball { centre: DVec3::new(0.5, 0.0, -1.0), radius: 1.5, ior: 1.5 });
    let sun = Lamp::Distant { direction: DVec3::new(0.48, 0.6, -0.64), irradiance: 2.0 };
    // Across the sun the cube's faces have an area of 100 (0.48 + 0.6 + 0.64).
    for (lamp, flux) in [(LAMP, 40.0), (sun, 2.0 * 172.0)] {
        for ball in [None, ball] {
            let Ledger { emitted, escaped, absorbed } = ledger(&Scene { lamp, ball, ..lamp_in_fog(0.7) });
            let ended = escaped + absorbed.iter().sum::<f64>();
            println!("{lamp:?}: {emitted:.3} W, {escaped:.3} escape");
            assert!((ended / emitted - 1.0).abs() < ROUNDING, "{ended} of {emitted}");
            // How many photons go to the ball is drawn at random, and each carries at most twice the flux of all.
            let error = 2.0 * flux / (PHOTONS as f64).sqrt();
            assert!((emitted - flux).abs() < if ball.is_some() { STANDARD_ERRORS * error } else { ROUNDING * flux });
        }
    }
}

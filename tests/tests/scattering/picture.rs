//! Pictures by photons against paths from the eye, and against a picture of single scattering around a ball.

use super::picture_table::{EDGE, LEFT, UNIT};
use super::{LAMP, camera, fog, hold, lamp_in_fog};
use vitrum_conformance::scattering::{Ball, Estimate, Lamp, Orders, Scene, picture, pixel};
use vitrum_kernels::glam::DVec3;

/// The largest difference of the sum over a picture, as a share: three to five times its standard error.
const WHOLE: f64 = 0.01;

/// Holds pixels, and their sum, to others.
fn compare(found: &[Estimate], expected: &[Estimate], what: &str) {
    let off: Vec<f64> = found.iter().zip(expected).map(|(found, expected)| found.off_from(*expected)).collect();
    hold(&off, what);
    let sum = |of: &[Estimate]| of.iter().map(|pixel| pixel.mean).sum::<f64>();
    let whole = sum(found) / sum(expected) - 1.0;
    println!("{what}: the whole is off by {whole:.1e}");
    assert!(whole.abs() <= WHOLE, "{what}: the whole is off by {whole:.1e}");
}

/// A part of a pixel's light.
type Part = fn(&Orders) -> Estimate;

fn once(pixel: &Orders) -> Estimate {
    pixel.once
}

fn more(pixel: &Orders) -> Estimate {
    pixel.more
}

fn all(pixels: &[Orders], part: Part) -> Vec<Estimate> {
    pixels.iter().map(part).collect()
}

/// Holds photons to paths.
fn agree(scene: &Scene, what: &str) {
    const PIXELS: usize = 8;
    let camera = camera(PIXELS);
    let photons = picture(scene, &camera, 1 << 21, 5).pixels;
    let path = |number| {
        let place = [number % PIXELS, number / PIXELS];
        pixel(scene, &camera, place, u32::MAX, 1 << 13, 6 + number as u64)
    };
    let paths: Vec<Orders> = (0..camera.pixels()).map(path).collect();
    for (part, name) in [(once as Part, "once"), (more, "more")] {
        compare(&all(&photons, part), &all(&paths, part), &format!("{what}, scattered {name}"));
    }
}

/// The two estimators share the medium, and neither where paths start nor where they end.
#[test]
fn photons_and_paths_of_a_lamp_agree() {
    for anisotropy in [0.0, 0.7] {
        agree(&lamp_in_fog(anisotropy), &format!("a lamp, g = {anisotropy}"));
    }
}

#[test]
fn photons_and_paths_of_the_sun_agree() {
    let sun = Lamp::Distant { direction: DVec3::new(0.48, 0.6, -0.64), irradiance: 1.0 };
    agree(&Scene { lamp: sun, ..lamp_in_fog(0.7) }, "the sun, g = 0.7");
}

/// Outlines of the ball are in the picture, and its caustic, with the spot of light below it.
#[test]
fn photons_around_a_ball_are_those_of_single_scattering() {
    let [low, high] = [DVec3::new(-12.0, -12.0, -3.0), DVec3::splat(12.0)];
    let ball = Ball { centre: DVec3::ZERO, radius: 1.0, ior: 1.5 };
    let scene = Scene { medium: fog(low, high, 0.0), lamp: LAMP, ball: Some(ball) };
    let found = picture(&scene, &camera(EDGE), 1 << 22, 7).pixels;
    let expected = |number: usize| {
        let (row, column) = (number / EDGE, number % EDGE);
        let mean = f64::from(LEFT[row][column.min(EDGE - 1 - column)]) * UNIT;
        Estimate { mean, error: 0.0 }
    };
    let expected: Vec<Estimate> = (0..EDGE * EDGE).map(expected).collect();
    compare(&all(&found, once), &expected, "a ball");
}

#[test]
fn estimates_do_not_depend_on_threads() {
    let scene = lamp_in_fog(0.7);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads start");
        pool.install(|| {
            let camera = camera(2);
            (picture(&scene, &camera, 1 << 12, 8), pixel(&scene, &camera, [1, 0], u32::MAX, 1 << 12, 8))
        })
    };
    assert!(with(1) == with(3), "the sums differ in their bits");
}

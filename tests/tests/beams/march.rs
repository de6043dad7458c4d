//! The estimator `hu2010`: its constant is right for light that crosses a parallel view at a right angle, and for nothing else.

use super::ball::in_fog;
use super::{LAMP, SUN, case, on_both, red, rms};
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction::cuboid;
use vitrum_conformance::shadow::view;
use vitrum_conformance::{Failure, frames};
use vitrum_kernels::glam::{DQuat, DVec3};

/// The largest difference from beams where the constant is right, as a share: the filter's sum over steps of its own radius varies by a tenth along the viewing
/// ray, and the light of the plate is ten steps deep.
const LARGEST: f64 = 0.01;

/// The least difference from beams in the picture of a ball in fog, root mean square over the brightest pixel: light comes nearer to the eye than the ball, and
/// is oblique. It shows that no constant fits.
const LEAST: f64 = 1e-3;

/// The largest of it.
const MOST: f64 = 0.05;

/// Pixels of a picture along each edge.
const EDGE: usize = 24;
/// Half the height of the picture.
const HALF: f64 = 0.75;

/// Light straight down through a plate, seen from the side in a parallel view.
fn below_a_plate(settings: &[&str]) -> Result<Case, Failure> {
    let usual = [
        SUN,
        "material=[{ior=1.5}]",
        "medium={scattering=[0.1,0.1,0.1],extent=4}",
        "camera.projection=orthographic",
        "camera.position=[-3.1,-8.5,-1.2]",
        "camera.target=[0,0,-1.2]",
        "beams.rays=128",
    ];
    let mut case = case(cuboid(DVec3::new(1.0, 1.0, 0.1), DQuat::IDENTITY), EDGE as u32, &[&usual, settings].concat())?;
    case.scene.camera.zoom = (view(&case).half_size[1] / HALF) as f32;
    Ok(case)
}

/// The middle of a picture, in which all pixels see the light of the plate.
fn middle(caustics: &[f64]) -> Vec<f64> {
    let (first, end) = (EDGE / 4, 3 * EDGE / 4);
    (first..end).flat_map(|row| &caustics[row * EDGE + first..row * EDGE + end]).copied().collect()
}

/// The error of the sum over pixels, and the error of pixels, root mean square, as shares.
fn errors(found: &[f64], expected: &[f64]) -> (f64, f64) {
    let [whole, right] = [found, expected].map(|values| values.iter().sum::<f64>());
    (whole / right - 1.0, rms(found.iter().zip(expected).map(|(found, expected)| found / expected - 1.0)))
}

#[test]
fn its_constant_is_right_where_light_crosses_the_view() -> Result<(), Failure> {
    on_both(|backend| {
        let mut render = |settings: &[&str]| {
            Ok::<_, Failure>(middle(&red(&frames::render(&below_a_plate(settings)?, backend)?, "caustics")))
        };
        let expected = render(&[])?;
        let (mean, even) = errors(&render(&["beams.estimator=hu2010"])?, &expected);
        println!("{mean:.2e}, pixels {even:.2e}");
        assert!(mean.abs() <= LARGEST, "{mean:.2e}");
        // A support of a tenth of a step leaves most lines out, and weights the others so much more (Fig. 10 of the paper).
        let (mean, noise) = errors(&render(&["beams.estimator=hu2010", "beams.filter_radius=0.1"])?, &expected);
        println!("{mean:.2e}, pixels {noise:.2e}");
        assert!(noise > 2.0 * even, "{noise:.2e} and {even:.2e}");
        Ok(())
    })
}

#[test]
fn it_is_wrong_where_light_is_oblique() -> Result<(), Failure> {
    on_both(|backend| {
        let mut render = |estimator: &str| {
            let mut case = in_fog(LAMP, 0.0, 0.0, 64)?;
            case.resize(64);
            for setting in ["camera.position=[0,-9,0.5]", "camera.target=[0,0,-0.3]", "camera.field_of_view=40"] {
                case.scene.set(setting)?;
            }
            case.scene.set(&format!("beams.estimator={estimator}"))?;
            frames::render(&case, backend)
        };
        let (beams, march) = (render("beams")?, render("hu2010")?);
        let (expected, found) = (red(&beams, "caustics"), red(&march, "caustics"));
        let brightest = expected.iter().copied().fold(0.0, f64::max);
        let error = rms(expected.iter().zip(&found).map(|(expected, found)| found - expected)) / brightest;
        println!("{error:.2e} of the brightest pixel");
        assert!((LEAST..=MOST).contains(&error), "{error:.2e}");
        // The shadow is that of beams.
        let [expected, found] = [&beams, &march].map(|frame| red(frame, "shadow"));
        assert!(expected.iter().zip(&found).all(|(expected, found)| (expected - found).abs() <= 1e-3 * brightest));
        Ok(())
    })
}

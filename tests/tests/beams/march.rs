//! The estimator `hu2010`: its constant is right for light that crosses a parallel view at a right angle, and for nothing else.

use super::ball::in_fog;
use super::{LAMP, SUN, case, on_both, red, rms};
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction::cuboid;
use vitrum_conformance::shadow::view;
use vitrum_conformance::{Failure, frames};
use vitrum_kernels::glam::{DQuat, DVec3};

/// The largest difference from beams where the constant is right, as a share: the filter's sum over steps of its own radius varies by a tenth along the viewing
/// ray, and the light of the plate is 10 steps deep. Found is 0.4 %.
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
        "camera.position=[0,-9,-1.2]",
        "camera.target=[0,0,-1.2]",
        "beams.rays=128",
    ];
    let mut case = case(cuboid(DVec3::new(1.0, 1.0, 0.1), DQuat::IDENTITY), EDGE as u32, &[&usual, settings].concat())?;
    case.scene.camera.zoom = (view(&case).half_size[1] / HALF) as f32;
    Ok(case)
}

/// The mean over the middle of the picture, in which light comes from all of the plate, and the deviation from it, root mean square.
fn mean(caustics: &[f64]) -> (f64, f64) {
    let middle: Vec<f64> = (EDGE / 4..3 * EDGE / 4)
        .flat_map(|row| &caustics[row * EDGE + EDGE / 4..row * EDGE + 3 * EDGE / 4])
        .copied()
        .collect();
    let mean = middle.iter().sum::<f64>() / middle.len() as f64;
    (mean, rms(middle.iter().map(|value| value / mean - 1.0)))
}

#[test]
fn its_constant_is_right_where_light_crosses_the_view() -> Result<(), Failure> {
    on_both(|backend| {
        let mut render = |settings: &[&str]| {
            Ok::<_, Failure>(mean(&red(&frames::render(&below_a_plate(settings)?, backend)?, "caustics")))
        };
        let (expected, _) = render(&[])?;
        let (found, even) = render(&["beams.estimator=hu2010"])?;
        println!("{}, {even}", found / expected - 1.0);
        assert!((found / expected - 1.0).abs() <= LARGEST, "{found}, not {expected}");
        // A support of a tenth of a step leaves most lines out, and weights the others so much more (Fig. 10 of the paper).
        let (found, noise) = render(&["beams.estimator=hu2010", "beams.filter_radius=0.1", "beams.step=0.31"])?;
        println!("{}, {noise}", found / expected - 1.0);
        assert!(noise > 5.0 * even, "{noise} and {even}");
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
            Ok::<_, Failure>(frames::render(&case, backend)?)
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

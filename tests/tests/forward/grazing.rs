//! Light around the angle beyond which carriers that go with the planes of the view take none: pictures change as they do before it.

use vitrum::scene::Scene;
use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::cube;
use vitrum_kernels::glam::DVec3;

use crate::on_both;
use crate::shot::{Pixels, Shot, vector};

/// How much more a picture may change from 84° to 86° than from 82° to 84°. The light's path through the picture changes evenly with the
/// angle; cosines of receivers and shadows' outlines change by some percent of that.
const MARGIN: f64 = 1.25;

fn difference(one: &Pixels, other: &Pixels) -> f64 {
    let squares = one.red.iter().zip(&other.red).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
    (squares / one.red.len() as f64).sqrt()
}

#[test]
fn pictures_change_no_more_at_85_degrees_than_before() -> Result<(), Failure> {
    let volume = cube(40, 2.0, |[x, y, z]| 1.0 - (x * x + y * y + z * z).sqrt());
    let settings = [
        // A soft ball, dense within.
        "transfer.opacity=[{value=0.3,opacity=0},{value=0.6,opacity=0.2}]".to_owned(),
        "ground={height=-1}".to_owned(),
        "camera.azimuth=0".to_owned(),
        "camera.elevation=25".to_owned(),
        "camera.zoom=0.7".to_owned(),
        "light.0.attachment=camera".to_owned(),
    ];
    let shot = Shot::new(volume, 64, &settings)?;
    on_both(|backend, held| {
        let mut pictures = Vec::new();
        for degrees in [82.0f64, 84.0, 86.0] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            // In the camera's axes, from above on the left; z is towards the viewer.
            let (down, right) = 50f64.to_radians().sin_cos();
            let light = DVec3::new(right * sin, -down * sin, -cos);
            let shot = shot.with(&[vector("light.0.direction", light)])?;
            if degrees < crate::steepest() {
                pictures.push(shot.render(backend)?);
            } else {
                println!("{}: light at {degrees}° is not taken", backend.name());
            }
        }
        if let [first, second, third] = &pictures[..] {
            let (before, across) = (difference(first, second), difference(second, third));
            println!("{}: 82° to 84° {before:.2e}, 84° to 86° {across:.2e}", backend.name());
            assert!(before > 1e-4, "the light's angle is to be seen: {before}");
            held.at_most(
                backend,
                "change of the picture from 84° to 86°, over that from 82° to 84°",
                across / before,
                MARGIN,
            );
        }
        Ok(())
    })
}

/// The angle is to the viewing direction.
#[test]
fn directions_of_the_camera_are_at_the_angles_that_they_say() -> Result<(), Failure> {
    let scene = Scene::default();
    assert!(scene.light.len() == 1, "the light that the settings turn");
    let shot = Shot::new(cube(16, 2.0, |[x, _, _]| x), 8, &["camera.elevation=25".to_owned()])?;
    let along = shot.ray(4.0, 4.0).1;
    assert!(shot.angle(along) < 1e-5 && (shot.angle(-along) - 180.0).abs() < 1e-5);
    Ok(())
}

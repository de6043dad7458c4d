//! 11: a homogeneous medium attenuates by e^(−σℓ), whatever the sample distance and the direction.

use crate::setup::{backends, cube, render};
use vitrum::io::{Volume, Voxels};
use vitrum::scene::{ColorPoint, OpacityPoint, Projection, Scene};
use vitrum_conformance::closed_forms::table::{self, larger};

/// A cube of edge 2 with one scalar inside. A second scalar, in a corner, makes a range.
fn homogeneous() -> Volume {
    let mut volume = cube(32, 2.0, |_| 1.0);
    if let Voxels::F32(voxels) = &mut volume.voxels {
        voxels.make_mut()[0] = 0.0;
    }
    volume.range = [0.0, 1.0];
    volume
}

fn scene(azimuth: f32, sample_distance: f32) -> Scene {
    let mut scene = Scene::default();
    scene.transfer.reference_length = Some(0.5);
    scene.transfer.opacity = vec![OpacityPoint { value: 0.0, opacity: 0.3 }];
    scene.transfer.filter = vec![ColorPoint { value: 0.0, color: [0.9, 0.5, 0.2] }];
    scene.camera.projection = Projection::Orthographic;
    scene.camera.azimuth = azimuth;
    scene.camera.elevation = 0.0;
    scene.sweep.sample_distance = sample_distance;
    scene.film.width = 9;
    scene.film.height = 9;
    scene
}

#[test]
fn medium_and_particles_follow_beer_and_lambert() {
    let volume = homogeneous();
    for mut backend in backends() {
        let (mut worst_opacity, mut worst_transmittance) = (0.0f64, 0.0f64);
        for azimuth in [0.0f32, 30.0, 45.0] {
            for sample_distance in [0.37, 1.0, 2.5] {
                let frame = render(&scene(azimuth, sample_distance), &volume, backend.as_mut());
                let length = 2.0 / f64::from(azimuth.to_radians()).cos();
                let middle = 4 * 9 + 4;
                let opacity = f64::from(frame.channel("opacity", "Y").expect("opacity")[middle]);
                let expected = 1.0 - 0.7f64.powf(length / 0.5);
                worst_opacity = larger(worst_opacity, (opacity - expected).abs());
                for (channel, transmittance) in [("R", 0.9f64), ("G", 0.5), ("B", 0.2)] {
                    let medium = f64::from(frame.channel("transmittance", channel).expect("transmittance")[middle]);
                    let expected = transmittance.powf(length / 0.5);
                    worst_transmittance = larger(worst_transmittance, (medium - expected).abs() / expected.max(0.1));
                }
            }
        }
        // Half floats in the table: optical depth to 2⁻¹¹, here times up to 2.
        table::BEER_OPACITY.hold(worst_opacity, backend.as_ref());
        table::BEER_TRANSMITTANCE.hold(worst_transmittance, backend.as_ref());
    }
}

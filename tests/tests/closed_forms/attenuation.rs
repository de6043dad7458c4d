//! 11: a homogeneous medium attenuates by e^(−σℓ), whatever the sample distance and the direction.

use crate::setup::{backends, cube, render};
use vitrum::io::{Volume, Voxels};
use vitrum::method::View;
use vitrum::scene::{ColorPoint, OpacityPoint, Projection, Scene};
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_kernels::glam::DVec3;

/// A cube of edge 2 with one scalar inside. A second scalar, in a corner, makes a range.
pub fn homogeneous() -> Volume {
    let mut volume = cube(32, 2.0, |_| 1.0);
    if let Voxels::F32(voxels) = &mut volume.voxels {
        voxels.make_mut()[0] = 0.0;
    }
    volume.range = [0.0, 1.0];
    volume
}

/// A scene of a homogeneous medium, seen by parallel rays.
pub fn scene(azimuth: f32, sample_distance: f32) -> Scene {
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

/// The way of a ray to the faces of the cube of edge 2 around it.
fn way_out(eye: DVec3, direction: DVec3) -> f64 {
    (0..3).map(|axis| (direction[axis].signum() - eye[axis]) / direction[axis]).fold(f64::INFINITY, f64::min)
}

#[test]
fn attenuation_begins_at_an_eye_inside_the_medium() {
    let volume = homogeneous();
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for (position, sample_distance) in [([0.3, 0.2, -0.1], 1.0), ([0.37, -0.5, 0.6], 2.5), ([0.95, 0.0, 0.1], 0.37)]
        {
            let mut scene = scene(0.0, sample_distance);
            scene.camera.projection = Projection::Perspective;
            scene.camera.field_of_view = 60.0;
            scene.camera.position = Some(position);
            scene.camera.target = Some([-0.2, -0.1, 0.15]);
            let frame = render(&scene, &volume, backend.as_mut());
            let view = View::new(&scene, &volume);
            let opacity = frame.channel("opacity", "Y").expect("opacity");
            for (index, &opacity) in opacity.iter().enumerate() {
                let share = |at: usize| (at as f64 + 0.5) / 9.0 * 2.0 - 1.0;
                let [across, up] = [share(index % 9) * view.half_size[0], -share(index / 9) * view.half_size[1]];
                let length = way_out(view.eye, (view.axes * DVec3::new(across, up, 1.0)).normalize());
                let expected = 1.0 - 0.7f64.powf(length / 0.5);
                worst = larger(worst, (f64::from(opacity) - expected).abs());
            }
        }
        // Half floats as above, and rays start a little in front of the eye: 1e-5 of the volume's depth.
        table::BEER_AROUND_THE_EYE.hold(worst, backend.as_ref());
    }
}

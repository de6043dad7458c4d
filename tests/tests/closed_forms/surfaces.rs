//! A layer in which η changes reflects as Fresnel says of a jump, whatever its thickness, its profile and the distance of planes.

use crate::setup::{backends, cube, refracting, render};
use vitrum::scene::{EnvironmentKind, Scene};
use vitrum_conformance::closed_forms::table::{self, larger};

/// In light of radiance 1 from all sides.
fn lit_from_all_sides(mut scene: Scene) -> Scene {
    scene.environment.kind = EnvironmentKind::Color;
    scene.environment.color = [1.0; 3];
    scene.light[0].intensity = 0.0;
    scene.shading.specular = 1.0;
    scene
}

/// The red radiance of the middle of a picture of 9² pixels.
fn middle(scene: &Scene, volume: &vitrum::io::Volume, backend: &mut dyn vitrum::backend::Backend) -> f64 {
    f64::from(render(scene, volume, backend).channel("color", "R").expect("color")[4 * 9 + 4])
}

#[test]
fn a_layer_mirrors_the_environment_by_fresnel() {
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for voxels in [1.0f64, 2.0, 4.0, 8.0] {
            for smooth in [false, true] {
                // Rays travel along −y; the layer's place is no voxel's.
                let volume = cube(48, 2.0, |[_, y, _]| {
                    let t = ((0.03 - y) * 24.0 / voxels + 0.5).clamp(0.0, 1.0);
                    1.0 + 0.5 * if smooth { t * t * (3.0 - 2.0 * t) } else { t }
                });
                let mut scene = lit_from_all_sides(refracting(&volume, 9));
                scene.environment.visible = false;
                // The Fresnel reflectance from 1 to 1.5, unpolarised.
                for (degrees, expected) in [(0.0f32, 0.04f64), (60.0, 0.089_187)] {
                    scene.camera.azimuth = degrees;
                    for sample_distance in [1.0, 0.5, 0.25] {
                        scene.sweep.sample_distance = sample_distance;
                        let found = middle(&scene, &volume, backend.as_mut());
                        worst = larger(worst, (found / expected - 1.0).abs());
                    }
                }
            }
        }
        table::SURFACE_MIRROR.hold(worst, backend.as_ref());
    }
}

#[test]
fn a_highlight_is_as_bright_at_any_sample_distance() {
    // A smooth ball of glass, lit from beside the camera. The brightest pixel was 0.218, 0.066, 0.024 of it when the change over one step was the
    // surface's.
    let volume = cube(48, 2.0, |at| {
        let radius = at.iter().map(|x| x * x).sum::<f64>().sqrt();
        let t = ((0.7 - radius) * 24.0 / 4.0 + 0.5).clamp(0.0, 1.0);
        1.0 + 0.5 * t * t * (3.0 - 2.0 * t)
    });
    let mut scene = refracting(&volume, 48);
    scene.environment.visible = false;
    scene.light[0].azimuth = 40.0;
    scene.shading.specular = 1.0;
    for mut backend in backends() {
        let peaks = [1.0f32, 0.5, 0.25].map(|sample_distance| {
            scene.sweep.sample_distance = sample_distance;
            let frame = render(&scene, &volume, backend.as_mut());
            let found = frame.channel("color", "R").expect("color").iter().copied().fold(0.0, f32::max);
            println!("{}: {found:.4} at {sample_distance}", backend.name());
            f64::from(found)
        });
        let worst = peaks.iter().fold(0.0, |worst, peak| larger(worst, (peak / peaks[2] - 1.0).abs()));
        table::SURFACE_HIGHLIGHT.hold(worst, backend.as_ref());
    }
}

#[test]
fn a_clear_ball_vanishes_in_light_from_all_sides() {
    let volume = cube(48, 2.0, |at| {
        let radius = at.iter().map(|x| x * x).sum::<f64>().sqrt();
        let t = ((0.7 - radius) * 24.0 / 4.0 + 0.5).clamp(0.0, 1.0);
        1.0 + 0.3 * t * t * (3.0 - 2.0 * t)
    });
    let scene = lit_from_all_sides(refracting(&volume, 48));
    for mut backend in backends() {
        let frame = render(&scene, &volume, backend.as_mut());
        let status = frame.channel("status", "Y").expect("status");
        let color = frame.channel("color", "R").expect("color");
        // Rays that turn are followed, and the sweep's own ones go on: both see the environment, and what the surface mirrors of it.
        let worst = color.iter().zip(status).fold(0.0, |worst, (radiance, status)| {
            assert!(*status == 0.0 || *status == 3.0, "status {status}");
            larger(worst, (f64::from(*radiance) - 1.0).abs())
        });
        table::SURFACE_FURNACE.hold(worst, backend.as_ref());
    }
}

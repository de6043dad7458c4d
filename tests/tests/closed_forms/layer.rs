//! 6: a layer from η₁ to η₂. The exit angle follows Snell's law, whatever the profile; beyond the critical angle rays turn.

use crate::setup::{backends, cube, end, refracting, render};
use vitrum_conformance::closed_forms::table::{self, larger};

/// The angle between a ray and the layer's normal behind the box of a layer from 1 to `ratio`, met at `degrees`.
fn behind_layer(degrees: f64, ratio: f64, backend: &mut dyn vitrum::backend::Backend) -> (f64, f32) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    // Rays travel along −y; the normal points along them, tilted in x.
    let volume = cube(96, 2.0, |[x, y, _]| {
        let along = x * sin - y * cos;
        let t = (along / 0.3 + 0.5).clamp(0.0, 1.0);
        1.0 + (ratio - 1.0) * t * t * (3.0 - 2.0 * t)
    });
    let scene = refracting(&volume, 9);
    let frame = render(&scene, &volume, backend);
    let middle = end(&frame, 4, 4);
    // View space: x right is world −x, z towards the viewer is world +y.
    let cosine = -middle.direction[0] * sin - middle.direction[2] * cos;
    (cosine.clamp(-1.0, 1.0).acos().to_degrees(), middle.status)
}

/// That angle by Snell's law: at the layer, and at the far face of the box, which is across the view and lies in the layer's second index.
fn expected_behind_layer(degrees: f64, ratio: f64) -> f64 {
    let behind = (degrees.to_radians().sin() / ratio).asin();
    let to_the_view = (ratio * (degrees.to_radians() - behind).sin()).asin();
    degrees - to_the_view.to_degrees()
}

#[test]
fn the_exit_angle_follows_snell() {
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for (degrees, ratio) in [(10.0f64, 1.5f64), (30.0, 1.5), (60.0, 1.5), (20.0, 1.0 / 1.5), (35.0, 1.0 / 1.5)] {
            let expected = expected_behind_layer(degrees, ratio);
            let (angle, status) = behind_layer(degrees, ratio, backend.as_mut());
            println!("{}: {degrees}° into {ratio:.3}: {angle:.3}°, Snell {expected:.3}°", backend.name());
            assert_eq!(status, 0.0, "the ray goes through");
            worst = larger(worst, (angle - expected).abs());
        }
        table::LAYER_EXIT.hold(worst, backend.as_ref());
    }
}

#[test]
fn beyond_the_critical_angle_rays_are_reflected() {
    // Critical angle 41.81°. A mirrored ray deviates by 180° − 2 · 50° = 80°: the sweep follows it.
    for mut backend in backends() {
        let (angle, status) = behind_layer(50.0, 1.0 / 1.5, backend.as_mut());
        assert_eq!(status, 0.0);
        table::LAYER_REFLECTION.hold((angle - 130.0).abs(), backend.as_ref());
    }
}

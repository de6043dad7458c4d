//! Ambient light of an environment (`environment.ambient`): opaque matter of reflectance 1 vanishes in one colour; receivers in a gradient.

use crate::setup::{backends, cube, render, straight_on};
use vitrum::scene::{EnvironmentKind, Ground, OpacityPoint, Scene, Wall};
use vitrum_conformance::closed_forms::table::{self, larger};

/// A scene in the light of its environment alone.
fn lit_by_the_environment() -> Scene {
    let mut scene = straight_on(48);
    scene.light.clear();
    scene.shading.ambient = [0.0; 3];
    scene.shading.specular = 0.0;
    scene.environment.ambient = 1.0;
    scene
}

#[test]
fn a_white_ball_on_white_ground_vanishes_in_light_from_all_sides() {
    let mut volume = cube(32, 2.0, |at| (0.8 - at.iter().map(|x| x * x).sum::<f64>().sqrt()) * 4.0 + 0.5);
    volume.range = [0.0, 1.0];
    let mut scene = lit_by_the_environment();
    scene.camera.elevation = 20.0;
    scene.transfer.opacity = [(0.4, 0.0), (0.6, 1.0)].map(|(value, opacity)| OpacityPoint { value, opacity }).to_vec();
    scene.environment.kind = EnvironmentKind::Color;
    scene.environment.color = [1.0; 3];
    scene.ground = Some(Ground { height: Some(-1.0), color: [1.0; 3], ..Ground::default() });
    scene.wall = Some(Wall { distance: Some(1.5), azimuth: 0.0, color: [1.0; 3] });
    for mut backend in backends() {
        let frame = render(&scene, &volume, backend.as_mut());
        let color = frame.channel("color", "R").expect("color");
        let worst = color.iter().fold(0.0, |worst, &radiance| larger(worst, (f64::from(radiance) - 1.0).abs()));
        table::AMBIENT_FURNACE.hold(worst, backend.as_ref());
    }
}

/// Of radiance h + (c − h) √|ω_z| above the horizon and below it, level ground has the irradiance over π h + 4/5 (c − h) for the zenith's c.
#[test]
fn level_ground_reflects_a_gradient() {
    let mut volume = cube(16, 0.1, |_| 0.0);
    volume.range = [0.0, 1.0];
    let mut scene = lit_by_the_environment();
    scene.camera.elevation = 60.0;
    scene.transfer.opacity = vec![OpacityPoint { value: 0.5, opacity: 0.0 }];
    scene.environment.color = [0.2, 0.5, 1.0];
    scene.environment.horizon = [0.9, 0.8, 0.6];
    scene.environment.nadir = [0.1; 3];
    scene.ground = Some(Ground { height: Some(-0.1), color: [0.5; 3], ..Ground::default() });
    for mut backend in backends() {
        let pixels = render(&scene, &volume, backend.as_mut()).aov("color").expect("every frame has a colour").color();
        let mut worst = 0.0;
        let ends = || scene.environment.color.into_iter().zip(scene.environment.horizon);
        for pixel in pixels {
            for (found, (zenith, horizon)) in pixel.into_iter().zip(ends()) {
                let expected = 0.5 * (horizon + 0.8 * (zenith - horizon));
                worst = larger(worst, f64::from((found / expected - 1.0).abs()));
            }
        }
        table::AMBIENT_GRADIENT.hold(worst, backend.as_ref());
    }
}

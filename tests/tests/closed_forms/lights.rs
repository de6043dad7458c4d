//! 16: light adds up. A frame with several lights is lit by each as if the others were not there.

use crate::setup::{backends, cube, render, render_with_light, straight_on};
use vitrum::Frame;
use vitrum::io::Volume;
use vitrum::scene::{Light, OpacityPoint, Scene, Transport, Wall};
use vitrum_conformance::closed_forms::table::{self, larger};

const REFLECTANCE: [f32; 3] = [0.8, 0.5, 0.25];
const WALL: f32 = 1.5;

fn light(azimuth: f32, color: [f32; 3]) -> Light {
    Light { azimuth, elevation: 0.0, angular_radius: 0.0, color, ..Light::default() }
}

/// A wall that faces the camera behind a volume that does nothing, or behind an opaque ball of this radius.
fn before_a_wall(radius: f64, lights: &[Light]) -> (Scene, Volume) {
    let mut volume = cube(48, 2.0, |[x, y, z]| if x.hypot(y).hypot(z) < radius { 1.0 } else { 0.0 });
    volume.range = [0.0, 1.0];
    let mut scene = straight_on(64);
    scene.light = lights.to_vec();
    scene.camera.zoom = 0.7;
    scene.transfer.opacity = [(0.4, 0.0), (0.6, 1.0)].map(|(value, opacity)| OpacityPoint { value, opacity }).to_vec();
    scene.shading.specular = 0.0;
    scene.wall = Some(Wall { distance: Some(WALL), azimuth: 0.0, color: REFLECTANCE });
    scene.sweep.light_margin = 0.5;
    (scene, volume)
}

fn color(frame: &Frame) -> Vec<[f32; 3]> {
    frame.aov("color").expect("every frame has a colour").color()
}

/// E = Σ cᵢ cos θᵢ, to a few roundings.
#[test]
fn irradiances_of_two_lights_add_up_on_a_wall() {
    let lights = [light(30.0, [1.0, 0.5, 0.25]), light(-40.0, [0.5, 2.0, 1.0])];
    let expected: [f64; 3] = std::array::from_fn(|channel| {
        let irradiance = |light: &Light| f64::from(light.color[channel]) * f64::from(light.azimuth).to_radians().cos();
        f64::from(REFLECTANCE[channel]) * lights.iter().map(irradiance).sum::<f64>()
    });
    let (scene, volume) = before_a_wall(0.0, &lights);
    for mut backend in backends() {
        let pixels = color(&render(&scene, &volume, backend.as_mut()));
        let errors = pixels.iter().flat_map(|pixel| (0..3).map(|k| (f64::from(pixel[k]) / expected[k] - 1.0).abs()));
        table::LIGHTS_WALL.hold(errors.fold(0.0, larger), backend.as_ref());
    }
}

/// A picture of two lights is that of the first and that of the second without surroundings, pixel by pixel; what is not radiance is
/// the same with any lights.
#[test]
fn further_lights_add_radiance_and_nothing_else() {
    let lights = [light(30.0, [1.0, 0.5, 0.25]), light(-30.0, [0.5, 2.0, 1.0])];
    let frame = |lights: &[Light], shines: f32, backend: &mut dyn vitrum::backend::Backend| {
        let (mut scene, volume) = before_a_wall(0.5, lights);
        scene.shading.ambient = [0.1 * shines; 3];
        scene.environment.intensity = shines;
        render_with_light(&scene, &volume, backend)
    };
    for mut backend in backends() {
        let both = frame(&lights, 1.0, backend.as_mut());
        let first = frame(&lights[..1], 1.0, backend.as_mut());
        let second = frame(&lights[1..], 0.0, backend.as_mut());
        for ((both, first), second) in color(&both).iter().zip(color(&first)).zip(color(&second)) {
            assert_eq!(*both, std::array::from_fn(|channel| first[channel] + second[channel]));
        }
        for (layer, alone) in both.layers.iter().zip(&first.layers).filter(|(layer, _)| layer.name != "color") {
            assert_eq!(layer, alone, "{}", layer.name);
        }
        assert_eq!(both.channel("color", "A"), first.channel("color", "A"));
        assert!(both.light.is_some() && both.light == first.light);
    }
}

/// Halves are exact, so that only the sum is rounded.
#[test]
fn two_lights_of_half_the_intensity_are_one() {
    let whole = Light { angular_radius: 2.0, ..light(25.0, [1.0, 0.75, 0.5]) };
    let half = Light { intensity: 0.5, ..whole.clone() };
    for mut backend in backends() {
        let mut frame = |lights: &[Light]| {
            let (scene, volume) = before_a_wall(0.5, lights);
            color(&render(&scene, &volume, backend.as_mut()))
        };
        let (one, two) = (frame(std::slice::from_ref(&whole)), frame(&[half.clone(), half.clone()]));
        let errors = one.iter().flatten().zip(two.iter().flatten()).map(|(a, b)| f64::from((a - b).abs()));
        table::LIGHTS_HALVES.hold(errors.fold(0.0, larger), backend.as_ref());
    }
}

/// An opaque ball before a wall, lit from 30° on either side: its two shadows lie at ∓d tan 30°, and in each there is the other light alone.
#[test]
fn each_light_casts_a_shadow_of_its_own() {
    // Red from the right, green from the left.
    let lights = [light(30.0, [1.0, 0.0, 0.0]), light(-30.0, [0.0, 1.0, 0.0])];
    let (scene, volume) = before_a_wall(0.4, &lights);
    let cosine = 30f64.to_radians().cos();
    let shift = WALL * 30f32.to_radians().tan();
    let (red, green) = (f64::from(REFLECTANCE[0]) * cosine, f64::from(REFLECTANCE[1]) * cosine);
    for mut backend in backends() {
        let frame = render(&scene, &volume, backend.as_mut());
        let (x, y) = (frame.channel("position", "X").unwrap(), frame.channel("position", "Y").unwrap());
        let pixels = color(&frame);
        // Within half the ball's radius of a place on the wall.
        let around = |at: f32| {
            let near = |index: &usize| (x[*index] - at).hypot(y[*index]) < 0.2;
            (0..pixels.len()).filter(near).map(|index| pixels[index]).collect::<Vec<_>>()
        };
        let mut worst = 0.0f64;
        for (at, expected) in [(-shift, [0.0, green, 0.0]), (shift, [red, 0.0, 0.0]), (2.0 * shift, [red, green, 0.0])]
        {
            let found = around(at);
            assert!(found.len() > 8 || at > shift, "{} pixels around {at}", found.len());
            for pixel in found {
                worst = (0..3).map(|k| (f64::from(pixel[k]) - expected[k]).abs()).fold(worst, larger);
            }
        }
        table::LIGHTS_SHADOWS.hold(worst, backend.as_ref());
    }
}

/// Without any light there is what comes from all sides, and nothing without that.
#[test]
fn without_lights_there_is_ambient_light_alone() {
    let (mut scene, volume) = before_a_wall(0.0, &[]);
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for ambient in [0.0, 0.25] {
            scene.shading.ambient = [ambient; 3];
            for pixel in color(&render(&scene, &volume, backend.as_mut())) {
                worst = (0..3).map(|k| f64::from((pixel[k] - REFLECTANCE[k] * ambient).abs())).fold(worst, larger);
            }
        }
        table::LIGHTS_AMBIENT.hold(worst, backend.as_ref());
    }
}

/// Light on texels goes with the planes of the view. The light that is to blame is named.
#[test]
fn a_light_towards_the_camera_is_refused_by_its_number() {
    let (mut scene, volume) = before_a_wall(0.0, &[light(0.0, [1.0; 3]), light(120.0, [1.0; 3])]);
    scene.sweep.light = Transport::Texels;
    let refusal = vitrum::check(&scene, &volume.into()).unwrap_err().to_string();
    assert!(refusal.contains("120.0°") && refusal.contains("light.1"), "{refusal}");
}

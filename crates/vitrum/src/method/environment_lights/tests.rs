use super::environment_lights;
use crate::method::view::environment::{EnvironmentMap, EnvironmentUniforms};
use crate::method::{Bounds, Part, View, lights};
use crate::scene::{Camera, Environment, EnvironmentKind, Light, Rgb, Scene};
use glam::DVec3;
use std::f64::consts::{PI, TAU};
use vitrum_io::{Mesh, Picture};
use vitrum_kernels::optics::environment::{environment, in_environment};

/// A scene in whose environment, turned to the world's axes, x is a side, y the middle of a map and z up.
fn scene(kind: EnvironmentKind, lights: u32) -> Scene {
    let (color, horizon, nadir) = ([0.9, 0.6, 0.3], [0.5, 0.4, 0.4], [0.2, 0.3, 0.8]);
    let environment =
        Environment { kind, color, horizon, nadir, intensity: 2.0, rotation: 0.0, lights, ..Environment::default() };
    Scene { environment, light: Vec::new(), ..Scene::default() }
}

/// A map whose texels are the gray value of a function of their middle's direction.
fn map(width: u32, height: u32, gray: impl Fn(DVec3) -> f64) -> Picture {
    let texel = |index: u32| {
        let (x, y) = (index % width, index / width);
        [gray(super::cells::direction(f64::from(y) + 0.5, height as usize, f64::from(x) + 0.5, width as usize)) as f32;
            3]
    };
    Picture::rgb(width, height, (0..width * height).map(texel).collect())
}

/// A mesh that a view can be of.
fn triangle() -> Mesh {
    let corners = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 1.0]];
    Mesh::new("triangle", corners, vec![[0, 1, 2]]).expect("a valid mesh")
}

fn flux(lights: &[Light]) -> [f64; 3] {
    std::array::from_fn(|channel| {
        lights.iter().map(|light| PI * f64::from(light.color[channel]) * f64::from(light.intensity)).sum()
    })
}

/// The unit direction from which a light comes.
fn towards(light: &Light) -> DVec3 {
    -glam::Vec3::from_array(light.direction.expect("lights of an environment have a direction")).as_dvec3()
}

fn luminous(light: &Light) -> f32 {
    light.color.iter().sum()
}

/// Only f32 and, of the gradient, samples of the latitude are between both.
#[test]
fn lights_have_the_flux_of_their_environment() {
    let Environment { color, horizon, nadir, intensity, .. } = scene(EnvironmentKind::Color, 1).environment;
    let mean = |colors: &[Rgb], channel: usize| {
        colors.iter().map(|color| f64::from(color[channel])).sum::<f64>() / colors.len() as f64
    };
    let picture = map(48, 23, |d| 1.0 + d.x + 0.5 * d.y * d.z);
    let rows = picture.color();
    let edge = |row: usize| libm::cos(PI * row as f64 / 23.0);
    let of_picture: f64 =
        (0..rows.len()).map(|i| f64::from(rows[i][0]) * (edge(i / 48) - edge(i / 48 + 1)) / 96.0).sum();
    for (kind, picture, means) in [
        (EnvironmentKind::Color, None, std::array::from_fn(|channel| mean(&[color], channel))),
        (EnvironmentKind::Gradient, None, std::array::from_fn(|channel| mean(&[color, horizon, nadir], channel))),
        (EnvironmentKind::Checkerboard, None, std::array::from_fn(|channel| mean(&[color, horizon], channel))),
        (EnvironmentKind::Map, Some(&picture), [of_picture; 3]),
    ] {
        for count in [1, 4, 32] {
            let lights = environment_lights(&scene(kind, count), picture);
            assert_eq!(lights.len(), count as usize, "{kind:?}");
            let expected = means.map(|mean| 2.0 * TAU * mean * f64::from(intensity));
            for (found, expected) in flux(&lights).iter().zip(expected) {
                assert!((found / expected - 1.0).abs() < 1e-4, "{kind:?}, {count}: {found}, not {expected}");
            }
        }
    }
}

/// The integral of the cosine to `normal` times a radiance, over all directions, by the middles of a fine grid.
fn irradiance(normal: DVec3, radiance: impl Fn(DVec3) -> f64) -> f64 {
    const HEIGHTS: u32 = 400;
    let solid_angle = 2.0 * TAU / f64::from(2 * HEIGHTS * HEIGHTS);
    let mut sum = 0.0;
    for row in 0..HEIGHTS {
        let z = (2.0 * f64::from(row) + 1.0) / f64::from(HEIGHTS) - 1.0;
        for column in 0..2 * HEIGHTS {
            let (sin, cos) = libm::sincos(PI * (f64::from(column) + 0.5) / f64::from(HEIGHTS));
            let d = DVec3::new((1.0 - z * z).sqrt() * sin, (1.0 - z * z).sqrt() * cos, z);
            sum += radiance(d) * normal.dot(d).max(0.0) * solid_angle;
        }
    }
    sum
}

/// Root mean squares over 26 orientations are 0.6 % to 1 %, the largest errors 0.9 % to 2.7 %; the grid's own error is below 0.01 %.
#[test]
fn irradiance_of_many_lights_is_that_of_their_environment() {
    let sky = |d: DVec3| 1.0 + 0.5 * d.z + 0.3 * d.x * d.y;
    let picture = map(128, 64, sky);
    let gradient = |d: DVec3| {
        let end = if d.z > 0.0 { 0.9 } else { 0.2 };
        0.5 + (end - 0.5) * d.z.abs().sqrt()
    };
    let cases: [(EnvironmentKind, &dyn Fn(DVec3) -> f64); 3] = [
        (EnvironmentKind::Color, &|_| f64::from(0.9f32)),
        (EnvironmentKind::Gradient, &gradient),
        (EnvironmentKind::Map, &sky),
    ];
    for (kind, radiance) in cases {
        let lights = environment_lights(&scene(kind, 32), Some(&picture));
        let mut squares = 0.0;
        for corner in 0..27u8 {
            let part = |index: u8| f64::from(corner / index % 3) - 1.0;
            let Some(normal) = DVec3::new(part(1), part(3), part(9)).try_normalize() else { continue };
            let lit = |light: &Light| PI * f64::from(light.color[0]) * normal.dot(towards(light)).max(0.0);
            let found: f64 = lights.iter().map(lit).sum();
            let expected = irradiance(normal, |d| radiance(in_axes(d)));
            let error = found / expected - 1.0;
            squares += error * error;
            assert!(error.abs() < 0.03, "{kind:?}, {normal}: {found}, not {expected}");
        }
        let error = (squares / 26.0f64).sqrt();
        assert!(error < 0.012, "{kind:?}: the root mean square error is {error}");
    }
}

/// A direction of the world in the axes of an environment that is not turned.
fn in_axes(d: DVec3) -> DVec3 {
    let axes = crate::method::view::environment::axes(&Environment::default(), DVec3::Z, DVec3::Y);
    DVec3::new(axes[0].dot(d), axes[1].dot(d), axes[2].dot(d))
}

/// The sun is a texel: alone, it is all there is; in a sky, it has a light that the sky moves by less than a texel.
#[test]
fn a_texel_of_sun_is_a_light_in_its_direction() {
    let sun = super::cells::direction(40.5, 256, 300.5, 512);
    for (sky, count) in [(0.0, 1), (1.0, 32)] {
        let picture = map(512, 256, |d| if d.dot(sun) > 1.0 - 1e-9 { 1e6 } else { sky });
        let lights = environment_lights(&scene(EnvironmentKind::Map, 32), Some(&picture));
        assert_eq!(lights.len(), count);
        let brightest = lights.iter().max_by(|a, b| luminous(a).total_cmp(&luminous(b))).expect("there are lights");
        let angle =
            libm::acos(in_axes(towards(brightest)).normalize().dot(sun.normalize()).clamp(-1.0, 1.0)).to_degrees();
        let solid_angle = TAU / 512.0 * (libm::cos(PI * 40.0 / 256.0) - libm::cos(PI * 41.0 / 256.0));
        let of_sun = 1e6 * solid_angle / PI;
        let share = f64::from(brightest.color[0]) / of_sun;
        assert!(angle < 0.35, "{angle}° off");
        assert!((0.9999..1.1).contains(&share), "{share} of the sun's flux");
        // A texel is 0.7° wide, and the sky turns the mean of all directions but little.
        assert!(brightest.angular_radius < if sky > 0.0 { 3.0 } else { 0.5 }, "{}°", brightest.angular_radius);
    }
    let night = map(64, 32, |_| 0.0);
    assert!(environment_lights(&scene(EnvironmentKind::Map, 32), Some(&night)).is_empty());
    assert!(environment_lights(&scene(EnvironmentKind::Map, 32), None).is_empty());
}

/// Where the light comes from, kernels see the sun, however the environment and the camera are turned.
#[test]
fn lights_turn_with_their_environment() {
    let sun = super::cells::direction(38.5, 128, 201.5, 256);
    let picture = map(256, 128, |d| if d.dot(sun) > 1.0 - 1e-9 { 7.0 } else { 0.0 });
    let mut directions = Vec::new();
    for (rotation, up) in [(0.0, [0.0, 0.0, 1.0]), (90.0, [0.0, 0.0, 1.0]), (-130.0, [0.3, 1.0, -0.5])] {
        let mut scene = scene(EnvironmentKind::Map, 1);
        scene.environment.rotation = rotation;
        scene.camera = Camera { up, azimuth: 25.0, elevation: 10.0, ..Camera::default() };
        let lights = environment_lights(&scene, Some(&picture));
        let [light] = &lights[..] else { panic!("there is one") };
        let view = View::new(&scene, &triangle());
        let texels = EnvironmentMap::new(&scene.environment, Some(&picture));
        let block = EnvironmentUniforms::new(&scene, &texels, &view).block;
        let seen = in_environment(&block, view.direction(towards(light)).as_vec3().to_array().into());
        let radiance = environment(&block, &texels.texels, seen, 0.0);
        // Twice the texel's, less what the look-up between texels mixes in where the middle is met to 1e-3 texels.
        assert!((radiance.x - 14.0).abs() < 0.05, "{radiance} at {rotation}");
        directions.push(towards(light));
    }
    let turned = DVec3::new(directions[0].y, -directions[0].x, directions[0].z);
    let back = DVec3::new(-directions[0].y, directions[0].x, directions[0].z);
    assert!((directions[1] - turned).length().min((directions[1] - back).length()) < 1e-6, "a quarter of a turn");
}

/// A cap of one brightness has its own radius.
#[test]
fn a_light_is_as_wide_as_its_region() {
    let cap = map(1024, 512, |d| if d.z > libm::cos(10f64.to_radians()) { 1.0 } else { 0.0 });
    let [light] = &environment_lights(&scene(EnvironmentKind::Map, 1), Some(&cap))[..] else { panic!("one light") };
    assert!((light.angular_radius - 10.0).abs() < 0.2, "{}°", light.angular_radius);
    let all = environment_lights(&scene(EnvironmentKind::Color, 1), None);
    assert_eq!(all[0].angular_radius, 45.0);
    // Round regions of 4π / 32 have a radius of 20°.
    for light in environment_lights(&scene(EnvironmentKind::Color, 32), None) {
        assert!((18.0..24.0).contains(&light.angular_radius), "{}°", light.angular_radius);
    }
}

/// Soft lights of the environment are drawn as those of the scene are, and each exposure has one light at most.
#[test]
fn lights_of_the_environment_are_behind_those_of_the_scene() {
    let mut scene = scene(EnvironmentKind::Gradient, 5);
    let of_scene = Light { intensity: 3.0, angular_radius: 2.0, ..Light::default() };
    let bounds = Bounds::from(&triangle());
    for (own, samples) in [(0, 1), (1, 1), (2, 1), (2, 3)] {
        scene.light = vec![of_scene.clone(); own];
        scene.shadow.samples = samples as u32;
        let exposures = lights::crisp_exposures(&scene, None, bounds);
        assert_eq!(exposures.len(), (own * samples).max(1) + 5 * samples);
        assert!(exposures.iter().all(|one| one.scene.light.len() < 2 && one.scene.environment.lights == 0));
        let [first, others @ ..] = &exposures[..] else { panic!("there is always a first") };
        assert!(first.part == Part::Whole && first.scene.environment.intensity == 2.0);
        assert!(others.iter().all(|one| one.part == Part::Light && one.scene.environment.intensity == 0.0));
        let behind = &exposures[(own * samples).max(1)..];
        let lights: Vec<Light> = behind.iter().flat_map(|one| one.scene.light.clone()).collect();
        let expected = flux(&environment_lights(&scene, None));
        assert!(flux(&lights).iter().zip(expected).all(|(found, expected)| (found / expected - 1.0).abs() < 1e-6));
    }
    let soft = lights::exposures(&scene, None);
    assert_eq!(soft.len(), 7);
    assert!(soft[2].scene.light[0].angular_radius > 10.0, "a sweep draws soft shadows by itself");
}

//! Colours of voxels, and factors of opacity at the gradient's magnitude: Beer and Lambert's law with the factor in the exponent, along viewing rays and
//! along the light, and colours where the voxels have them.

use crate::attenuation::{homogeneous, scene};
use crate::setup::{backends, cube, light_on_planes, render};
use vitrum::io::Volume;
use vitrum::method::sweep::Sweep;
use vitrum::scene::{GradientFunction, GradientPoint, Scene};
use vitrum::{Assets, OutputRequest};
use vitrum_conformance::closed_forms::table::{self, larger};

/// The factor of extinction that a voxel's byte stands for.
const FACTOR: f64 = 128.0 / 255.0;

/// The word of a colour.
fn word(red: u8, green: u8, blue: u8, factor: u8) -> u32 {
    u32::from_le_bytes([red, green, blue, factor])
}

/// A linear value of a byte in sRGB (IEC 61966-2-1).
fn linear(byte: u8) -> f64 {
    let coded = f64::from(byte) / 255.0;
    if coded <= 0.04045 { coded / 12.92 } else { ((coded + 0.055) / 1.055).powf(2.4) }
}

/// The homogeneous cube, of bytes.
fn bytes() -> Volume {
    let volume = homogeneous();
    let voxels: Vec<u8> = (0..volume.voxel_count()).map(|index| if index == 0 { 0 } else { 255 }).collect();
    let of_bytes = Volume::new("bytes", volume.dimensions, volume.spacing, voxels.into()).expect("a volume");
    of_bytes.with_value_mapping(1.0 / 255.0, 0.0).expect("a mapping")
}

/// The homogeneous cube whose voxels have the same colour and factor.
fn colored(red: u8, green: u8, blue: u8) -> Volume {
    let volume = bytes();
    let words = vec![word(red, green, blue, 128); volume.voxel_count()];
    volume.with_colors(words).expect("a colour for each voxel")
}

/// A cube whose scalar rises by 1/32 from voxel to voxel, and the scene in which such a gradient nearly halves the extinction.
fn rising(azimuth: f32, sample_distance: f32) -> (Volume, Scene) {
    let mut scene = scene(azimuth, sample_distance);
    // The factor of a byte, that no rounding makes another one.
    let points =
        [(0.0, 0.0), (1.0 / 32.0 / FACTOR as f32, 1.0)].map(|(magnitude, factor)| GradientPoint { magnitude, factor });
    scene.transfer.gradient = vec![GradientFunction::of_opacity(points.into())];
    // At 45° to the axes, so that all three count.
    (cube(32, 2.0, |[x, y, z]| 0.5 + (x + y + z) * (1.0 / (2.0 * 3.0f64.sqrt()))), scene)
}

#[test]
fn factors_are_exponents_of_what_is_left() {
    for mut backend in backends() {
        let (mut of_colors, mut of_gradients) = (0.0f64, 0.0f64);
        for (azimuth, sample_distance) in [(0.0f32, 0.37), (30.0, 1.0), (45.0, 2.5)] {
            let length = 2.0 / f64::from(azimuth.to_radians()).cos();
            let expected = 1.0 - 0.7f64.powf(FACTOR * length / 0.5);
            let mut error = |scene: &Scene, volume: &Volume| {
                let frame = render(scene, volume, backend.as_mut());
                let opacity = f64::from(frame.channel("opacity", "Y").expect("opacity")[4 * 9 + 4]);
                (opacity - expected).abs()
            };
            of_colors = larger(of_colors, error(&scene(azimuth, sample_distance), &colored(255, 255, 255)));
            let (volume, scene) = rising(azimuth, sample_distance);
            of_gradients = larger(of_gradients, error(&scene, &volume));
        }
        table::COLORS_OPACITY.hold(of_colors, backend.as_ref());
        table::GRADIENT_OPACITY.hold(of_gradients, backend.as_ref());
    }
}

#[test]
fn light_is_attenuated_by_the_same_factors() {
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for sample_distance in [1.0, 0.5] {
            let mut scene = scene(0.0, sample_distance);
            scene.transfer.filter.clear();
            scene.light[0].azimuth = 0.0;
            scene.light[0].elevation = 0.0;
            let assets = Assets::from(colored(255, 255, 255));
            let sweep = Sweep::prepare(&scene, &assets, OutputRequest::default(), backend.as_mut())
                .expect("the scene is sound");
            let last = sweep.light_planes().count - 1;
            let [width, height] = sweep.light_grid.size;
            let expected = 0.7f64.powf(FACTOR * 2.0 / 0.5);
            light_on_planes(
                &sweep,
                backend.as_mut(),
                |plane| plane == last,
                |_, light| {
                    let found = f64::from(light[(height / 2 * width + width / 2) as usize]);
                    worst = larger(worst, (found / expected - 1.0).abs());
                },
            );
        }
        table::COLORS_LIGHT.hold(worst, backend.as_ref());
    }
}

/// The scene without anything behind the cube.
fn before_nothing() -> Scene {
    let mut scene = scene(0.0, 1.0);
    scene.transfer.filter.clear();
    scene.environment.visible = false;
    scene
}

#[test]
fn colors_are_those_of_the_voxels() {
    let scene = before_nothing();
    let [white, tinted] = [[255, 255, 255], [188, 100, 30]];
    for mut backend in backends() {
        let mut seen = |[red, green, blue]: [u8; 3]| {
            let frame = render(&scene, &colored(red, green, blue), backend.as_mut());
            ["R", "G", "B"].map(|name| f64::from(frame.channel("color", name).expect("colour")[4 * 9 + 4]))
        };
        let (white, found) = (seen(white), seen(tinted));
        let off = [0, 1, 2].map(|channel| (found[channel] / white[channel] - linear(tinted[channel])).abs());
        table::COLORS_COLOR.hold(off.into_iter().fold(0.0, larger), backend.as_ref());
    }
}

#[test]
fn each_voxel_has_its_own_color() {
    // Seen along −y, x goes to the left and z up.
    let volume = bytes();
    let corner = |index: usize| match (index % 32 < 16, index / 1024 < 16) {
        (true, true) => word(255, 0, 0, 255),
        (false, true) => word(0, 255, 0, 255),
        (true, false) => word(0, 0, 255, 255),
        (false, false) => word(0, 0, 0, 0),
    };
    let words = (0..volume.voxel_count()).map(corner).collect();
    let volume = volume.with_colors(words).expect("a colour for each voxel");
    for mut backend in backends() {
        let frame = render(&before_nothing(), &volume, backend.as_mut());
        let pixel = |x: usize, y: usize| {
            ["R", "G", "B"].map(|name| frame.channel("color", name).expect("colour")[y * 9 + x] > 1e-3)
        };
        let quarters = [pixel(6, 6), pixel(2, 6), pixel(6, 2), pixel(2, 2)];
        assert_eq!(quarters, [[true, false, false], [false, true, false], [false, false, true], [false; 3]]);
        let opacity = frame.channel("opacity", "Y").expect("opacity");
        assert_eq!(opacity[2 * 9 + 2], 0.0);
    }
}

#[test]
fn factors_of_one_change_nothing() {
    let mut plain = scene(30.0, 1.0);
    plain.transfer.filter.clear();
    let mut with = plain.clone();
    with.transfer.gradient = vec![GradientFunction::of_opacity(Vec::new())];
    for mut backend in backends() {
        let [plain, with] = [&plain, &with].map(|scene| render(scene, &homogeneous(), backend.as_mut()));
        for (layer, name) in [("color", "R"), ("color", "B"), ("opacity", "Y")] {
            let pairs =
                plain.channel(layer, name).into_iter().flatten().zip(with.channel(layer, name).into_iter().flatten());
            for (a, b) in pairs {
                assert!((a - b).abs() < 1e-6, "{layer}.{name}: {a} became {b}");
            }
        }
    }
}

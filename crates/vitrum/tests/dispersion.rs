//! A scene whose glass bends colours differently is the sum of what each wavelength sees.

use std::path::Path;
use vitrum::backend::CpuBackend;
use vitrum::scene::{Light, Scene};
use vitrum::spectrum::bands;
use vitrum::{Assets, Frame, builtin};

fn scene(abbe: Option<f32>, wavelengths: u32) -> Scene {
    let mut scene = builtin::scene("ball").expect("it exists");
    scene.volume.resolution = Some(24);
    (scene.film.width, scene.film.height) = (24, 24);
    scene.sweep.wavelengths = wavelengths;
    scene.transfer.ior[1].abbe = abbe;
    scene
}

fn render(scene: &Scene) -> Frame {
    let assets = Assets::load(scene, Path::new("")).expect("the volume can be made");
    vitrum::render(scene, &assets, &mut CpuBackend::new(None).expect("it opens"), &mut |_| true).expect("it renders")
}

fn difference(a: &Frame, b: &Frame, layer: &str, channel: &str) -> f32 {
    let [a, b] = [a, b].map(|frame| frame.channel(layer, channel).expect("it is there"));
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

#[test]
fn each_channel_is_that_of_its_wavelength() {
    let scene = scene(Some(20.0), 3);
    let whole = render(&scene);
    for (band, channel) in bands(3).iter().zip(["R", "G", "B"]) {
        let one = render(&scene.at_wavelength(band.wavelength));
        assert_eq!(difference(&whole, &one, "color", channel), 0.0, "{channel}");
        assert_eq!(difference(&whole, &one, "transmittance", channel), 0.0, "{channel}");
        let light = |frame: &Frame| -> Vec<f32> {
            let picture = frame.light.as_ref().expect("it is wanted by default");
            picture.color().iter().map(|rgb| rgb["RGB".find(channel).expect("one of them")]).collect()
        };
        assert_eq!(light(&whole), light(&one), "{channel}");
    }
    let others = render(&scene.at_wavelength(bands(3)[2].wavelength));
    assert!(difference(&whole, &others, "color", "R") > 0.01, "red is not bent as blue is");
}

#[test]
fn many_wavelengths_of_glass_that_hardly_disperses_are_one() {
    // A ray that is followed to and fro in the glass goes somewhere else by the slightest change of its index.
    let sweep_alone = |abbe, wavelengths| {
        let mut scene = scene(abbe, wavelengths);
        scene.sweep.follow_turned_rays = false;
        scene
    };
    let (one, many) = (render(&sweep_alone(None, 3)), render(&sweep_alone(Some(1000.0), 5)));
    for channel in ["R", "G", "B"] {
        let most = difference(&one, &many, "color", channel);
        let brightest = one.channel("color", channel).expect("it is there").iter().copied().fold(0.0, f32::max);
        // An Abbe number of 1000 is 2% of ordinary glass's dispersion.
        assert!(most < 0.02 * brightest, "{channel}: {most} of {brightest}");
    }
}

#[test]
fn two_measures_of_dispersion_are_a_contradiction() {
    let mut scene = scene(Some(60.0), 3);
    scene.transfer.ior[1].cauchy_b = Some(0.004);
    let error = scene.validate().expect_err("both are given").to_string();
    assert!(error.contains("transfer.ior.1.abbe") && error.contains("cauchy_b"), "{error}");
}

#[test]
fn light_of_several_sources_disperses_alike() {
    let both = {
        let mut scene = scene(Some(20.0), 5);
        let other = Light { azimuth: -20.0, color: [0.2, 0.5, 1.0], ..scene.light[0].clone() };
        scene.light.push(other);
        scene
    };
    let mut first = both.clone();
    first.light.truncate(1);
    let mut second = both.clone();
    second.light.remove(0);
    (second.shading.ambient, second.environment.intensity) = ([0.0; 3], 0.0);
    let [both, first, second] = [both, first, second].map(|scene| render(&scene));
    for channel in ["R", "G", "B"] {
        let [both, first, second] =
            [&both, &first, &second].map(|frame| frame.channel("color", channel).expect("it is there"));
        for ((both, first), second) in both.iter().zip(first).zip(second) {
            // Ten exposures are added in another order, some with negative weights.
            assert!(
                (both - (first + second)).abs() < 2e-6 * both.abs().max(1.0),
                "{channel}: {both}, {first} and {second}"
            );
        }
    }
    for (layer, alone) in both.layers.iter().zip(&first.layers).filter(|(layer, _)| layer.name != "color") {
        assert_eq!(layer, alone, "{}", layer.name);
    }
    assert_eq!(both.light, first.light);
}

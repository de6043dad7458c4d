//! A scene whose glass bends colours differently is the sum of what each wavelength sees.

use std::path::Path;
use vitrum::backend::CpuBackend;
use vitrum::scene::{Camera, Light, Material, MethodName, Scene};
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
    let assets = Assets::load(scene, Path::new("")).expect("the volume or mesh can be made");
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
    let one = render(&sweep_alone(None, 3));
    // An Abbe number of 1000 is 2% of ordinary glass's dispersion. Light that grazes the rim of the ball multiplies it: the difference goes with the
    // dispersion.
    for (abbe, share) in [(250.0, 0.2), (1000.0, 0.03)] {
        let many = render(&sweep_alone(Some(abbe), 5));
        for channel in ["R", "G", "B"] {
            let most = difference(&one, &many, "color", channel);
            let brightest = one.channel("color", channel).expect("it is there").iter().copied().fold(0.0, f32::max);
            println!("Abbe number {abbe}, {channel}: {:.4} of the brightest", most / brightest);
            assert!(most < share * brightest, "Abbe number {abbe}, {channel}: {most} of {brightest}");
        }
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

/// A gem in thin fog on the ground, by each method that shows meshes. Two lights shine on it.
fn gems(material: &Material, wavelengths: u32) -> [Scene; 3] {
    let mut scene = builtin::scene("gem").expect("it exists");
    scene.camera = Camera { position: Some([0.0, -6.0, 2.0]), ..Camera::default() };
    scene.environment.color = [0.2, 0.3, 0.4];
    scene.light = vec![Light { azimuth: 30.0, ..Light::default() }, Light { intensity: 0.5, ..Light::default() }];
    scene.material = vec![material.clone()];
    (scene.film.width, scene.film.height) = (24, 24);
    scene.voxelization.resolution = 24;
    scene.beams.rays = 12;
    (scene.voxels.wavelengths, scene.beams.wavelengths, scene.sweep.wavelengths) =
        (wavelengths, wavelengths, wavelengths);
    let without_medium = Scene { medium: None, ..scene.clone() };
    [
        Scene { method: MethodName::Beams, ..scene },
        Scene { method: MethodName::Voxels, ..without_medium.clone() },
        Scene { method: MethodName::Sweep, ..without_medium },
    ]
}

const DIAMOND: Material = Material {
    name: None,
    opaque: false,
    mirror: false,
    color: None,
    density: 16.0,
    ior: 2.417,
    abbe: None,
    cauchy_b: None,
    attenuation_color: [0.9, 0.95, 1.0],
    attenuation_distance: Some(2.0),
};

#[test]
fn each_channel_of_a_mesh_is_that_of_its_wavelength() {
    for scene in gems(&Material { abbe: Some(20.0), ..DIAMOND }, 3) {
        let (method, whole) = (scene.method.as_str(), render(&scene));
        let parts = bands(3).into_iter().map(|band| render(&scene.at_wavelength(band.wavelength)));
        let parts: Vec<Frame> = parts.collect();
        for (one, channel) in parts.iter().zip(["R", "G", "B"]) {
            assert_eq!(difference(&whole, one, "color", channel), 0.0, "{method}, {channel}");
        }
        assert!(difference(&parts[0], &parts[2], "color", "R") > 0.01, "{method}: red is not bent as blue is");
    }
}

/// Cauchy's B of 10⁻⁹ µm² changes no index that f32 can tell: the wavelengths' frames are the same, and their sum is each of them.
#[test]
fn wavelengths_of_a_mesh_that_does_not_disperse_add_up_to_its_picture() {
    // Weights, products and sums are rounded, and the absolute values of seven weights add up to less than 2.
    const SHARE: f32 = 2e-6;
    for wavelengths in [3, 7] {
        let dispersing = gems(&Material { cauchy_b: Some(1e-9), ..DIAMOND }, wavelengths);
        for (none, one) in gems(&DIAMOND, wavelengths).iter().zip(&dispersing) {
            let method = one.method.as_str();
            let [none, one] = [none, one].map(render);
            for (layer, other) in none.layers.iter().zip(&one.layers) {
                for (a, b) in layer.channels.iter().zip(&other.channels) {
                    let most = a.data.iter().copied().map(f32::abs).fold(0.0, f32::max);
                    let off = a.data.iter().zip(&b.data).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                    assert!(off <= SHARE * most, "{method}, {}, {}: {off} of {most}", layer.name, a.name);
                }
            }
        }
    }
}

/// A mesh's frame has exposures of wavelengths only where a material of one of its bodies disperses.
#[test]
fn a_mesh_without_dispersion_has_an_exposure_for_each_light() {
    for (material, count) in [
        (DIAMOND, 2),
        (Material { abbe: Some(55.3), ..DIAMOND }, 10),
        (Material { cauchy_b: Some(0.0), ..DIAMOND }, 2),
        (Material { name: Some("of no body".to_owned()), abbe: Some(55.3), ..DIAMOND }, 2),
    ] {
        for scene in gems(&material, 5) {
            let assets = Assets::load(&scene, Path::new("")).expect("the mesh can be made");
            let exposures = vitrum::method::of(scene.method).exposures(&scene, &assets);
            assert_eq!(exposures.len(), count, "{}, {material:?}", scene.method.as_str());
        }
    }
}

#[test]
fn contradictory_materials_are_refused() {
    let both = Material { abbe: Some(60.0), cauchy_b: Some(0.004), ..DIAMOND };
    let opaque = Material { opaque: true, abbe: Some(60.0), ..DIAMOND };
    let mirror = Material { mirror: true, cauchy_b: Some(0.004), ..DIAMOND };
    for (material, words) in [
        (both, ["material.0.abbe", "both `abbe` and `cauchy_b`"]),
        (opaque, ["material.0.abbe", "the material is opaque"]),
        (mirror, ["material.0.cauchy_b", "the material is a mirror"]),
    ] {
        let [beams, voxels, _] = gems(&material, 3);
        // Rays through voxels have no mirrors anyway.
        for scene in [beams, voxels].into_iter().filter(|scene| scene.method.capabilities().mirrors || !material.mirror)
        {
            let error = scene.validate().expect_err("it is a contradiction").to_string();
            assert!(words.iter().all(|word| error.contains(word)), "{error}");
        }
    }
}

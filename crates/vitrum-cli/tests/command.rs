//! A scene that was changed by hand as a command: what a shell makes of its text is the same scene, in every key.

mod common;

use common::Folder;
use std::process::Command;
use vitrum::composition::{Composed, Composition, shell_command};
use vitrum::preset::Surface;
use vitrum::scene::{
    Annotation, AnnotationKind, ColorPoint, GradientFunction, IorPoint, Isosurface, Light, LightKind, OpacityPoint,
    Scene,
};

/// A body of three values, 8³ voxels.
fn volume() -> Vec<u8> {
    let header =
        "NRRD0004\ntype: int16\ndimension: 3\nsizes: 8 8 8\nencoding: raw\nendian: little\nspacings: 1 1 1\n\n";
    let value = |index: usize| {
        let depth = [index % 8, index / 8 % 8, index / 64].into_iter().map(|at| at.min(7 - at)).min();
        [-1000_i16, 40, 300, 1200][depth.unwrap_or(0)]
    };
    [header.as_bytes(), &(0..512).flat_map(|index| value(index).to_le_bytes()).collect::<Vec<_>>()].concat()
}

/// Changes the scene of a composition, and takes it through the text of a command, a shell and the program.
fn assert_comes_back(folder: &Folder, composition: &Composition, change: impl Fn(&mut Scene)) -> String {
    let Composed { mut scene, assets, .. } = composition.compose().expect("it can be composed");
    change(&mut scene);
    scene.validate().expect("the changed scene is valid");
    let leading = composition.leading_to(&scene, &assets).expect("settings lead to it");
    let mut words = leading.arguments();
    words.push("--all".to_owned());
    let text = shell_command(env!("CARGO_BIN_EXE_vitrum"), "scene", &words);
    let output = Command::new("sh").arg("-c").arg(&text).current_dir(folder.path()).output().expect("a shell");
    let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("it is UTF-8"));
    assert!(output.status.success(), "{text}\n{err}");
    let made = Scene::from_toml(&out, "the program's scene").expect("it is valid");
    assert_eq!(made, scene, "{text}");
    text
}

fn of(input: &str, preset: Option<&str>) -> Composition {
    let preset = preset.map(str::to_owned);
    let settings = if input.starts_with("builtin:b") { vec!["volume.resolution=16".to_owned()] } else { Vec::new() };
    Composition { input: input.to_owned(), preset, settings, ..Composition::default() }
}

#[test]
fn the_camera_of_a_built_in_scene_comes_back() {
    let folder = Folder::new();
    let text = assert_comes_back(&folder, &of("builtin:ball", None), |scene| {
        (scene.camera.azimuth, scene.camera.elevation) = (33.3, -0.1);
        (scene.film.width, scene.film.height) = (300, 200);
    });
    assert!(text.contains("--size=300x200") && text.contains("--set=camera.azimuth=33.3"), "{text}");
}

#[test]
fn an_edited_transfer_function_and_two_lights_come_back() {
    let folder = Folder::new();
    folder.write("it's a body.nrrd", volume());
    let input = folder.file("it's a body.nrrd");
    let input = input.to_str().expect("Unicode");
    for preset in [None, Some("bone"), Some("ct-bone"), Some("glass"), Some("mip")] {
        let text = assert_comes_back(&folder, &of(input, preset), |scene| {
            let opacity = |value: f32, opacity: f32| OpacityPoint { value, opacity };
            scene.transfer.opacity = [(-100.3, 0.0), (40.0, 0.12), (40.0, 0.3), (299.99, 1e-7), (1200.0, 1.0)]
                .map(|(x, y)| opacity(x, y))
                .to_vec();
            scene.transfer.ior =
                vec![IorPoint::new(0.0, 1.0), IorPoint { abbe: Some(31.0), ..IorPoint::new(300.0, 1.45) }];
            scene.transfer.filter = vec![ColorPoint { value: 7.5, color: [0.9, 0.2, 0.1] }];
            scene.light.push(Light {
                position: Some([80.0, 0.0, 90.5]),
                intensity: 4000.0,
                ..Light::of_kind(LightKind::Point)
            });
            scene.light[0].color = [0.3, 0.25, 0.1];
        });
        assert_eq!(text.contains("--preset="), preset.is_some(), "{text}");
    }
}

#[test]
fn isosurfaces_and_words_that_a_shell_takes_apart_come_back() {
    let folder = Folder::new();
    folder.write("body.nrrd", volume());
    let input = folder.file("body.nrrd");
    let mut composition = of(input.to_str().expect("Unicode"), None);
    composition.adjustments.isosurfaces = vec!["300:ivory:0.4".parse::<Surface>().expect("a surface")];
    assert_comes_back(&folder, &composition, |scene| {
        scene.isosurface.push(Isosurface { opacity: 0.35, ..Isosurface::new(1000.5) });
        scene.isosurface[0].color = [0.123, 0.456, 0.789];
        let words = Some("two lines\n\"$HOME\" isn't `here`".to_owned());
        scene.annotation = vec![Annotation { kind: AnnotationKind::Caption, text: words, ..Annotation::default() }];
    });
}

#[test]
fn gradients_come_back() {
    let folder = Folder::new();
    folder.write("body.nrrd", volume());
    let input = folder.file("body.nrrd");
    let mut composition = of(input.to_str().expect("Unicode"), Some("plain"));
    composition.adjustments.gradient = ["20:0", "400.5:1"].map(|point| point.parse().expect("a point")).to_vec();
    let text = assert_comes_back(&folder, &composition, |scene| {
        scene.transfer.gradient[0].values = Some([-100.0, 300.5]);
        scene.transfer.gradient[0].opacity[0].factor = 0.25;
        scene
            .transfer
            .gradient
            .push(GradientFunction { color: [1.0, 0.5, 0.1], ..GradientFunction::of_opacity(Vec::new()) });
    });
    assert!(text.contains("--gradient-opacity=20:0,400.5:1"), "{text}");
}

#[test]
fn scene_files_and_meshes_come_back() {
    let folder = Folder::new();
    folder.write("scene.toml", "background = \"white\"\n[volume]\nbuiltin = \"ball\"\nresolution = 16\n[wall]\n");
    let input = folder.file("scene.toml");
    assert_comes_back(&folder, &of(input.to_str().expect("Unicode"), None), |scene| {
        scene.wall = None;
        scene.background = None;
        scene.clip.push(vitrum::scene::Clip::default());
    });
    let mut composition = of("builtin:vase", None);
    assert_comes_back(&folder, &composition, |scene| scene.voxelization.resolution = 40);
    composition.medium = Some("fog".to_owned());
    assert_comes_back(&folder, &composition, |scene| scene.camera.roll = 5.0);
}

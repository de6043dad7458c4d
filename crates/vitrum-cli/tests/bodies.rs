//! Meshes within a volume.

mod common;

use common::{Folder, nrrd};

/// A torus in the middle of a small picture of a scan.
const RENDER: [&str; 9] = [
    "render",
    "scan.nrrd",
    "-o",
    "out.png",
    "--size",
    "48x48",
    "--set",
    "mesh.0={builtin='torus',scale=3,position=[7.5,7.5,7.5]}",
    "--backend=cpu",
];

fn scan() -> Folder {
    let folder = Folder::new();
    let within = |at: usize| (4..12).contains(&at);
    let value = |index: usize| {
        if within(index % 16) && within(index / 16 % 16) && within(index / 256) { 200 } else { 10 }
    };
    let voxels: Vec<u8> = (0..16 * 16 * 16).map(value).collect();
    folder.write("scan.nrrd", nrrd("16 16 16", "spacings: 1 1 1", &voxels));
    folder
}

fn with<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&RENDER, more].concat()
}

#[test]
fn a_mesh_that_is_added_to_a_scan_keeps_the_scan_and_its_preset() {
    let folder = scan();
    let outcome = folder.vitrum(&with(&[]));
    assert_eq!(outcome.code, Some(0), "{}", outcome.stderr);
    assert!(outcome.stderr.contains("the preset `"), "{}", outcome.stderr);
    // Another mesh is another picture, and so is none.
    let picture = |name: &str| std::fs::read(folder.file(name)).expect("the picture");
    folder.succeed(&["render", "scan.nrrd", "-o", "alone.png", "--size", "48x48", "--backend=cpu"]);
    folder.succeed(&with(&["--set", "mesh.0.scale=2", "-o", "smaller.png"]));
    assert!(picture("out.png") != picture("alone.png") && picture("out.png") != picture("smaller.png"));
}

#[test]
fn a_scene_with_bodies_renders_as_the_command_that_wrote_it() {
    let folder = scan();
    let scene = with(&["--preset", "bone"]);
    folder.succeed(&scene);
    let written: Vec<&str> = std::iter::once("scene").chain(scene[1..].iter().copied()).collect();
    let written: Vec<&str> = written.iter().map(|&word| if word == "out.png" { "scene.toml" } else { word }).collect();
    let written: Vec<&str> = written.into_iter().filter(|word| !word.starts_with("--backend")).collect();
    folder.succeed(&written);
    folder.succeed(&["render", "scene.toml", "-o", "again.png", "--backend=cpu", "--quality", "good"]);
    let picture = |name: &str| std::fs::read(folder.file(name)).expect("the picture");
    assert_eq!(pixels(&picture("out.png")), pixels(&picture("again.png")));
    assert!(folder.succeed(&["info", "scene.toml"]).contains("16"));
}

/// The pixels of a PNG, without what it says about its making.
fn pixels(file: &[u8]) -> Vec<[u8; 4]> {
    vitrum::io::read_picture_bytes("picture.png", file, &vitrum::io::OpenOptions::default())
        .expect("a picture")
        .to_srgb8()
}

#[test]
fn what_bodies_cannot_be_beside_is_refused_with_a_way_out() {
    let folder = scan();
    for (more, words) in [
        (&["--set", "shading.blend_mode=maximum"][..], &["`shading.blend_mode`", "leave `mesh` out"][..]),
        (&["--set", "material.0.mirror=true"], &["renders no mirrors"]),
        (&["--set", "material.0.abbe=30"], &["`material.0.abbe`", "bend all colours alike"]),
        (&["--set", "material.0.attenuation_color=[1,0.5,0.5]"], &["`material.0.attenuation_color`"]),
        (&["--preset", "glass", "--set", "material.0.ior=1.5"], &["a scan that bends light itself", "--preset bone"]),
        (&["--gradient-opacity", "0:0,50:1"], &["within a volume", "factors by the gradient"]),
        (&["--set", "method=voxels"], &["`volume`", "a volume and a mesh are given", "`sweep`"]),
        (&["--set", "ior_volume.builtin=ball"], &["`ior_volume`", "meshes within a volume take its place"]),
    ] {
        folder.refuse(&with(more), 3, words);
    }
}

#[test]
fn clear_bodies_in_a_scan_that_does_not_bend_light_are_shown() {
    let folder = scan();
    folder.succeed(&with(&["--preset", "bone", "--set", "material.0.ior=1.5", "-o", "clear.png"]));
    folder.succeed(&with(&["--preset", "bone"]));
    let picture = |name: &str| std::fs::read(folder.file(name)).expect("the picture");
    assert!(pixels(&picture("clear.png")) != pixels(&picture("out.png")));
}

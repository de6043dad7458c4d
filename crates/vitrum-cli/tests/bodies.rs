//! Meshes within a volume.

mod common;

use common::{Folder, nrrd};

/// A torus in the middle of a scan.
const TORUS: &str = "mesh.0={builtin='torus',scale=3,position=[7.5,7.5,7.5]}";

fn scan() -> Folder {
    let folder = Folder::new();
    let within = |at: usize| (4..12).contains(&at);
    let value = |index: usize| {
        if within(index % 16) && within(index / 16 % 16) && within(index / 256) { 200 } else { 10 }
    };
    let voxels: Vec<u8> = (0..16 * 16 * 16).map(value).collect();
    folder.write("scan.nrrd", nrrd("16 16 16", "spacings: 1 1 1\n", &voxels));
    folder
}

/// The command of a small picture of the scan with the torus in it, in the file `name`.
fn with<'a>(name: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["render", "scan.nrrd", "-o", name, "--size", "48x48", "--backend=cpu", "--set", TORUS], more].concat()
}

#[test]
fn a_mesh_that_is_added_to_a_scan_keeps_the_scan_and_its_preset() {
    let folder = scan();
    let outcome = folder.vitrum(&with("out.png", &[]));
    assert_eq!(outcome.code, Some(0), "{}", outcome.stderr);
    assert!(outcome.stderr.contains("the preset `"), "{}", outcome.stderr);
    // Another mesh is another picture, and so is none.
    let picture = |name: &str| std::fs::read(folder.file(name)).expect("the picture");
    folder.succeed(&["render", "scan.nrrd", "-o", "alone.png", "--size", "48x48", "--backend=cpu"]);
    folder.succeed(&with("smaller.png", &["--set", "mesh.0.scale=2"]));
    assert!(picture("out.png") != picture("alone.png") && picture("out.png") != picture("smaller.png"));
}

#[test]
fn a_scene_with_bodies_renders_as_the_command_that_wrote_it() {
    let folder = scan();
    folder.succeed(&with("out.png", &["--preset", "bone"]));
    let scene = ["scene", "scan.nrrd", "-o", "scene.toml", "--size", "48x48", "--set", TORUS, "--preset", "bone"];
    folder.succeed(&scene);
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
    for (more, code, words) in [
        (&["--set", "shading.blend_mode=maximum"][..], 2, &["`shading.blend_mode`", "leave `mesh` out"][..]),
        (&["--set", "material.0.mirror=true"], 2, &["renders no mirrors"]),
        (&["--set", "material.0.abbe=30"], 2, &["`material.0.abbe`", "bend all colours alike"]),
        (&["--set", "material.0.attenuation_color=[1,0.5,0.5]"], 2, &["`material.0.attenuation_color`"]),
        (&["--set", "method=voxels"], 2, &["`volume`", "a volume and a mesh are given", "`sweep`"]),
        (&["--set", "ior_volume.builtin=ball"], 2, &["`ior_volume`", "meshes within a volume take its place"]),
        (&["--preset=glass", "--set", "material.0.ior=1.5"], 3, &["a scan that bends light itself", "--preset bone"]),
        (&["--preset=haze", "--gradient-opacity", "0:0,50:1"], 3, &["within the volume", "factors by the gradient"]),
    ] {
        folder.refuse(&with("out.png", more), code, words);
    }
}

#[test]
fn clear_bodies_in_a_scan_that_does_not_bend_light_are_shown() {
    let folder = scan();
    folder.succeed(&with("clear.png", &["--preset", "bone", "--set", "material.0.ior=1.5"]));
    folder.succeed(&with("out.png", &["--preset", "bone"]));
    let picture = |name: &str| std::fs::read(folder.file(name)).expect("the picture");
    assert!(pixels(&picture("clear.png")) != pixels(&picture("out.png")));
}

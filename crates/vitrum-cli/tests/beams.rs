//! Beams of light in a medium, from scenes with mistakes and with values at the ends of their ranges.

mod common;

use common::Folder;
use vitrum_io::read_picture;

/// A small picture of a glass ball in fog, in the light of a bulb above it.
const BALL: [&str; 9] =
    ["render", "builtin:ball-in-fog", "-o", "out.exr", "--backend", "cpu", "--size", "24x24", "--quiet"];

fn ball<'a>(settings: &[&'a str]) -> Vec<&'a str> {
    let few = ["beams.rays=8"];
    let settings = few.iter().chain(settings).flat_map(|setting| ["--set", setting]);
    BALL.into_iter().chain(settings).collect()
}

/// A scene file of a glass ball; `lines` begin at line 3.
fn scene(lines: &str) -> String {
    format!("method = \"beams\"\nmesh = [{{ builtin = \"ball\" }}]\n{lines}\n")
}

#[test]
fn mistakes_in_scene_files_exit_3_and_name_the_line() {
    let folder = Folder::new();
    for (lines, words) in [
        ("[medium]\nscattering = [-0.1, 0, 0]", &["line 4", "`medium.scattering.0`", "found -0.1", "0 to 1000000"][..]),
        ("[medium]\nabsorption = [0, 0, -1]", &["line 4", "`medium.absorption.2`", "found -1", "0 to 1000000"]),
        ("[medium]\nscattering = [0, nan, 0]", &["line 4", "`medium.scattering.1`", "found nan"]),
        ("[medium]\nabsorption = [inf, 0, 0]", &["line 4", "`medium.absorption.0`", "found inf"]),
        ("[medium]\nscattering = 0.1", &["line 4", "`medium.scattering`", "found 0.1", "list"]),
        ("[medium]\nanisotropy = 1", &["line 4", "`medium.anisotropy`", "found 1", "-0.99 to 0.99"]),
        ("[medium]\nanisotropy = -1", &["line 4", "`medium.anisotropy`", "found -1", "-0.99 to 0.99"]),
        ("[medium]\nanisotropy = nan", &["line 4", "`medium.anisotropy`", "found nan"]),
        ("[medium]\nphase = \"rayleigh\"\nanisotropy = 0.5", &["`medium.anisotropy`", "`rayleigh`", "leave"]),
        ("[medium]\nphase = \"mie\"", &["line 4", "`medium.phase`", "rayleigh"]),
        ("[medium]\nextent = 0", &["line 4", "`medium.extent`", "found 0", "above 0"]),
        ("[medium]\nextent = nan", &["line 4", "`medium.extent`", "found nan"]),
        ("[medium]\ndensity = { builtin = \"ball\" }\nextent = 2", &["`medium.extent`", "leave `medium.extent` out"]),
        ("[medium]\ndensity_window = [0, 1]", &["`medium.density_window`", "`medium.density` is not given"]),
        (
            "[medium]\ndensity = { builtin = \"ball\" }\ndensity_window = [1, 1]",
            &["`medium.density_window`", "lower one first"],
        ),
        ("[medium]\nphase = \"tabulated\"", &["`medium.phase_values`", "two values"]),
        ("[medium]\nphase = \"tabulated\"\nphase_values = [1, -1]", &["`medium.phase_values.1`", "found -1"]),
        ("[medium]\nphase_values = [1, 1]", &["`medium.phase_values`", "tabulated"]),
        ("[medium]\nscatering = [1, 1, 1]", &["line 4", "unknown key", "did you mean `medium.scattering`?"]),
        // Squared this would be 10⁹ rays of light.
        ("[beams]\nrays = 31623", &["line 4", "`beams.rays`", "found 31623", "4 to 1024"]),
        ("[beams]\nrays = 3", &["line 4", "`beams.rays`", "found 3", "4 to 1024"]),
        ("[beams]\nrays = 64.5", &["line 4", "`beams.rays`", "found 64.5", "whole number"]),
        ("[beams]\nrays = -64", &["line 4", "`beams.rays`", "found -64"]),
        ("[beams]\nsegments = 0", &["line 4", "`beams.segments`", "found 0", "1 to 64"]),
        ("[beams]\nsegments = 65", &["line 4", "`beams.segments`", "found 65", "1 to 64"]),
        ("[beams]\nbounces = 0", &["line 4", "`beams.bounces`", "found 0", "1 to 16"]),
        ("[beams]\nbounces = 17", &["line 4", "`beams.bounces`", "found 17", "1 to 16"]),
        ("[beams]\nviews = 0", &["line 4", "`beams.views`", "found 0", "1 to 32"]),
        ("[beams]\nviews = 33", &["line 4", "`beams.views`", "found 33", "1 to 32"]),
        ("[beams]\nthreshold = -0.1", &["line 4", "`beams.threshold`", "found -0.1", "0 to 1"]),
        ("[beams]\nthreshold = nan", &["line 4", "`beams.threshold`", "found nan"]),
        ("[beams]\npyramid = 1", &["line 4", "`beams.pyramid`", "found 1"]),
        ("[beams]\nnodes = 1", &["line 4", "`beams.nodes`", "found 1", "2 to 64"]),
        ("[[material]]\nmirror = true\nopaque = true", &["`material.0.mirror`", "leave one of them out"]),
        ("[[material]]\nior = 0.5", &["line 4", "`material.0.ior`", "found 0.5", "1 to 4"]),
        ("[[clip]]\nnormal = [0, 0, 1]", &["`clip`", "leave `clip` out"]),
    ] {
        folder.write("scene.toml", scene(lines));
        folder.refuse(&["render", "scene.toml", "-o", "out.png"], 3, &[&["scene.toml"], words].concat());
    }
    // Each is within its range, and both together are more than kernels can address.
    folder.write("scene.toml", scene("[beams]\nrays = 1024\nsegments = 64"));
    let words = ["beams.rays = 1024", "beams.segments = 64", "lower `beams.segments` or `beams.rays`"];
    folder.refuse(&["render", "scene.toml", "-o", "out.png"], 3, &words);
    // So are those of a lattice twice as fine.
    folder.write("scene.toml", scene("[beams]\nrays = 1024\nsegments = 30\nadaptive = true"));
    let words = ["beams.rays = 1024", "beams.segments = 30", "set `beams.adaptive = false`"];
    folder.refuse(&["render", "scene.toml", "-o", "out.png"], 3, &words);
}

#[test]
fn settings_with_mistakes_exit_2() {
    let folder = Folder::new();
    for (setting, words) in [
        ("medium.scattering=[-1,0,0]", &["`medium.scattering.0`", "found -1"][..]),
        ("medium.anisotropy=1", &["`medium.anisotropy`", "found 1", "-0.99 to 0.99"]),
        ("medium.anisotropy=nan", &["`medium.anisotropy`", "found nan"]),
        ("medium.density_window=[0,1]", &["`medium.density_window`", "`medium.density` is not given"]),
        ("beams.rays=31623", &["`beams.rays`", "found 31623", "4 to 1024"]),
        ("beams.ray=64", &["did you mean `beams.rays`?"]),
        ("method=voxels", &["`medium`", "the method `voxels` renders no participating medium", "method = \"beams\""]),
        ("beams.orders=0", &["`beams.orders`", "found 0", "1 to 64"]),
        ("beams.filter_radius=3", &["`beams.filter_radius`", "found 3"]),
        ("beams.step=0", &["`beams.step`", "found 0"]),
        ("beams.estimator=hu", &["`beams.estimator`", "hu2010"]),
        ("beams.tracer=maps", &["`beams.tracer`", "depth-map"]),
        (
            "beams={tracer='depth-map',adaptive=true}",
            &["`beams.adaptive`", "one texel for each ray", "tracer = \"tree\""],
        ),
    ] {
        folder.refuse(&ball(&[setting]), 2, words);
    }
    let outputs = ["render", "builtin:ball-in-fog", "-o", "out.png", "--aov", "bounces=b.exr"];
    folder.refuse(&outputs, 2, &["`beams`", "`bounces`", "caustics"]);
}

#[test]
fn subjects_that_are_no_mesh_with_a_surface_are_refused() {
    let folder = Folder::new();
    folder.refuse(&["render", "builtin:phantom", "-o", "out.png", "--set", "method=beams"], 2, &["method", "`beams`"]);
    folder.write("line.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n");
    let line = ["render", "line.obj", "-o", "out.png", "--medium", "fog"];
    folder.refuse(&line, 3, &["line.obj", "none of its 1 triangles has an area"]);
    folder.write("nan.obj", "v 0 0 nan\nv 1 1 1\nv 2 2 2\nf 1 2 3\n");
    folder.refuse(&["render", "nan.obj", "-o", "out.png", "--medium", "fog"], 3, &["nan.obj, vertex 0"]);
}

/// A lamp within a body would light it from inside, which beams do not follow. What counts is the box around the mesh, in which a body may be anywhere.
#[test]
fn lights_inside_bodies_are_refused() {
    let folder = Folder::new();
    let spot = "kind = \"spot\"\ndirection = [0, 0, -1]\n";
    for material in ["ior = 1.5", "opaque = true", "mirror = true"] {
        for (light, words) in [
            ("kind = \"point\"\nposition = [0.1, 0, 0.2]".to_owned(), &["light.1 at [0.1, 0.0, 0.2]"][..]),
            (format!("{spot}position = [0, 0, 0.9]"), &["light.1 at [0.0, 0.0, 0.9]"]),
            // Samples of a soft lamp reach into the box.
            ("kind = \"point\"\nposition = [0, 0, 1.3]\nradius = 1".to_owned(), &["light.1 at"]),
        ] {
            let sun = "[[light]]\nkind = \"distant\"";
            let samples = "[shadow]\nsamples = 16";
            let text = format!(
                "[[material]]\n{material}\n{sun}\n[[light]]\n{light}\n{samples}\n[medium]\nscattering = [0.1, 0.1, 0.1]"
            );
            folder.write("scene.toml", scene(&text));
            let words =
                [words, &["inside the box around the mesh", "move the light", "`light.1.shadows = false`"]].concat();
            folder.refuse(&["render", "scene.toml", "-o", "out.png"], 3, &words);
        }
    }
}

/// The highest and the lowest value of a picture's outputs; an output that is not finite fails.
fn range(folder: &Folder, settings: &[&str]) -> [f32; 2] {
    folder.succeed(&ball(settings));
    let picture = read_picture(&folder.file("out.exr")).expect("the file is whole");
    let values = picture.layers.iter().flat_map(|layer| {
        layer.channels.iter().flat_map(|channel| channel.data.iter().map(|value| (&layer.name, *value)))
    });
    values.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], (name, value)| {
        assert!(value.is_finite(), "{settings:?}: {name} has {value}");
        [low.min(value), high.max(value)]
    })
}

/// Values at the ends of their ranges, and eyes at places where integrands grow.
#[test]
fn extremes_are_rendered_in_finite_numbers() {
    let folder = Folder::new();
    let whole = range(&folder, &[]);
    assert!(whole[1] > 0.0, "{whole:?}");
    for settings in [
        &["medium.anisotropy=0.99"][..],
        &["medium.anisotropy=-0.99"],
        &["medium.scattering=[1e6,1e6,1e6]"],
        &["medium.absorption=[1e6,0,1e-6]"],
        &["medium.extent=1e-6"],
        &["medium.extent=1e6"],
        &["beams.rays=4", "beams.segments=1", "beams.bounces=1", "beams.views=1"],
        &["beams.threshold=1"],
        &["beams.threshold=0", "beams.segments=64", "beams.views=32"],
        &["light.0.intensity=1e9"],
        &["light.0.intensity=0"],
        &["light=[]"],
        &["light.0.shadows=false", "light.0.position=[0,0,0.2]"],
        &["material=[{ior=1}]"],
        &["material=[{ior=4}]"],
        &["camera.position=[0,0,0]"],
        &["camera.position=[0,0,4]", "camera.up=[0,1,0]"],
        &["camera.position=[0,0,-1.5]", "camera.up=[0,1,0]"],
        &["camera.position=[0,0,3.999999]", "camera.up=[0,1,0]"],
        &["camera.projection=orthographic"],
    ] {
        let range = range(&folder, settings);
        println!("{settings:?}: {range:?}");
    }
}

#[test]
fn a_medium_without_coefficients_is_no_medium() {
    let folder = Folder::new();
    let without = "[[light]]\nkind = \"point\"\nposition = [0, 0, 4]\n[ground]\nheight = -2";
    let nothing = "[medium]\nscattering = [0, 0, 0]\nabsorption = [0, 0, 0]\nanisotropy = 0.5";
    folder.write("without.toml", scene(without));
    folder.write("nothing.toml", scene(&format!("{without}\n{nothing}")));
    for name in ["without", "nothing"] {
        let [input, output] = [format!("{name}.toml"), format!("{name}.exr")];
        let size = ["--size", "24x24", "--backend", "cpu", "--set", "beams.rays=8"];
        folder.succeed(&[&["render", &input, "-o", &output][..], &size].concat());
    }
    folder.succeed(&["diff", "without.exr", "nothing.exr", "--max-abs", "0"]);
    let picture = read_picture(&folder.file("nothing.exr")).expect("the file is whole");
    for name in ["airlight", "shadow", "caustics"] {
        let layer = picture.layers.iter().find(|layer| layer.name == name).expect("frames of beams have it");
        assert!(layer.channels.iter().all(|channel| channel.data.iter().all(|value| *value == 0.0)), "{name}");
    }
}

/// A clear body with a hole is rendered as by other methods, with a warning: light that goes in through the hole goes on as it is.
#[test]
fn holes_of_clear_bodies_are_told() {
    let folder = Folder::new();
    let faces = ["f 1 3 2", "f 1 2 4", "f 1 4 3", "f 2 3 4"];
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n";
    folder.write("closed.obj", format!("{vertices}{}\n", faces.join("\n")));
    let render = |file: &str, more: &[&str]| {
        let outcome = folder.vitrum(
            &[
                &["render", file, "-o", "out.exr", "--medium", "fog", "--size", "16x16", "--backend", "cpu"][..],
                &["--set", "beams.rays=16"],
                more,
            ]
            .concat(),
        );
        assert_eq!(outcome.code, Some(0), "{}", outcome.stderr);
        let picture = read_picture(&folder.file("out.exr")).expect("the file is whole");
        let mut values = picture.layers.iter().flat_map(|layer| &layer.channels).flat_map(|channel| &channel.data);
        assert!(values.all(|value| value.is_finite()), "{file}");
        outcome.stderr
    };
    assert!(!render("closed.obj", &[]).contains("warning"));
    for left_out in 0..faces.len() {
        let kept: Vec<&str> =
            faces.iter().enumerate().filter(|(index, _)| *index != left_out).map(|(_, face)| *face).collect();
        folder.write("open.obj", format!("{vertices}{}\n", kept.join("\n")));
        let told = render("open.obj", &[]);
        assert!(
            told.contains("warning: open.obj: the surface is not closed, 3 edges") && told.contains("`vitrum info`"),
            "{told}"
        );
        // A mirror has no inside.
        assert!(!render("open.obj", &["--set", "material=[{mirror=true}]"]).contains("warning"));
    }
}

//! `vitrum info` and `vitrum render` of meshes.

mod common;

use common::Folder;
use serde_json::{Value, json};

/// A tetrahedron of volume 1, and a material.
const TETRAHEDRON: &str =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nusemtl glass\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

fn info(folder: &Folder, file: &str) -> Value {
    let text = folder.succeed(&["info", file, "--json"]);
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[test]
fn a_mesh_is_described_for_people_and_for_machines() {
    let folder = Folder::new();
    folder.write("a.obj", TETRAHEDRON);
    folder.write("a.mtl", "newmtl glass\nKd 1 0.5 0.25\nNi 1.5\n");
    let text = folder.succeed(&["info", "a.obj"]);
    for words in [
        "format      OBJ\n",
        "vertices    4 at 4 positions\n",
        "triangles   4, 0 of them without area",
        "bounds      (0, 0, 0) to (1, 2, 3)\n",
        "area        9\n",
        "volume      1\n",
        "surface     closed: 6 edges, 0 of one triangle, 0 of more than two",
        "materials   glass, base colour [1.0, 0.5, 0.25], index of refraction 1.5\n",
    ] {
        assert!(text.contains(words), "there is no `{words}`:\n{text}");
    }
    assert!(!text.contains("assumed"), "{text}");
    let info = info(&folder, "a.obj");
    assert_eq!((&info["closed"], &info["volume"], &info["triangles"]), (&json!(true), &json!(1.0), &json!(4)));
    assert_eq!(info["bounds"], json!([[0.0, 0.0, 0.0], [1.0, 2.0, 3.0]]));
    assert_eq!(info["materials"][0]["index_of_refraction"], json!(1.5));
    assert_eq!(info["materials"][0]["transmission"], Value::Null);
}

#[test]
fn an_open_mesh_has_no_volume_and_assumptions_are_told() {
    let folder = Folder::new();
    folder.write("open.obj", TETRAHEDRON.trim_end().rsplit_once('\n').expect("lines").0);
    let text = folder.succeed(&["info", "open.obj"]);
    for words in
        ["volume      none", "surface     not closed: 6 edges, 3 of one triangle", "assumed     the file `a.mtl`"]
    {
        assert!(text.contains(words), "there is no `{words}`:\n{text}");
    }
    let info = info(&folder, "open.obj");
    assert_eq!((&info["volume"], &info["boundary_edges"]), (&Value::Null, &json!(3)));
    assert_eq!(info["assumptions"].as_array().map(Vec::len), Some(1));
}

#[test]
fn meshes_with_mistakes_exit_3() {
    let folder = Folder::new();
    folder.write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 4\n");
    folder.write("short.stl", [0; 200]);
    folder.write("huge.ply", "ply\nformat ascii 1.0\nelement vertex 1000000000\nproperty float x\nend_header\n");
    for (file, words) in [
        ("index.obj", &["index.obj, line 4", "vertex 4", "help: correct the index"][..]),
        ("short.stl", &["short.stl", "no triangles"]),
        ("huge.ply", &["huge.ply", "1000000000"]),
        ("missing.ply", &["missing.ply", "cannot be read"]),
    ] {
        folder.refuse(&["info", file], 3, words);
    }
    folder.write("a.obj", TETRAHEDRON);
    folder.refuse(&["convert", "a.obj", "-o", "out.nrrd"], 3, &["a.obj", "this is a mesh"]);
    folder.refuse(
        &["render", "a.obj", "-o", "out.png", "--preset", "jada"],
        2,
        &["jada", "help: did you mean `jade`?"],
    );
    folder.refuse(&["render", "a.obj", "-o", "out.png", "--spacing", "1,1,1"], 2, &["`volume`", "leave `volume` out"]);
}

#[test]
fn a_mesh_is_rendered_and_its_scene_renders_the_same() {
    let folder = Folder::new();
    folder.write("a.obj", TETRAHEDRON);
    folder.write("a.mtl", "newmtl glass\nNi 1.7\n");
    let common = ["--backend", "cpu", "--size", "48x48", "--set", "voxelization.resolution=32"];
    let with = |first: &[&str]| folder.succeed(&[first, &common].concat());
    with(&["render", "a.obj", "-o", "a.exr", "--aov", "normal=n.exr", "--aov", "bounces=b.exr", "--stats", "a.json"]);
    let stats = std::fs::read_to_string(folder.file("a.json")).expect("it was written");
    let stats: Value = serde_json::from_str(&stats).expect("it is JSON");
    assert_eq!(stats["method"], "voxels");
    assert!(stats["voxels"].is_array() && stats["rays_trapped"].is_number(), "{stats}");
    folder.succeed(&[&["scene", "a.obj", "-o", "a.toml"], &common[2..]].concat());
    folder.succeed(&["render", "a.toml", "-o", "c.exr", "--backend", "cpu"]);
    folder.succeed(&["diff", "a.exr", "c.exr", "--max-abs", "0"]);
    // The file says 1.7, a preset says another.
    with(&["render", "a.obj", "-o", "w.exr", "--preset", "water"]);
    assert_eq!(folder.vitrum(&["diff", "a.exr", "w.exr", "--max-abs", "1e-3"]).code, Some(1));
}

#[test]
fn what_rays_cannot_do_is_refused() {
    let folder = Folder::new();
    folder.write("line.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n");
    for method in ["method=voxels", "method=sweep"] {
        let render = ["render", "line.obj", "-o", "out.png", "--set", method];
        folder.refuse(&render, 3, &["line.obj", "none of its 1 triangles has an area"]);
    }
    folder.write("a.obj", TETRAHEDRON);
    let render = ["render", "a.obj", "-o", "out.png", "--set", "method=voxels", "--memory-limit", "1KiB"];
    folder.refuse(&render, 2, &["--memory-limit is for volumes", "voxelization.resolution"]);
}

#[test]
fn holes_of_a_rendered_mesh_are_told() {
    let folder = Folder::new();
    folder.write("closed.obj", TETRAHEDRON);
    folder.write("a.mtl", "newmtl glass\n");
    let small = ["--size", "16x16", "--set", "voxelization.resolution=16", "--backend", "cpu"];
    let messages = |file: &str, method: &str| {
        let outcome = folder.vitrum(&[&["render", file, "-o", "out.png", "--set", method][..], &small].concat());
        assert_eq!(outcome.code, Some(0), "{}", outcome.stderr);
        outcome.stderr
    };
    let faces: Vec<&str> = TETRAHEDRON.lines().filter(|line| line.starts_with("f ")).collect();
    for method in ["method=voxels", "method=sweep", "voxels.surfaces=exact", "voxels.normals=paper"] {
        for face in &faces {
            folder.write("open.obj", TETRAHEDRON.replace(&format!("{face}\n"), ""));
            let told = messages("open.obj", method);
            assert!(told.contains("warning: open.obj: the surface is not closed, 3 edges"), "{method}, {face}: {told}");
        }
        assert!(!messages("closed.obj", method).contains("warning"), "{method}");
    }
}

#[test]
fn an_opaque_mesh_stands_on_the_ground_in_its_shadow() {
    let folder = Folder::new();
    folder.write("a.obj", TETRAHEDRON);
    folder.write("a.mtl", "newmtl glass\nKd 0.9 0.1 0.1\n");
    let common = ["--backend", "cpu", "--size", "48x48", "--set", "shadow.resolution=32"];
    let render =
        |out: &str, more: &[&str]| folder.succeed(&[&["render", "a.obj", "-o", out], &common[..], more].concat());
    let differ = |a: &str, b: &str| folder.vitrum(&["diff", a, b, "--max-abs", "1e-2"]).code == Some(1);
    render("clay.exr", &["--preset", "clay", "--aov", "status=s.exr"]);
    render("lit.exr", &["--preset", "clay", "--set", "light.0.shadows=false"]);
    // The colour of the file instead of the preset's.
    render("own.exr", &["--preset", "clay", "--set", "material.0.color=none"]);
    assert!(differ("clay.exr", "lit.exr") && differ("clay.exr", "own.exr"));
    let refused = |more: &[&str], code: i32, words: &[&str]| {
        folder.refuse(&[&["render", "a.obj", "-o", "no.exr"], &common[..], more].concat(), code, words);
    };
    refused(&["--set", "material.0.color=[1,0,0]"], 2, &["material.0.color", "material.0.opaque = true"]);
    refused(
        &["--set", "material.0.opaque=true", "--set", "method=sweep"],
        2,
        &["material.0.opaque", "method = \"voxels\""],
    );
    refused(
        &["--preset", "clay", "--quiet", "--set", "shadow.filter_radius=2"],
        3,
        &["shadow.filter_radius", "lower `shadow.resolution`"],
    );
}

/// Two meshes of a scene, each at its place, are the one mesh that has both, by either method.
#[test]
fn several_meshes_are_shown_together() {
    let folder = Folder::new();
    let one = "usemtl glass\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    let other = "v 4 1 0\nv 6 1 0\nv 4 5 0\nv 4 1 6\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n";
    folder.write("a.obj", format!("mtllib a.mtl\n{one}"));
    folder.write("both.obj", format!("mtllib a.mtl\n{one}{other}"));
    folder.write("a.mtl", "newmtl glass\nNi 1.5\nnewmtl unused\n");
    let apart = "[[mesh]]\nfile = \"a.obj\"\nup = \"z\"\n[[mesh]]\nfile = \"a.obj\"\nup = \"z\"\nscale = 2\nposition = [4, 1, 0]\n";
    folder.write("apart.toml", apart);
    folder.write("both.toml", "[[mesh]]\nfile = \"both.obj\"\nup = \"z\"\n");
    let render = |scene: &str, method: &str, out: &str| {
        let settings = [&format!("method={method}"), "voxelization.resolution=32", "camera.azimuth=30"];
        let settings = settings.iter().flat_map(|setting| ["--set", setting]);
        let common = ["render", scene, "-o", out, "--backend", "cpu", "--size", "32x32"];
        folder.succeed(&common.into_iter().chain(settings).collect::<Vec<_>>());
    };
    for method in ["voxels", "sweep"] {
        render("apart.toml", method, "apart.exr");
        render("both.toml", method, "both.exr");
        folder.succeed(&["diff", "apart.exr", "both.exr", "--max-abs", "0"]);
    }
    let info = folder.succeed(&["info", "apart.toml"]);
    assert!(info.contains("triangles   8") && info.contains("(0, 0, 0) to (6, 5, 6)"), "{info}");
    // A material of the scene for one of them alone.
    folder.write(
        "gold.toml",
        format!("method = \"voxels\"\n{apart}material = \"gold\"\n[[material]]\nname = \"gold\"\nopaque = true\n"),
    );
    render("gold.toml", "voxels", "gold.exr");
    assert_eq!(folder.vitrum(&["diff", "gold.exr", "apart.exr", "--max-abs", "1e-2"]).code, Some(1));
}

#[test]
fn a_medium_gives_a_scene_of_beams_to_start_from() {
    let folder = Folder::new();
    let scene = folder.succeed(&["scene", "builtin:vase", "--medium", "sea", "--set", "medium.extent=20"]);
    for words in ["method = \"beams\"\n", "[medium]\n", "extent = 20.0\n", "kind = \"spot\"\n", "anisotropy = 0.8\n"] {
        assert!(scene.contains(words), "there is no `{words}`:\n{scene}");
    }
    let help = folder.succeed(&["render", "--help"]);
    assert!(help.contains("fog    thin white fog") && help.contains("sea    clear sea water"), "{help}");
}

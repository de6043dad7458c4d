//! Transfer functions without eyes: what `info` tells of values, thresholds, windows, maps of colours, and functions of other programs.

mod common;

use common::{Folder, nrrd};
use serde_json::Value;

/// A signed CT of 8³ voxels: air at -1000, a body at 40, a bone at 1200.
fn ct() -> Vec<u8> {
    let header =
        "NRRD0004\ntype: int16\ndimension: 3\nsizes: 8 8 8\nencoding: raw\nendian: little\nspacings: 1 1 1\n\n";
    let value = |index: usize| {
        let at = [index % 8, index / 8 % 8, index / 64];
        let inside = |margin: usize| at.iter().all(|&i| (margin..8 - margin).contains(&i));
        match () {
            () if inside(3) => 1200_i16,
            () if inside(1) => 40,
            () => -1000,
        }
    };
    [header.as_bytes(), &(0..512).flat_map(|index| value(index).to_le_bytes()).collect::<Vec<_>>()].concat()
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// The value of the first opacity point above 0, and the last point's value, in a scene file.
fn shown(scene: &str) -> (f64, f64) {
    let number = |line: &str, key: &str| -> Option<f64> {
        let (_, rest) = line.split_once(&format!("{key} = "))?;
        rest.split([',', ' ']).next()?.parse().ok()
    };
    let points: Vec<(f64, f64)> =
        scene.lines().filter_map(|line| number(line, "value").zip(number(line, " opacity"))).collect();
    let first = points.iter().find(|point| point.1 > 0.0).expect("something is seen");
    (first.0, points[points.len() - 1].0)
}

#[test]
fn info_tells_counts_percentiles_and_landmarks() {
    let folder = Folder::new();
    folder.write("ct.nrrd", ct());
    let text = folder.succeed(&["info", "ct.nrrd"]);
    for words in ["counts", "296 voxels", "percentiles", "99.9 %: 1", "gradients", "landmarks", "air -", "dense "] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let info = json(&folder.succeed(&["info", "ct.nrrd", "--json"]));
    let parts = info["histogram_parts"].as_array().expect("parts");
    let counts: u64 = parts.iter().map(|part| part[2].as_u64().expect("a count")).sum();
    assert_eq!((parts.len(), counts), (16, 512));
    // 216 of 512 voxels are inside, 8 of them bone.
    assert_eq!((&parts[0][2], &parts[15][2]), (&296.into(), &8.into()));
    let near = |value: &Value, expected: f64| (value.as_f64().expect("a number") - expected).abs() < 3.0;
    assert!(near(&info["percentiles"]["50"], -1000.0) && near(&info["percentiles"]["95"], 40.0), "{info}");
    let landmarks =
        ["air", "surface", "soft", "dense", "bright"].map(|name| info["landmarks"][name].as_f64().expect("a landmark"));
    assert!(landmarks.is_sorted() && landmarks[1] < 40.0 && (40.0..1200.0).contains(&landmarks[3]), "{landmarks:?}");
}

#[test]
fn flags_set_the_keys_of_the_transfer_function() {
    let folder = Folder::new();
    folder.write("ct.nrrd", ct());
    let scene = |more: &[&str]| folder.succeed(&[&["scene", "ct.nrrd", "--preset", "plain"], more].concat());
    assert!(shown(&scene(&["--threshold", "300"])).0 > 300.0);
    assert!(shown(&scene(&["--threshold", "-500"])).0 > -500.0);
    let (low, high) = shown(&scene(&["--window", "400", "--level", "-40"]));
    assert!(low >= -240.0 && high <= 160.0, "{low} {high}");
    let colored = scene(&["--colormap", "viridis", "--window", "400", "--level", "40"]);
    assert!(
        colored.contains("{ value = -160.0, color = [0.05") && colored.contains("{ value = 240.0, color = [0.9"),
        "{colored}"
    );
    // A scene of these is the same, also with a key after them.
    folder.write("a.toml", scene(&["--threshold", "300"]));
    assert!(shown(&folder.succeed(&["scene", "a.toml"])).0 > 300.0);
    assert!(shown(&folder.succeed(&["scene", "a.toml", "--threshold", "900"])).0 > 900.0);
    folder.succeed(&[
        "render",
        "ct.nrrd",
        "-o",
        "a.png",
        "--threshold",
        "300",
        "--colormap",
        "hot",
        "--size",
        "16x16",
        "--backend",
        "cpu",
    ]);
    let turned = ["--frames", "1", "--size", "8x8", "--backend", "cpu"];
    folder.succeed(&[&["turntable", "ct.nrrd", "-o", "t", "--window", "10", "--level", "5"], &turned[..]].concat());
    folder.refuse(&["render", "ct.nrrd", "-o", "b.png", "--window", "10"], 2, &["--level"]);
    folder.refuse(&["render", "ct.nrrd", "-o", "b.png", "--window", "0", "--level", "1"], 2, &["no window"]);
    folder.refuse(
        &["render", "ct.nrrd", "-o", "b.png", "--colormap", "virids"],
        2,
        &["`virids`", "did you mean `viridis`?"],
    );
    folder.refuse(
        &["render", "builtin:vase", "-o", "b.png", "--threshold", "1"],
        2,
        &["a mesh has no transfer function"],
    );
}

#[test]
fn isosurfaces_stand_alone_or_beside_a_preset() {
    let folder = Folder::new();
    folder.write("ct.nrrd", ct());
    let scene = |more: &[&str]| folder.succeed(&[&["scene", "ct.nrrd", "--isosurface", "300"], more].concat());
    let alone = scene(&["--isosurface", "-300:red:0.25", "--set", "isosurface.0.opacity=0.5"]);
    assert_eq!(alone.matches("[[isosurface]]").count(), 2, "{alone}");
    for words in ["value = -300.0", "color = [1.0, 0.0, 0.0]", "opacity = 0.25", "opacity = 0.5"] {
        assert!(alone.contains(words), "{words}: {alone}");
    }
    assert!(!alone.contains("opacity = ["), "{alone}");
    assert!(scene(&["--preset", "plain"]).contains("opacity = ["));
    folder.write("a.toml", alone);
    assert_eq!(folder.succeed(&["scene", "a.toml", "--isosurface", "7"]).matches("[[isosurface]]").count(), 3);
    let small = ["--size", "16x16", "--backend", "cpu"];
    folder.succeed(&[&["render", "a.toml", "-o", "a.png"], &small[..]].concat());
    let refused = |surface: &str, words: &str| {
        folder.refuse(&["render", "ct.nrrd", "-o", "b.png", "--isosurface", surface], 2, &[words]);
    };
    refused("300:reed", "`reed` is no colour");
    refused("300:red:2", "VALUE[:COLOR[:OPACITY]]");
    let nearest = ["render", "a.toml", "-o", "b.png", "--set", "volume.interpolation=nearest"];
    folder.refuse(&nearest, 2, &["isosurface", "between voxels there is no value"]);
}

#[test]
fn opacity_goes_by_gradients_too() {
    let folder = Folder::new();
    folder.write("ct.nrrd", ct());
    let scene = folder.succeed(&["scene", "ct.nrrd", "--preset", "plain", "--gradient-opacity", "400:1,20:0"]);
    let [first, second] = ["magnitude = 20.0", "magnitude = 400.0"].map(|point| scene.find(point).expect("the point"));
    assert!(first < second, "{scene}");
    folder.write("a.toml", scene);
    folder.succeed(&["render", "a.toml", "-o", "a.png", "--size", "16x16", "--backend", "cpu"]);
    for wrong in ["20", "20:2", "-1:0", "a:b"] {
        let flag = format!("--gradient-opacity={wrong}");
        folder.refuse(&["render", "ct.nrrd", "-o", "b.png", &flag], 2, &["expected MAGNITUDE:FACTOR"]);
    }
    let unsorted = "transfer.gradient=[{opacity=[{magnitude=5,factor=1},{magnitude=2,factor=0}]}]";
    folder.refuse(
        &["render", "ct.nrrd", "-o", "b.png", "--set", unsorted],
        2,
        &["transfer.gradient.0.opacity.1.magnitude"],
    );
    let backwards = "transfer.gradient=[{values=[5,2]}]";
    folder.refuse(&["render", "ct.nrrd", "-o", "b.png", "--set", backwards], 2, &["transfer.gradient.0.values"]);
    let beside = ["--set", "ior_volume.file=ct.nrrd", "--gradient-opacity", "0:1", "--backend", "cpu", "-q"];
    folder.refuse(&[&["render", "ct.nrrd", "-o", "b.png"], &beside[..]].concat(), 3, &["comes from another volume"]);
}

#[test]
fn a_mask_hides_what_has_none_of_its_labels() {
    let folder = Folder::new();
    folder.write("ct.nrrd", ct());
    let labels: Vec<u8> = (0..512).map(|index| if index % 8 < 4 { 3 } else { 0 }).collect();
    folder.write("parts.nrrd", nrrd("8 8 8", "", &labels));
    let mask = ["--mask", "parts.nrrd", "--mask-labels"];
    let scene = folder.succeed(&[&["scene", "ct.nrrd"], &mask[..], &["3"]].concat());
    assert!(scene.contains("parts.nrrd") && scene.contains("labels = [3.0]"), "{scene}");
    let render = ["render", "ct.nrrd", "--preset", "plain", "--size", "16x16", "--backend", "cpu", "-o"];
    folder.succeed(&[&render[..], &["a.png"], &mask, &["3"]].concat());
    let outcome = folder.vitrum(&[&render[..], &["b.png"], &mask, &["9"]].concat());
    assert!(outcome.code != Some(0) && outcome.stderr.contains("values are 0, 3"), "{}", outcome.stderr);
    folder.refuse(&["render", "ct.nrrd", "-o", "b.png", "--mask-labels", "3"], 2, &["--mask"]);
}

#[test]
fn presets_of_hounsfield_units_say_what_they_take_for_granted() {
    let folder = Folder::new();
    folder.write("ct.nrrd", ct());
    folder.write("bytes.nrrd", nrrd("8 8 8", "", &[7; 512].map(|value: u8| value)));
    let small = ["--size", "16x16", "--backend", "cpu"];
    for name in ["ct-bone", "ct-angio", "ct-soft", "ct-lung"] {
        let outcome = folder.vitrum(&[&["render", "ct.nrrd", "-o", "a.png", "--preset", name], &small[..]].concat());
        assert_eq!(outcome.code, Some(0), "{}", outcome.stderr);
        assert!(
            outcome.stderr.contains("note: ct.nrrd: the values, from -1000 to 1200, were taken for Hounsfield units")
        );
        let refused = ["render", "bytes.nrrd", "-o", "b.png", "--preset", name];
        folder.refuse(&refused, 2, &["is for CT in Hounsfield units", "--window, --level"]);
        folder.succeed(&[&refused[..], &["--window", "100", "--level", "50"], &small].concat());
        std::fs::remove_file(folder.file("b.png")).expect("the picture is there");
    }
    folder.succeed(&[&["render", "bytes.nrrd", "-o", "b.png", "--preset", "mr-angio"], &small[..]].concat());
}

#[test]
fn functions_of_other_programs_come_and_go() {
    let folder = Folder::new();
    folder.write("ct.nrrd", ct());
    folder.write(
        "bone.vp",
        "1\n1\n0.9\n0.1\n0.2\n10\n6 -1000 0 200 0 1000 0.8\n4 0 1 255 1\n8 200 0.9 0.8 0.6 1000 1 1 1\n",
    );
    let outcome = folder.vitrum(&["scene", "ct.nrrd", "--transfer", "bone.vp"]);
    assert!(outcome.stdout.contains("reference_length = 1.0"), "{}", outcome.stdout);
    assert!(outcome.stderr.contains("left out: shading"), "{}", outcome.stderr);
    let (first, last) = shown(&outcome.stdout);
    assert_eq!((first, last), (1000.0, 1000.0));
    folder.succeed(&["scene", "ct.nrrd", "--transfer", "bone.vp", "--write-transfer", "bone.json"]);
    let map = json(&std::fs::read_to_string(folder.file("bone.json")).expect("the map"));
    assert_eq!((&map[0]["Points"][4], &map[0]["Points"][9]), (&200.0.into(), &0.8.into()));
    assert_eq!(map[0]["RGBPoints"][0], 200.0);
    // And back, to the same opacities.
    let again = folder.succeed(&["scene", "ct.nrrd", "--transfer", "bone.json"]);
    assert_eq!(shown(&again), (first, last));
    folder.succeed(&[
        "render",
        "ct.nrrd",
        "-o",
        "a.png",
        "--transfer",
        "bone.json",
        "--size",
        "16x16",
        "--backend",
        "cpu",
    ]);
    // A map from 0 to 1 is stretched over the values, which is told.
    folder.write("map.json", r#"[{"ColorSpace":"RGB","RGBPoints":[0,0,0,0,1,1,1,1]}]"#);
    let outcome = folder.vitrum(&["scene", "ct.nrrd", "--transfer", "map.json"]);
    assert!(outcome.stderr.contains("stretched over the values, from -1000 to 1200"), "{}", outcome.stderr);
    assert_eq!(shown(&outcome.stdout).1, 1200.0);
    folder.write("wrong.vp", "1\n2\n");
    folder.refuse(&["scene", "ct.nrrd", "--transfer", "wrong.vp"], 3, &["wrong.vp", "2 lines"]);
    let outcome = folder.vitrum(&["scene", "ct.nrrd", "--preset", "glass", "--write-transfer", "glass.json"]);
    assert!(outcome.stderr.contains("left out: indices of refraction"), "{}", outcome.stderr);
}

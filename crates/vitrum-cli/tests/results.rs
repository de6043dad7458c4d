//! Results of the program: pictures, named outputs, statistics, descriptions.

mod common;

use common::{Folder, nrrd};
use serde_json::Value;
use std::fs;
use vitrum_io::{Channel, Layer, Picture, read_picture, write_picture};

/// A render that is small enough to be quick on one core.
const SMALL: [&str; 8] =
    ["render", "builtin:ball", "--set", "volume.resolution=16", "--size", "32x24", "--backend", "cpu"];

fn small<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&SMALL, more].concat()
}

/// A bright ball, 16 voxels across, in a file.
fn write_ball(folder: &Folder) {
    let voxel = |index: i32| {
        let distance = |coordinate: i32| (2 * coordinate - 15).pow(2);
        let squared = distance(index % 16) + distance(index / 16 % 16) + distance(index / 256);
        if squared < 144 { 200 } else { 3 }
    };
    folder.write("ball.nrrd", nrrd("16 16 16", "spacings: 1 1 1\n", &(0..4096).map(voxel).collect::<Vec<u8>>()));
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[test]
fn every_picture_format_can_be_read_again() {
    let folder = Folder::new();
    for name in ["out.png", "out.exr", "out.hdr", "out.jpg", "out.tif"] {
        assert_eq!(folder.succeed(&small(&["-o", name])), "", "{name}");
        let picture = read_picture(&folder.file(name)).expect(name);
        assert_eq!((picture.width, picture.height), (32, 24), "{name}");
        let color = picture.color();
        assert!(color.iter().any(|pixel| *pixel != color[0]), "{name} shows nothing");
    }
    assert_eq!(folder.names().len(), 5, "nothing else is left: {:?}", folder.names());
}

#[test]
fn exr_keeps_every_output_and_aov_writes_one() {
    let folder = Folder::new();
    folder.succeed(&small(&["-o", "out.exr", "--aov", "depth=depth.exr", "--aov", "light=light.exr"]));
    let picture = read_picture(&folder.file("out.exr")).expect("the file is whole");
    let layer = |name: &str| picture.layers.iter().find(|layer| layer.name == name);
    for name in ["color", "opacity", "transmittance", "depth", "direction", "position", "status"] {
        assert!(layer(name).is_some(), "there is no {name}");
    }
    let depth = read_picture(&folder.file("depth.exr")).expect("the file is whole");
    assert_eq!(depth.layers.first(), layer("depth"));
    read_picture(&folder.file("light.exr")).expect("the file is whole");
    let bytes = fs::read(folder.file("out.exr")).expect("the file is there");
    let holds = |text: &str| bytes.windows(text.len()).any(|window| window == text.as_bytes());
    assert!(holds("vitrum.scene") && holds("builtin = \"ball\""), "the scene is in the metadata");
}

#[test]
fn statistics_are_json_with_every_field() {
    let folder = Folder::new();
    let printed = folder.succeed(&small(&["-o", "out.png", "--frames", "3", "--stats", "stats.json", "--json"]));
    let stats = json(&fs::read_to_string(folder.file("stats.json")).expect("the file is there"));
    assert_eq!(json(&printed), stats);
    assert_eq!((&stats["width"], &stats["height"], &stats["backend"]), (&32.into(), &24.into(), &"cpu".into()));
    assert_eq!(stats["frame_ms"].as_array().map(Vec::len), Some(3));
    assert!(stats["planes"].as_u64() > Some(0));
    for field in [
        "method",
        "adapter",
        "rays_terminated",
        "rays_trapped",
        "dispatches",
        "upload_ms",
        "peak_rss_bytes",
        "gpu_bytes",
        "version",
    ] {
        assert!(stats.get(field).is_some(), "there is no {field}: {stats}");
    }
}

#[test]
fn kernels_are_translated_where_that_is_asked_for() {
    let folder = Folder::new();
    let devices = json(&folder.succeed(&["devices", "--json"]));
    let has_gpu = devices.as_array().expect("a list").iter().any(|device| device["backend"] == "gpu");
    if !has_gpu {
        let required = std::env::var("VITRUM_REQUIRE_GPU").is_ok_and(|value| !value.is_empty() && value != "0");
        assert!(!required, "VITRUM_REQUIRE_GPU is set, and there is no GPU");
        return;
    }
    let render = ["render", "builtin:ball", "--set", "volume.resolution=16", "--size", "16x16", "--json", "-o"];
    let adapter = |more: &[&str]| {
        let statistics = json(&folder.succeed(&[&render, more].concat()));
        statistics["adapter"].as_str().expect("a name").to_owned()
    };
    let translated = adapter(&["translated.png", "--backend", "gpu", "--translate-shaders"]);
    assert!(translated.ends_with("; shaders translated)"), "{translated}");
    adapter(&["cpu.png", "--backend", "cpu"]);
    let bounds = ["--max-rmse", "1e-3"];
    folder.succeed(&[&["diff", "cpu.png", "translated.png"], bounds.as_slice()].concat());
}

#[test]
fn messages_go_to_standard_error_and_quiet_silences_them() {
    let folder = Folder::new();
    let loud = folder.vitrum(&small(&["-o", "out.png"]));
    assert_eq!((loud.code, loud.stdout.as_str()), (Some(0), ""));
    assert!(loud.stderr.contains("cpu") && loud.stderr.contains("32 x 24"), "{}", loud.stderr);
    let quiet = folder.vitrum(&small(&["-o", "out.png", "--quiet"]));
    assert_eq!((quiet.code, quiet.stdout.as_str(), quiet.stderr.as_str()), (Some(0), "", ""));
}

#[test]
fn every_preset_renders_a_volume_file() {
    let folder = Folder::new();
    write_ball(&folder);
    for preset in ["plain", "bone", "amber", "glass", "xray", "haze"] {
        let arguments =
            ["render", "ball.nrrd", "-o", "out.exr", "--size", "24x24", "--backend", "cpu", "--preset", preset];
        folder.succeed(&arguments);
        let color = read_picture(&folder.file("out.exr")).expect("the file is whole").color();
        assert!(color.iter().flatten().all(|value| value.is_finite()), "{preset}");
        assert!(color.iter().any(|pixel| *pixel != color[0]), "{preset} shows nothing");
    }
}

#[test]
fn settings_change_what_a_preset_has_set() {
    let folder = Folder::new();
    write_ball(&folder);
    let changes = ["--set", "volume.spacing=[2, 2, 2]", "--set", "transfer.ior.1.ior=1.5", "--set", "ground=none"];
    let scene = folder.succeed(&[&["scene", "ball.nrrd", "--preset", "amber"][..], &changes].concat());
    assert!(scene.contains("ior = 1.5") && !scene.contains("[ground]"), "{scene}");
    // The preset saw the new spacing: 32 world units are 256 layers of its reference length.
    assert!(scene.contains("reference_length = 0.125"), "{scene}");
    folder.refuse(
        &["scene", "ball.nrrd", "--set", "transfer.ior.9.ior=1.5"],
        2,
        &["transfer.ior", "indices count from 0"],
    );
}

#[test]
fn a_written_scene_renders_the_same_picture() {
    let folder = Folder::new();
    write_ball(&folder);
    fs::create_dir(folder.file("scenes")).expect("the folder is writable");
    let changes = ["--preset", "glass", "--size", "24x24", "--set", "camera.azimuth=40"];
    folder.succeed(&[&["render", "ball.nrrd", "-o", "a.exr", "--backend", "cpu"][..], &changes].concat());
    // In another folder the scene still finds its volume.
    folder.succeed(&[&["scene", "ball.nrrd", "-o", "scenes/ball.toml"][..], &changes].concat());
    folder.succeed(&["render", "scenes/ball.toml", "-o", "b.exr", "--backend", "cpu"]);
    folder.succeed(&["diff", "a.exr", "b.exr", "--max-abs", "0"]);
}

#[test]
fn diff_measures_and_checks() {
    let folder = Folder::new();
    folder.succeed(&small(&["-o", "a.exr"]));
    folder.succeed(&small(&["-o", "b.exr", "--set", "film.exposure=1"]));
    assert!(folder.succeed(&["diff", "a.exr", "a.exr"]).contains("RMSE"));
    let measured = json(&folder.succeed(&["diff", "a.exr", "b.exr", "--json", "-o", "difference.png"]));
    assert!(measured["max_abs"].as_f64() > Some(0.0) && measured["passed"].is_null(), "{measured}");
    read_picture(&folder.file("difference.png")).expect("the file is whole");
    folder.succeed(&["diff", "a.exr", "b.exr", "--max-abs", "1e6", "--max-rmse", "1e6", "--max-flip", "1"]);
    let breach = folder.vitrum(&["diff", "a.exr", "b.exr", "--max-rmse", "1e-9"]);
    assert_eq!(breach.code, Some(1));
    assert!(breach.stdout.contains("RMSE") && breach.stdout.contains("exceeds"), "{}", breach.stdout);
    let breach = folder.vitrum(&["diff", "a.exr", "b.exr", "--max-abs", "0", "--json"]);
    assert_eq!((breach.code, &json(&breach.stdout)["passed"]), (Some(1), &Value::Bool(false)));
}

#[test]
fn diff_compares_alpha_and_layers_and_says_so() {
    let folder = Folder::new();
    let count = 6;
    let color = |alpha: f32| Picture::rgba(3, 2, vec![[0.25, 0.5, 1.0, alpha]; count]).layers.remove(0);
    let layer = |name: &str, channel: &str, value: f32| {
        let mut data = vec![0.0; count];
        data[4] = value;
        Layer { name: name.to_owned(), channels: vec![Channel { name: channel.to_owned(), data }] }
    };
    let write = |name: &str, layers: Vec<Layer>| {
        write_picture(&folder.file(name), &Picture { width: 3, height: 2, layers }, &[]).expect("it can be written");
    };
    write("a.exr", vec![color(0.5), layer("depth", "Z", 1.0), layer("status", "Y", 1.0)]);
    write("b.exr", vec![color(0.5), layer("depth", "Z", 1.5), layer("light", "Y", 1.0)]);
    write("clear.png", vec![color(0.5)]);
    write("opaque.png", vec![color(1.0)]);
    write_picture(&folder.file("rgb.png"), &Picture::rgb(3, 2, vec![[0.25, 0.5, 1.0]; count]), &[]).expect("it is");

    folder.succeed(&["diff", "opaque.png", "rgb.png", "--max-abs", "0"]);
    for other in ["opaque.png", "rgb.png"] {
        for pair in [["clear.png", other], [other, "clear.png"]] {
            let breach = folder.vitrum(&["diff", pair[0], pair[1], "--max-abs", "0"]);
            assert_eq!(breach.code, Some(1), "{pair:?}: {}", breach.stdout);
            for words in
                ["compared   color (R, G, B), alpha\n", "differs    alpha: max 4.98", "check      alpha: largest"]
            {
                assert!(breach.stdout.contains(words), "no `{words}` in: {}", breach.stdout);
            }
            folder.succeed(&["diff", pair[0], pair[1], "--max-abs", "0.5"]);
            folder.succeed(&["diff", pair[0], pair[1], "--max-abs", "0", "--color-only"]);
            // FLIP is of colours.
            folder.succeed(&["diff", pair[0], pair[1], "--max-flip", "0"]);
        }
    }
    let breach = folder.vitrum(&["diff", "a.exr", "b.exr", "--max-rmse", "0.1"]);
    assert_eq!(breach.code, Some(1));
    for words in [
        "compared   color (R, G, B), alpha, depth.Z\n",
        "only in A  status.Y\n",
        "only in B  light.Y\n",
        "differs    depth.Z: max 5.000000e-1 at pixel (1, 1), RMSE 2.041241e-1\n",
        "check      depth.Z: RMSE 2.041e-1 exceeds 1e-1\n",
    ] {
        assert!(breach.stdout.contains(words), "no `{words}` in: {}", breach.stdout);
    }
    let measured = json(&folder.vitrum(&["diff", "a.exr", "b.exr", "--max-abs", "0", "--json"]).stdout);
    assert_eq!((&measured["passed"], &measured["max_abs"]), (&Value::Bool(false), &0.0.into()));
    assert_eq!(measured["channels"][1]["name"], "depth.Z");
    assert_eq!(measured["channels"][1]["worst_pixel"], json("[1, 1]"));
}

#[test]
fn info_describes_files_scenes_and_built_in_volumes() {
    let folder = Folder::new();
    write_ball(&folder);
    folder.write("scene.toml", "volume.file = \"ball.nrrd\"\n");
    for input in ["ball.nrrd", "scene.toml"] {
        let text = folder.succeed(&["info", input]);
        for word in ["NRRD", "16 x 16 x 16", "3 to 200", "histogram", "uint8"] {
            assert!(text.contains(word), "there is no `{word}`:\n{text}");
        }
    }
    let info = json(&folder.succeed(&["info", "ball.nrrd", "--json"]));
    assert_eq!((&info["dimensions"], &info["range"]), (&json("[16, 16, 16]"), &json("[3.0, 200.0]")));
    let counted: u64 = info["histogram"].as_array().into_iter().flatten().filter_map(Value::as_u64).sum();
    assert_eq!(counted, 4096);
    assert!(folder.succeed(&["info", "builtin:ball"]).contains("voxels"));
}

#[test]
fn lists_are_for_people_and_for_machines() {
    let folder = Folder::new();
    for (command, name) in [("presets", "amber"), ("presets", "fog"), ("scenes", "ball"), ("devices", "CPU")] {
        assert!(folder.succeed(&[command]).contains(name), "{command}");
        let listed = json(&folder.succeed(&[command, "--json"]));
        assert!(listed.as_array().into_iter().flatten().any(|entry| entry["name"] == name), "{command}: {listed}");
    }
    let schema = json(&folder.succeed(&["schema"]));
    assert!(schema["properties"]["light"].is_object());
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(folder.succeed(&["completions", shell]).contains("vitrum"), "{shell}");
    }
    for help in ["--help", "--version"] {
        assert!(folder.succeed(&[help]).contains("itrum"));
    }
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_no_file_and_exits_130() {
    use std::process::{Command, Stdio};
    use std::time::Duration;
    let folder = Folder::new();
    let mut child = Command::new(env!("CARGO_BIN_EXE_vitrum"))
        .args(["render", "builtin:ball", "-o", "out.png", "--backend", "cpu", "--size", "64x64", "--frames", "100000"])
        .current_dir(folder.path())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    std::thread::sleep(Duration::from_millis(1500));
    let interrupted = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
    assert!(interrupted.success());
    let status = child.wait().expect("the program ends");
    assert_eq!(status.code(), Some(130));
    assert!(folder.names().is_empty(), "{:?}", folder.names());
}

/// A turntable of a small ball, three pictures.
const TURN: [&str; 10] = [
    "turntable",
    "builtin:ball",
    "--set",
    "volume.resolution=16",
    "--size",
    "32x24",
    "--backend",
    "cpu",
    "--frames",
    "3",
];

#[test]
fn a_turntable_fills_a_folder_and_resumes() {
    let folder = Folder::new();
    folder.succeed(&[&TURN[..], &["-o", "turn"]].concat());
    let file = |index: usize| folder.file(&format!("turn/frame-0000{index}.png"));
    let pictures = [0, 1, 2].map(|index| fs::read(file(index)).expect("three pictures"));
    assert!(pictures[0] != pictures[1], "the camera moved");
    // The first one is what `render` makes.
    folder.succeed(&small(&["-o", "still.png"]));
    let (still, first) = (read_picture(&folder.file("still.png")), read_picture(&file(0)));
    assert_eq!(still.expect("a picture").color(), first.expect("a picture").color());
    fs::remove_file(file(1)).expect("it was there");
    // What stands behind a picture does not make another of it.
    let kept = [&pictures[2][..], b"kept"].concat();
    fs::write(file(2), &kept).expect("it can be written");
    folder.succeed(&[&TURN[..], &["-o", "turn", "--resume"]].concat());
    assert_eq!(fs::read(file(1)).expect("it is there again"), pictures[1]);
    assert_eq!(fs::read(file(2)).expect("it is still there"), kept);
}

#[test]
fn parts_of_a_turntable_make_all_of_it() {
    let folder = Folder::new();
    folder.succeed(&[&TURN[..], &["-o", "turn"]].concat());
    folder.succeed(&[&TURN[..], &["-o", "parts", "--part", "1/2"]].concat());
    let file = |name: &str, index: usize| folder.file(&format!("{name}/frame-0000{index}.png"));
    assert_eq!([0, 1, 2].map(|index| file("parts", index).exists()), [false, true, false]);
    // Pictures of other parts are none of its concern, those of its own are.
    let first = [&fs::read(file("turn", 0)).expect("a picture")[..], b"kept"].concat();
    fs::write(file("parts", 0), &first).expect("it can be written");
    folder.succeed(&[&TURN[..], &["-o", "parts", "--part", "0/2", "--resume", "--stats", "part.json"]].concat());
    let text = fs::read_to_string(folder.file("part.json")).expect("statistics");
    let statistics: Value = serde_json::from_str(&text).expect("JSON");
    let frames = statistics["frames"].as_array().expect("a list");
    assert_eq!(frames.iter().map(|frame| frame["frame"].as_u64()).collect::<Vec<_>>(), [Some(2)]);
    assert_eq!(fs::read(file("parts", 0)).expect("it is still there"), first);
    for index in [1, 2] {
        assert_eq!(
            fs::read(file("parts", index)).expect("a picture"),
            fs::read(file("turn", index)).expect("a picture")
        );
    }
}

#[test]
fn a_turntable_makes_animations() {
    let folder = Folder::new();
    folder.succeed(&[&TURN[..], &["-o", "turn.gif", "--rate", "10"]].concat());
    folder.succeed(&[&TURN[..], &["-o", "turn.png", "--turn", "-90", "--stats", "turn.json"]].concat());
    assert_eq!(folder.names(), ["turn.gif", "turn.json", "turn.png"], "nothing else is left");
    let text = fs::read_to_string(folder.file("turn.json")).expect("statistics");
    let statistics: Value = serde_json::from_str(&text).expect("JSON");
    let frames = statistics["frames"].as_array().expect("a list");
    assert_eq!(frames.iter().map(|frame| frame["frame"].as_u64()).collect::<Vec<_>>(), [Some(0), Some(1), Some(2)]);
    assert!(frames.iter().all(|frame| frame["frame_ms"][0].as_f64() > Some(0.0)), "{text}");
    let bytes = fs::read(folder.file("turn.gif")).expect("an animation");
    assert!(bytes.starts_with(b"GIF89a") && bytes.ends_with(b";"));
    // Each frame has a graphic control extension, here of a tenth of a second.
    assert_eq!(bytes.windows(6).filter(|window| window[..3] == [0x21, 0xf9, 4] && window[4..] == [10, 0]).count(), 3);
    let bytes = fs::read(folder.file("turn.png")).expect("an animation");
    let chunks = |name: &[u8; 4]| bytes.windows(4).filter(|window| *window == name).count();
    assert_eq!((chunks(b"acTL"), chunks(b"fcTL"), chunks(b"fdAT"), chunks(b"IEND")), (1, 3, 2, 1));
}

#[test]
fn a_turntable_says_what_it_cannot_do() {
    let folder = Folder::new();
    for (more, expected) in [
        (&["-o", "turn.avi"][..], "no known animation format"),
        (&["-o", "turn.gif", "--resume"], "cannot be resumed"),
        (&["-o", "turn.gif", "--part", "0/2"], "cannot be made in parts"),
        (&["-o", "turn", "--part", "2/2"], "the last 1/2"),
        (&["-o", "turn", "--set", "camera.position=[0, -5, 0]"], "camera.position"),
    ] {
        folder.refuse(&[&TURN[..], more].concat(), 2, &[expected]);
    }
}

#[test]
fn a_memory_limit_changes_nothing_that_is_seen() {
    let folder = Folder::new();
    let phantom = ["render", "builtin:phantom", "--size", "24x24", "--backend", "cpu", "--quiet"];
    let settings =
        ["--set", "volume.resolution=128", "--set", "camera.elevation=30", "--set", "sweep.sample_distance=6"];
    for (name, limit) in [("whole.exr", "4MiB"), ("streamed.exr", "2047KiB")] {
        folder.succeed(&[&phantom[..], &settings, &["-o", name, "--memory-limit", limit]].concat());
    }
    let layers = |name: &str| read_picture(&folder.file(name)).expect("the file is whole").layers;
    assert!(layers("whole.exr") == layers("streamed.exr"));
    let limit = ["-o", "out.exr", "--memory-limit", "100kB"];
    let words = ["2097152 bytes", "are needed at once", "100000 are allowed", "--memory-limit"];
    folder.refuse(&[&phantom[..], &settings, &limit].concat(), 2, &words);
}

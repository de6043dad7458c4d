//! Reading of volumes: each flag, the scene key of the same meaning, standard input, and written volumes that are read again.

mod common;

use common::{Folder, Outcome, nrrd};
use serde_json::Value;
use std::io::Write;
use std::process::{Command, Stdio};

fn info(folder: &Folder, arguments: &[&str]) -> Value {
    let text = folder.succeed(&[&["info", "--json"], arguments].concat());
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

fn assumes(info: &Value, text: &str) -> bool {
    info["assumptions"]
        .as_array()
        .into_iter()
        .flatten()
        .any(|note| note.as_str().is_some_and(|note| note.contains(text)))
}

/// Runs the program with something at its standard input.
fn piped(folder: &Folder, arguments: &[&str], input: &[u8]) -> Outcome {
    let mut child = Command::new(env!("CARGO_BIN_EXE_vitrum"))
        .args(arguments)
        .current_dir(folder.path())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // It may end without having read all of it.
    let _ = child.stdin.take().expect("a pipe").write_all(input);
    let output = child.wait_with_output().expect("the program ends");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the program writes UTF-8");
    Outcome { code: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
}

/// Eight voxels of 16 bits, big-endian, behind 4 bytes.
fn raw() -> Vec<u8> {
    [b"head".to_vec(), (1..=8_u16).flat_map(|value| (100 * value).to_be_bytes()).collect()].concat()
}

const LAYOUT: [&str; 4] = ["--raw", "2x2x2:u16:be:skip=4", "--spacing", "1,2,3"];

#[test]
fn a_file_without_a_header_is_read_by_flags_or_by_a_scene() {
    let folder = Folder::new();
    folder.write("voxels.dat", raw());
    folder.refuse(&["info", "voxels.dat"], 3, &["neither the content nor the extension", "--raw"]);
    let by_flags = info(&folder, &[&["voxels.dat"], &LAYOUT[..]].concat());
    assert_eq!((&by_flags["range"][1], &by_flags["spacing"][2]), (&800.0.into(), &3.0.into()));
    let scene = folder.succeed(&[&["scene", "voxels.dat"], &LAYOUT[..]].concat());
    assert!(scene.contains("raw = \"2x2x2:uint16:be:skip=4\""), "{scene}");
    folder.write("scene.toml", &scene);
    assert_eq!(info(&folder, &["scene.toml"]), by_flags);
    let size = ["-o", "a.exr", "--size", "8x8", "--backend", "cpu", "--preset", "plain"];
    folder.succeed(&[&["render", "voxels.dat"], &LAYOUT[..], &size].concat());
    folder.succeed(
        &[&["turntable", "voxels.dat"], &LAYOUT[..], &["--frames", "1"], &size[2..], &["-o", "turn"]].concat(),
    );
    folder.refuse(&["info", "voxels.dat", "--raw", "2x2x2"], 2, &["names no sample type", "256x256x109:u8"]);
    folder.refuse(&["info", "voxels.dat", "--raw", "2x2x2:u8"], 3, &["take 8 bytes", "20 are there"]);
    folder.refuse(&["info", "voxels.dat", "--spacing", "1,0,1"], 2, &["three numbers above 0"]);
    folder.write("wrong.toml", "[volume]\nfile = \"voxels.dat\"\nraw = \"2x2\"\n");
    folder.refuse(&["info", "wrong.toml"], 3, &["wrong.toml, line 3", "`volume.raw`", "is no size"]);
    folder.write("wrong.toml", "[volume]\nbuiltin = \"ball\"\ntime = 2\n");
    folder.refuse(&["info", "wrong.toml"], 3, &["`volume.time`", "built-in"]);
}

#[test]
fn points_in_time_and_arrays_are_picked() {
    let folder = Folder::new();
    let header = "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 2 2 2 3\nencoding: raw\n\n";
    let data: Vec<u8> = (0..24).collect();
    folder.write("time.nrrd", [header.as_bytes(), &data].concat());
    assert_eq!(info(&folder, &["time.nrrd", "--time", "2"])["range"], serde_json::json!([16.0, 23.0]));
    let first = info(&folder, &["time.nrrd"]);
    assert!(first["range"][0] == 0.0 && assumes(&first, "3 points in time: the first was taken"));
    folder.refuse(&["info", "time.nrrd", "--time", "3"], 3, &["the point in time 3", "0 to 2 (--time)"]);
    let array = |name: &str, value: u8| {
        let values = format!("{value} ").repeat(8);
        format!("<DataArray type=\"UInt8\" Name=\"{name}\" format=\"ascii\">{values}</DataArray>")
    };
    let vti = format!(
        "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"0 1 0 1 0 1\">\
         <Piece Extent=\"0 1 0 1 0 1\"><PointData>{}{}</PointData></Piece></ImageData></VTKFile>",
        array("pressure", 3),
        array("density", 7)
    );
    folder.write("a.vti", vti);
    assert_eq!(info(&folder, &["a.vti", "--array", "density"])["range"][0], 7.0);
    let first = info(&folder, &["a.vti"]);
    assert!(first["range"][0] == 3.0 && assumes(&first, "--array takes another: `density`"));
    folder.refuse(
        &["info", "a.vti", "--array", "densty"],
        3,
        &["no array `densty`", "did you mean `density`? (--array)"],
    );
    folder.refuse(&["info", "time.nrrd", "--array", "a"], 3, &["no arrays with names"]);
    folder.write("scene.toml", "[volume]\nfile = \"a.vti\"\narray = \"density\"\nup = \"-z\"\n");
    assert_eq!(info(&folder, &["scene.toml"])["range"][0], 7.0);
}

#[test]
fn up_turns_the_volume_and_never_mirrors_it() {
    let folder = Folder::new();
    folder.write("a.nrrd", nrrd("4 4 4", "", &[7; 64]));
    let default = info(&folder, &["a.nrrd"]);
    assert!(assumes(&default, "no orientation") && assumes(&default, "--up"));
    for (up, z) in [("-z", [0.0, 0.0, -1.0]), ("inferior", [0.0, 0.0, -1.0]), ("y", [0.0, 1.0, 0.0])] {
        let turned = info(&folder, &["a.nrrd", "--up", up]);
        assert_eq!(turned["axes"][2], serde_json::json!(z), "{up}");
    }
    let scene = folder.succeed(&["scene", "a.nrrd", "--up", "inferior"]);
    assert!(scene.contains("up = \"-z\""), "{scene}");
    folder.refuse(&["info", "a.nrrd", "--up", "down"], 2, &["`down` is no direction", "z (superior)"]);
    folder.refuse(&["scene", "a.nrrd", "--set", "volume.up=down"], 2, &["`volume.up`", "`down` is no direction"]);
}

#[test]
fn standard_input_is_read_by_its_content() {
    let folder = Folder::new();
    let file = nrrd("4 4 4", "spacings: 1 2 3\n", &[7; 64]);
    let outcome = piped(&folder, &["info", "-"], &file);
    assert!(outcome.code == Some(0) && outcome.stdout.contains("standard input"), "{outcome:?}");
    let outcome = piped(&folder, &["render", "-", "-o", "a.png", "--size", "8x8", "--backend", "cpu"], &file);
    assert_eq!(outcome.code, Some(0), "{outcome:?}");
    let outcome = piped(&folder, &[&["info", "-"], &LAYOUT[..]].concat(), &raw());
    assert!(outcome.code == Some(0) && outcome.stdout.contains("100 to 800"), "{outcome:?}");
    for (input, words) in [(&b""[..], "standard input: there is nothing in it"), (b"noise", "standard input: neither")]
    {
        let outcome = piped(&folder, &["info", "-"], input);
        assert!(outcome.code == Some(3) && outcome.stderr.contains(words), "{outcome:?}");
    }
    let outcome = piped(&folder, &["info", "-", "--max-bytes", "10B"], &file);
    assert!(outcome.code == Some(3) && outcome.stderr.contains("the limit is 10 bytes"), "{outcome:?}");
    assert_eq!(folder.names(), ["a.png"]);
}

#[test]
fn the_limit_holds_and_can_be_raised() {
    let folder = Folder::new();
    folder.write("a.nrrd", nrrd("4 4 4", "", &[7; 64]));
    folder.refuse(&["info", "a.nrrd", "--max-bytes", "63"], 3, &["needs 64 bytes", "the limit is 63"]);
    folder.refuse(&["render", "a.nrrd", "-o", "a.png", "--max-bytes", "63"], 3, &["needs 64 bytes"]);
    folder.succeed(&["info", "a.nrrd", "--max-bytes", "1KiB"]);
    folder.refuse(&["info", "a.nrrd", "--max-bytes", "4 boxes"], 2, &["GiB"]);
}

#[test]
fn convert_writes_what_was_read() {
    let folder = Folder::new();
    folder.write("a.nrrd", nrrd("4 4 4", "spacings: 1 2 3\n", &(0..64).collect::<Vec<u8>>()));
    folder.succeed(&["convert", "a.nrrd", "-o", "b.nrrd", "--up", "-z"]);
    let (turned, again) = (info(&folder, &["a.nrrd", "--up", "-z"]), info(&folder, &["b.nrrd"]));
    for key in ["dimensions", "spacing", "origin", "axes", "range", "histogram", "sample_type"] {
        assert_eq!(turned[key], again[key], "{key}");
    }
    folder.succeed(&["convert", "builtin:ball", "-o", "ball.npy"]);
    assert_eq!(info(&folder, &["ball.npy"])["format"], "NumPy");
    folder.refuse(&["convert", "a.nrrd", "-o", "b.png"], 2, &["no volume format", ".nrrd, .npy"]);
    folder.refuse(&["convert", "a.nrrd", "-o", "none/b.npy"], 2, &["none"]);
}

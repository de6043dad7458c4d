//! `vitrum voxelize`.

mod common;

use common::Folder;
use serde_json::{Value, json};

/// A cube of edge 2, facing outwards.
const CUBE: &str = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nv 0 0 2\nv 2 0 2\nv 0 2 2\nv 2 2 2\n\
                    f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[test]
fn a_cube_becomes_its_shell_or_its_body() {
    let folder = Folder::new();
    folder.write("cube.obj", CUBE);
    let arguments = ["voxelize", "cube.obj", "-r", "8", "-o", "a.nrrd", "--backend", "cpu", "--json"];
    let statistics = json(&folder.succeed(&arguments));
    assert_eq!(statistics["surface_voxels"], json!(8 * 8 * 8 - 6 * 6 * 6));
    assert_eq!(statistics["dimensions"], json!([10, 10, 10]));
    assert_eq!((&statistics["triangles"], &statistics["volume"]), (&json!(12), &Value::Null));
    let info = json(&folder.succeed(&["info", "a.nrrd", "--json"]));
    assert_eq!(
        (&info["dimensions"], &info["stored_as"], &info["range"]),
        (&json!([10, 10, 10]), &json!("8-bit"), &json!([0.0, 255.0]))
    );
    // The cube's middle is the grid's.
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    let middle = number(&info["origin"][0]) + 4.5 * number(&info["spacing"][0]);
    assert!((middle - 1.0).abs() < 1e-5, "{middle}");

    let solid = json(&folder.succeed(&[&arguments[..], &["--solid", "--stats", "a.json"]].concat()));
    assert!((number(&solid["volume"]) - 8.0).abs() < 1e-3, "{solid}");
    assert_eq!((&solid["open_rows"], &solid["surface_voxels"]), (&json!(0), &Value::Null));
    assert_eq!(folder.names(), ["a.json", "a.nrrd", "cube.obj"]);
}

#[test]
fn fields_are_written_beside() {
    let folder = Folder::new();
    folder.write("cube.obj", format!("mtllib a.mtl\nusemtl red\n{CUBE}"));
    folder.write("a.mtl", "newmtl red\nKd 1 0 0\n");
    let fields = ["count=c.nrrd", "normal=n.nrrd", "color=r.nrrd", "material=m.nrrd"];
    let mut arguments = vec!["voxelize", "cube.obj", "-r", "5", "-o", "a.nrrd", "--solid=even-odd", "--quiet"];
    arguments.extend(fields.iter().flat_map(|field| ["--field", field]));
    folder.succeed(&arguments);
    let info = |file: &str| json(&folder.succeed(&["info", file, "--json"]));
    // A corner is met by the triangles of three faces: of one or two each.
    let most = info("c.nrrd")["range"][1].as_f64().unwrap_or_default();
    assert!((3.0..=6.0).contains(&most), "{most}");
    assert_eq!(info("m.nrrd")["range"], json!([0.0, 1.0]));
    let header = |file: &str| String::from_utf8_lossy(&std::fs::read(folder.file(file)).expect("written")).into_owned();
    assert!(header("n.nrrd").contains("kinds: 3-vector domain domain domain\n"));
    assert!(header("r.nrrd").contains("content:=mean of the triangles' linear colours\n"));
}

#[test]
fn a_hole_is_told() {
    let folder = Folder::new();
    folder.write("open.obj", CUBE.trim_end().rsplit_once('\n').expect("lines").0);
    let outcome = folder.vitrum(&["voxelize", "open.obj", "-r", "4", "-o", "a.nrrd", "--solid"]);
    assert_eq!(outcome.code, Some(0), "{}", outcome.stderr);
    assert!(outcome.stderr.contains("16 rows of voxels go through holes"), "{}", outcome.stderr);
}

#[test]
fn wrong_use_is_refused_before_any_work() {
    let folder = Folder::new();
    folder.write("cube.obj", CUBE);
    folder.write("point.obj", "v 1 1 1\nf 1 1 1\n");
    folder.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (arguments, code, words) in [
        (&["cube.obj", "-r", "8", "-o", "a.png"][..], 2, &["a.png", ".nrrd"][..]),
        (&["cube.obj", "-r", "8", "-o", "a.nrrd", "--overlap", "2"], 2, &["--overlap is 2"]),
        (&["cube.obj", "-r", "8", "-o", "a.nrrd", "--field", "count=a.nrrd"], 2, &["two outputs"]),
        (&["cube.obj", "-r", "8", "-o", "a.nrrd", "--field", "depth=b.nrrd"], 2, &["depth", "count, normal, color"]),
        (&["cube.obj", "-r", "0", "-o", "a.nrrd"], 2, &["1..=8192"]),
        (&["cube.obj", "-r", "8", "-o", "a.nrrd", "--padding", "1025"], 2, &["0..=1024"]),
        (&["missing.obj", "-r", "8", "-o", "a.nrrd"], 3, &["missing.obj"]),
        (&["point.obj", "-r", "8", "-o", "a.nrrd", "--quiet"], 3, &["point.obj", "one point", "scale the mesh up"]),
        (&["nan.obj", "-r", "8", "-o", "a.nrrd"], 3, &["nan.obj, vertex 0"]),
    ] {
        folder.refuse(&[&["voxelize"], arguments].concat(), code, words);
    }
}

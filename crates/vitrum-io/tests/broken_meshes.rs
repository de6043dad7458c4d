//! OBJ, MTL, PLY and STL files with one thing wrong each, and the part of the message that says so.

mod common;

use common::mesh::{Shape, cuboid, obj, ply, ply_header, refuse, stl_ascii, stl_binary};
use common::{Folder, gzip};
use vitrum_io::{Error, Place};

fn cube() -> Shape {
    cuboid([0.0; 3], [1.0; 3])
}

#[test]
fn broken_obj_files() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let with = |more: &str| format!("{square}{more}\n").into_bytes();
    let star = (0..2000).map(|corner| {
        let angle = f64::from(corner) / 2000.0 * std::f64::consts::TAU;
        let radius = f64::from(1 + corner % 2);
        format!("v {} {} 0\n", radius * libm::cos(angle), radius * libm::sin(angle))
    });
    let star: String =
        star.chain((0..1).map(|_| "f".to_owned())).chain((1..=2000).map(|one| format!(" {one}"))).collect();
    refuse(
        "broken.obj",
        vec![
            (with("v 1 2"), "line 5: `v` has 2 numbers, not 3 and more"),
            (with("v 1 2 x"), "line 5: `x` is not a finite number within float32"),
            (with("v 0 0 1e30\nf 1 2 3"), "vertex 4: (0e0, 0e0, 1e30) is beyond ±1e18"),
            (with("f 1 2 5"), "line 5: the face names vertex 5, counted from 1, and there are 4"),
            (with("f 1 2 0"), "line 5: the face names vertex 0"),
            (with("f 1 2 -5"), "line 5: the face names vertex -5"),
            (with("f 1 2 99999999999999999999"), "line 5: `99999999999999999999` is not a corner"),
            (with("f 1 2 -9223372036854775808"), "line 5: the face names vertex -9223372036854775808"),
            (with("f 1 2 x"), "line 5: `x` is not a corner such as `1`"),
            (with("f 1 2 3/1/1/1"), "line 5: "),
            (with(""), "there are 4 vertices and no triangles"),
            (with("l 1 2"), "points and lines are no mesh"),
            (b"".to_vec(), "there are no triangles"),
            (b"# nothing\n".to_vec(), "there are no triangles"),
            (star.into_bytes(), "line 2001: a face of 2000 corners that is not convex; 1024 are the most"),
            (gzip(&with("f 1 2 3"))[..40].to_vec(), "the compressed data is damaged after"),
        ],
    );
}

#[test]
fn broken_mtl_files_are_left_out_and_told() {
    let folder = Folder::new();
    for (mtl, expected) in [
        (&b"Kd 1 1 1\n"[..], "a.mtl, line 1: `Kd 1 1 1` stands before the first `newmtl`"),
        (b"newmtl a\nKd 1 x 1\n", "a.mtl, line 2: `Kd 1 x 1` is not 1 or 3 numbers"),
        (b"newmtl a\nKd 1 1\n", "a.mtl, line 2: `Kd 1 1` is not 1 or 3 numbers"),
        (b"newmtl a\nNi\n", "a.mtl, line 2: `Ni ` is not one number"),
        (b"newmtl a\nd nan\n", "a.mtl, line 2: `d nan` is out of range"),
    ] {
        folder.write("a.mtl", mtl);
        let mesh = folder.open_mesh("a.obj", obj(&cube()) + "mtllib a.mtl\n").expect("a cube");
        let facts = mesh.source.assumptions.facts();
        assert!(facts.iter().any(|fact| fact.contains(expected)), "expected: {expected}\nfound: {facts:?}");
    }
}

/// An ascii file of a box after a replacement.
fn ascii(from: &str, to: &str) -> Vec<u8> {
    let text = String::from_utf8(ply("ascii", &cube())).expect("text");
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1).into_bytes()
}

/// A binary file of a box after a replacement in its header.
fn binary(from: &str, to: &str) -> Vec<u8> {
    let header = ply_header("binary_little_endian", &cube());
    assert!(header.contains(from), "{from}");
    let file = ply("binary_little_endian", &cube());
    [header.replacen(from, to, 1).as_bytes(), &file[header.len()..]].concat()
}

/// A binary file of a box after a byte is overwritten, counted from the end of the header.
fn byte(at: usize, value: u8) -> Vec<u8> {
    let mut file = ply("binary_little_endian", &cube());
    file[ply_header("binary_little_endian", &cube()).len() + at] = value;
    file
}

#[test]
fn broken_ply_headers() {
    refuse(
        "broken.ply",
        vec![
            (ascii("format ascii 1.0", "format text 1.0"), "line 2: `text` is not a format"),
            (ascii("format ascii 1.0\n", ""), "the header has no `format`"),
            (ascii("ascii 1.0", "ascii"), "line 2: `format ascii` is not a line of a PLY header"),
            (ascii("vertex 8", "vertex -8"), "line 4: the count of the element `vertex` is `-8`, not a whole number"),
            (ascii("vertex 8", "vertex many"), "is `many`, not a whole number"),
            (ascii("element vertex 8", "element point 8"), "the header has no element `vertex`"),
            (ascii("element face 12", "element vertex 12"), "line 8: the element `vertex` was given in line 4 already"),
            (ascii("property float x", "property quad x"), "line 5: `quad` is not a type of a property"),
            (
                ascii("property float x", "property float y"),
                "line 6: the element `vertex` has the property `y` already",
            ),
            (ascii("property float x", "property list float"), "line 5: `list` is not a type of a property"),
            (ascii("property float x", "property list int x"), "line 5: the property `x` has 2 words for its type"),
            (ascii("property float z", "property float w"), "line 4: the vertices have no property `z`"),
            (ascii("property float x", "property list uchar int x"), "line 4: the vertices have no property `x`"),
            (ascii("uchar int vertex", "float int vertex"), "line 9: a list counted by `float` numbers"),
            (ascii("vertex_indices", "corners"), "line 8: the element `face` has no list `vertex_indices`"),
            (ascii("element vertex 8\n", ""), "line 4: a property before the first element"),
            (ascii("end_header", "endheader"), "the header ends without `end_header`"),
            (b"ply\nformat ascii 1.0\nelement vertex 8\n".to_vec(), "line 4: the header ends without `end_header`"),
            (b"hello\n".to_vec(), "line 1: `hello` is not `ply`"),
            ([b"ply\n", &b"comment\n".repeat(200_000)[..]].concat(), "the header goes on beyond 1048576 bytes"),
        ],
    );
}

#[test]
fn broken_ply_data() {
    let cut = |bytes: usize| {
        let file = ply("binary_big_endian", &cube());
        file[..file.len() - bytes].to_vec()
    };
    let mut nan = cube();
    nan.positions[5][1] = f32::NAN;
    let mut negative = binary("uchar int", "char int");
    let end = negative.len() - 12 * 13;
    negative[end] = 253;
    let no_triangles = Shape { triangles: Vec::new(), ..cube() };
    refuse(
        "broken.ply",
        vec![
            (
                ascii("vertex 8", "vertex 1000000000"),
                "the header promises 1000000000 of the element `vertex` from here, of 6 bytes at least each, and",
            ),
            (binary("vertex 8", "vertex 1000000000"), "of 12 bytes at least each, and 252 bytes are there"),
            (binary("face 12", "face 1000000000"), "1000000000 of the element `face` from here, of 1 bytes at least"),
            (binary("vertex 8", "vertex 18446744073709551615"), "promises 18446744073709551615 of the element"),
            (cut(1), "byte 424: a list of 3 items, and 11 bytes are left"),
            (cut(13), "byte 424: the file ends before the last element"),
            (cut(200), "of 12 bytes at least each, and 52 bytes are there"),
            (ascii("3 0 2 3\n", "3 0 2 8\n"), "line 19: the face names vertex 8, counted from 0, and there are 8"),
            (ascii("3 0 2 3\n", "3 0 2 -1\n"), "line 19: the face names vertex -1"),
            (ascii("3 0 2 3\n", "-3 0 2 3\n"), "line 19: `-3` is not a uchar"),
            (ascii("3 0 2 3\n", "200 0 2 3\n"), "line 19: a list of 200 items, and"),
            (ascii("3 0 2 3\n", "3 0 2 1.5\n"), "line 19: `1.5` is not a int"),
            (ascii("1 1 1\n", "1 one 1\n"), "line 18: `one` is not a float"),
            (ascii("1 1 1\n", "1 nan 1\n"), "vertex 7: (1, NaN, 1) is the first of the positions that are not finite"),
            (ascii("1 1 1\n", "1 1e60 1\n"), "vertex 7: (1, inf, 1)"),
            (byte(96, 255), "a list of 255 items, and 155 bytes are left"),
            (byte(97, 8), "byte 284: the face names vertex 8"),
            (byte(100, 255), "the face names vertex -16777216"),
            (negative, "byte 283: a list of -3 items"),
            (ply("binary_little_endian", &nan), "vertex 5: (1, NaN, 1)"),
            (ply("ascii", &no_triangles), "there are 8 vertices and no triangles"),
        ],
    );
}

#[test]
fn broken_stl_files() {
    let text = |from: &str, to: &str| {
        let text = stl_ascii(&cube());
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1).into_bytes()
    };
    let bytes = stl_binary(b"", &cube());
    let with = |at: usize, value: [u8; 4]| {
        let mut bytes = bytes.clone();
        bytes[at..at + 4].copy_from_slice(&value);
        bytes
    };
    let none = Shape { triangles: Vec::new(), ..cube() };
    let mut cut = stl_ascii(&cube()).into_bytes();
    cut.truncate(cut.windows(8).position(|word| word == b"endfacet").expect("a facet"));
    refuse(
        "broken.stl",
        vec![
            (
                with(80, 1_000_000_000_u32.to_le_bytes()),
                "byte 80: the header promises 1000000000 triangles, which take",
            ),
            (bytes[..83].to_vec(), "83 bytes are no STL file"),
            (bytes[..200].to_vec(), "which take 600 bytes, and 116 follow"),
            (b"".to_vec(), "0 bytes are no STL file"),
            (
                with(96, f32::NAN.to_le_bytes()),
                "byte 96: corner 0 of triangle 0 is [NaN, 0.0, 0.0], which is not finite",
            ),
            (with(84 + 50 + 40, f32::INFINITY.to_le_bytes()), "byte 170: corner 2 of triangle 1 is"),
            (stl_binary(b"", &none), "there are no triangles"),
            (b"solid nothing\nendsolid nothing\n".to_vec(), "there are no triangles"),
            (text("facet normal 0 0 0", "facet normal 0 0"), "line 3: `outer` is not a finite number"),
            (text("vertex 0e0", "vertex zero"), "line 4: `zero` is not a finite number"),
            (text("vertex 0e0", "vertex inf"), "line 4: `inf` is not a finite number"),
            (text("    endloop", "vertex 1 1 1\n endloop"), "line 7: `vertex` where `endloop` was expected"),
            (text("outer loop", "loop"), "line 3: `loop` where `outer` was expected"),
            (text("endfacet", "facet"), "line 8: `facet` where `endfacet` was expected"),
            (text("endsolid shape of a test", ""), "the file ends where `facet` or `endsolid` was expected"),
            (cut, "line 8: the file ends where `endfacet` was expected"),
            (text("endsolid shape of a test\n", "endsolid\nfacet"), "line 87: `facet` where `solid` was expected"),
        ],
    );
}

#[test]
fn places_are_there_for_programs_too() {
    let error = Folder::new().open_mesh("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1e30 0\nf 1 2 3\n").unwrap_err();
    assert!(matches!(error, Error::Invalid { place: Place::Vertex(2), .. }));
}

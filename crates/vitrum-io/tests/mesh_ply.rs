//! PLY: encodings, types, and properties beyond positions.

mod common;

use common::Folder;
use vitrum_io::{Mesh, srgb_to_linear};

/// Types with the bytes of small whole numbers in both orders.
fn number(kind: &str, value: f64, big: bool) -> Vec<u8> {
    let mut bytes = match kind {
        "char" | "int8" => (value as i8).to_le_bytes().to_vec(),
        "uchar" | "uint8" => (value as u8).to_le_bytes().to_vec(),
        "short" | "int16" => (value as i16).to_le_bytes().to_vec(),
        "ushort" | "uint16" => (value as u16).to_le_bytes().to_vec(),
        "int" | "int32" => (value as i32).to_le_bytes().to_vec(),
        "uint" | "uint32" => (value as u32).to_le_bytes().to_vec(),
        "float" | "float32" => (value as f32).to_le_bytes().to_vec(),
        _ => value.to_le_bytes().to_vec(),
    };
    if big {
        bytes.reverse();
    }
    bytes
}

/// Reads a file whose header has lines for elements, and whose data is numbers of the types named, in each encoding.
fn each(elements: &str, data: &[(&str, f64)]) -> Vec<Mesh> {
    let folder = Folder::new();
    let header = |format: &str| format!("ply\nformat {format} 1.0\nobj_info x\n{elements}end_header\n").into_bytes();
    let words: String = data.iter().map(|(_, value)| format!("{value} ")).collect();
    let mut meshes = vec![folder.mesh("a.ply", [header("ascii"), words.into_bytes()].concat())];
    for (format, big) in [("binary_little_endian", false), ("binary_big_endian", true)] {
        let bytes = data.iter().flat_map(|(kind, value)| number(kind, *value, big)).collect();
        meshes.push(folder.mesh("a.ply", [header(format), bytes].concat()));
    }
    for mesh in &meshes[1..] {
        assert_eq!(mesh.source.assumptions, meshes[0].source.assumptions);
        assert_eq!((&mesh.positions, &mesh.triangles), (&meshes[0].positions, &meshes[0].triangles));
    }
    meshes
}

fn positions(kind: &str) -> (String, Vec<(&str, f64)>) {
    let header = format!("element vertex 4\nproperty {kind} x\nproperty {kind} y\nproperty {kind} z\n");
    let data = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0].map(|value| (kind, f64::from(value)));
    (header, data.to_vec())
}

#[test]
fn every_type_of_number() {
    let types = ["char", "uint8", "short", "ushort", "int", "uint32", "float", "float32"];
    for kind in types {
        for count in &types[..6] {
            for item in types {
                let (header, mut data) = positions(kind);
                let header = format!("{header}element face 1\nproperty list {count} {item} vertex_index\n");
                data.extend([(*count, 4.0), (item, 0.0), (item, 1.0), (item, 2.0), (item, 3.0)]);
                for mesh in each(&header, &data) {
                    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
                    assert_eq!(mesh.positions[2], [1.0, 1.0, 0.0]);
                    assert!(mesh.source.assumptions.is_empty(), "{:?}", mesh.source.assumptions);
                }
            }
        }
    }
    let (header, mut data) = positions("double");
    data.extend([("uchar", 3.0), ("int", 0.0), ("int", 1.0), ("int", 2.0)]);
    for mesh in each(&format!("{header}element face 1\nproperty list uchar int vertex_indices\n"), &data) {
        assert_eq!(mesh.source.assumptions.facts(), ["the coordinates were rounded from float64 to float32"]);
        assert_eq!(mesh.source.sample_type, "double");
    }
}

#[test]
fn properties_and_elements_that_nobody_asked_for() {
    let header = "element camera 2\nproperty double view\nproperty list uchar float lens\n\
                  element vertex 3\nproperty uchar quality\nproperty float z\nproperty float y\nproperty float x\n\
                  property list uchar short marks\nelement face 1\nproperty list uchar double weights\n\
                  property list uchar int vertex_indices\nproperty uchar red\nelement empty 5\n";
    let mut data =
        vec![("double", 1.0), ("uchar", 2.0), ("float", 1.0), ("float", 2.0), ("double", 3.0), ("uchar", 0.0)];
    for index in 0..3 {
        let value = f64::from(index);
        data.extend([("uchar", 9.0), ("float", value), ("float", value * value), ("float", -value)]);
        data.extend([("uchar", 1.0), ("short", -7.0)]);
    }
    data.extend([("uchar", 1.0), ("double", 0.5), ("uchar", 3.0), ("int", 0.0), ("int", 1.0), ("int", 2.0)]);
    data.push(("uchar", 255.0));
    for mesh in each(header, &data) {
        assert_eq!(mesh.positions, [[0.0, 0.0, 0.0], [-1.0, 1.0, 1.0], [-2.0, 4.0, 2.0]]);
        assert_eq!(mesh.triangles, [[0, 1, 2]]);
        assert_eq!(
            mesh.source.assumptions.facts(),
            [
                "the element `camera` was left out",
                "of the element `vertex`, the properties were left out: `quality`, `marks`",
                "of the element `face`, the properties were left out: `weights`, `red`",
                "the element `empty` was left out",
            ]
        );
    }
}

#[test]
fn normals_and_colours() {
    let names = "property float nx\nproperty float ny\nproperty float nz\n";
    let face = "element face 1\nproperty list uchar int vertex_indices\n";
    for (kind, largest, decoded) in [("uchar", 255.0, true), ("ushort", 65535.0, true), ("float", 1.0, false)] {
        let colors = ["red", "green", "blue", "alpha"].map(|name| format!("property {kind} {name}\n")).concat();
        let header =
            format!("element vertex 3\nproperty float x\nproperty float y\nproperty float z\n{names}{colors}{face}");
        let mut data = Vec::new();
        for vertex in 0..3 {
            data.extend([vertex % 2, vertex / 2, 0, 0, 0, 5 * vertex].map(|value| ("float", f64::from(value))));
            data.extend([0.0, 0.2, 1.0, 0.2].map(|value| (kind, value * largest)));
        }
        data.extend([("uchar", 3.0), ("int", 0.0), ("int", 1.0), ("int", 2.0)]);
        for mesh in each(&header, &data) {
            assert_eq!(mesh.normals.unwrap(), [[0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]]);
            let light = if decoded { srgb_to_linear(0.2) } else { 0.2 };
            assert_eq!(mesh.colors.unwrap()[1], [0.0, light, 1.0, 0.2]);
            assert_eq!(mesh.source.assumptions.len(), 1);
        }
    }
}

#[test]
fn faces_before_vertices_and_strips() {
    let (vertices, data) = positions("float");
    let faces = "element face 1\nproperty list uchar int vertex_indices\n";
    let face = [("uchar", 3.0), ("int", 0.0), ("int", 1.0), ("int", 2.0)];
    for mesh in each(&format!("{faces}{vertices}"), &[&face[..], &data].concat()) {
        assert_eq!(mesh.triangles, [[0, 1, 2]]);
    }
    let strips = "element tristrips 1\nproperty list int int vertex_indices\n";
    let strip = [8, 0, 1, 2, 3, -1, 3, 2, 2].map(|value| ("int", f64::from(value)));
    for mesh in each(&format!("{vertices}{strips}"), &[&data[..], &strip].concat()) {
        assert_eq!(mesh.triangles, [[0, 1, 2], [1, 3, 2]]);
        assert_eq!(mesh.source.assumptions.facts(), ["1 triangles of strips that have a vertex twice were left out"]);
    }
}

#[test]
fn every_line_end() {
    let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let folder = Folder::new();
    let plain = folder.mesh("a.ply", text);
    for end in ["\r\n", "\r"] {
        assert_eq!(folder.mesh("a.ply", text.replace('\n', end)), plain);
        let wrong =
            folder.open_mesh("a.ply", text.replace('\n', end).replace("0 1 0", "0 y 0")).unwrap_err().to_string();
        assert!(wrong.contains("a.ply, line 12: `y` is not a float"), "{wrong}");
    }
    // Binary data that starts like the end of a line.
    let header = text.split_inclusive("end_header\n").next().unwrap().replace("ascii", "binary_little_endian");
    let mut data = vec![b'\n', 0, 0, 0];
    data.extend([0_u8; 32]);
    data.extend([3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]);
    for end in ["\n", "\r\n", "\r"] {
        let mesh = folder.mesh("a.ply", [header.replace('\n', end).into_bytes(), data.clone()].concat());
        assert_eq!(mesh.positions[0][0], f32::from_bits(10), "{end:?}");
    }
    let surplus = folder.mesh("a.ply", [header.into_bytes(), data, vec![0; 3]].concat());
    assert_eq!(surplus.source.assumptions.facts(), ["3 bytes behind the last element were left unread"]);
}

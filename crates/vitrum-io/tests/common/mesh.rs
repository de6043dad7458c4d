//! Small meshes in every format.

use std::fmt::Write;

use vitrum_io::{Error, Mesh, OpenOptions};

use super::Folder;
use super::vtk::base64;

/// Vertices and the triangles among them.
#[derive(Debug, Clone)]
pub struct Shape {
    pub positions: Vec<[f32; 3]>,
    pub triangles: Vec<[u32; 3]>,
}

/// A box from `low` on, of 8 vertices and 12 triangles.
pub fn cuboid(low: [f32; 3], size: [f32; 3]) -> Shape {
    let corner =
        |index: usize| std::array::from_fn(|axis| low[axis] + if index >> axis & 1 == 1 { size[axis] } else { 0.0 });
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    Shape {
        positions: (0..8).map(corner).collect(),
        triangles: sides.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
    }
}

/// A globe of so many segments around and rings from pole to pole.
pub fn globe(radius: f64, segments: u32, rings: u32) -> Shape {
    let [top, bottom] = [radius, -radius].map(|z| [0.0, 0.0, z as f32]);
    let mut positions = vec![top];
    for ring in 1..rings {
        let (z, r) = circle(radius, rings, ring);
        positions.extend((0..segments).map(|segment| {
            let angle = std::f64::consts::TAU * f64::from(segment) / f64::from(segments);
            [(r * libm::cos(angle)) as f32, (r * libm::sin(angle)) as f32, z as f32]
        }));
    }
    positions.push(bottom);
    let last = positions.len() as u32 - 1;
    let vertex = |ring: u32, segment: u32| 1 + (ring - 1) * segments + segment % segments;
    let mut triangles = Vec::new();
    for segment in 0..segments {
        triangles.push([0, vertex(1, segment), vertex(1, segment + 1)]);
        for ring in 1..rings - 1 {
            let [a, b] = [vertex(ring, segment), vertex(ring + 1, segment)];
            let [d, c] = [vertex(ring, segment + 1), vertex(ring + 1, segment + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
        triangles.push([last, vertex(rings - 1, segment + 1), vertex(rings - 1, segment)]);
    }
    Shape { positions, triangles }
}

/// Height and radius of a globe's ring.
fn circle(radius: f64, rings: u32, ring: u32) -> (f64, f64) {
    let angle = std::f64::consts::PI * f64::from(ring) / f64::from(rings);
    (radius * libm::cos(angle), radius * libm::sin(angle))
}

/// Area and volume of the globe, which is a stack of frusta of pyramids.
pub fn globe_measures(radius: f64, segments: u32, rings: u32) -> (f64, f64) {
    let count = f64::from(segments);
    let half = std::f64::consts::PI / count;
    let (mut area, mut volume) = (0.0, 0.0);
    for ring in 0..rings {
        let ((z, r), (lower, other)) = (circle(radius, rings, ring), circle(radius, rings, ring + 1));
        let slant = libm::hypot(z - lower, (r - other) * libm::cos(half));
        area += count * (r + other) * libm::sin(half) * slant;
        volume += (z - lower) / 3.0 * count / 2.0 * libm::sin(2.0 * half) * (r * r + other * other + r * other);
    }
    (area, volume)
}

/// The shape in every format and encoding, by file name.
pub fn files(shape: &Shape) -> Vec<(&'static str, Vec<u8>)> {
    let (json, data) = gltf(shape);
    let embedded = format!(r#""uri":"data:application/octet-stream;base64,{}","#, base64(&data));
    vec![
        ("a.obj", obj(shape).into_bytes()),
        ("ascii.ply", ply("ascii", shape)),
        ("little.ply", ply("binary_little_endian", shape)),
        ("big.ply", ply("binary_big_endian", shape)),
        ("ascii.stl", stl_ascii(shape).into_bytes()),
        ("binary.stl", stl_binary(b"made by a test", shape)),
        ("a.gltf", json.replace("URI", &embedded).into_bytes()),
        ("a.glb", glb(&json.replace("URI", ""), &data)),
    ]
}

pub fn obj(shape: &Shape) -> String {
    let mut text = String::from("# a shape\no shape\n");
    for [x, y, z] in &shape.positions {
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for [a, b, c] in shape.triangles.iter().map(|triangle| triangle.map(|vertex| vertex + 1)) {
        let _ = writeln!(text, "f {a} {b} {c}");
    }
    text
}

pub fn ply_header(format: &str, shape: &Shape) -> String {
    format!(
        "ply\nformat {format} 1.0\ncomment of a test\nelement vertex {}\nproperty float x\nproperty float y\n\
         property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        shape.positions.len(),
        shape.triangles.len()
    )
}

pub fn ply(format: &str, shape: &Shape) -> Vec<u8> {
    let mut file = ply_header(format, shape).into_bytes();
    if format == "ascii" {
        let vertices = shape.positions.iter().map(|[x, y, z]| format!("{x} {y} {z}\n"));
        let faces = shape.triangles.iter().map(|[a, b, c]| format!("3 {a} {b} {c}\n"));
        file.extend(vertices.chain(faces).collect::<String>().bytes());
        return file;
    }
    let big = format.contains("big");
    let order = |bytes: [u8; 4]| if big { [bytes[3], bytes[2], bytes[1], bytes[0]] } else { bytes };
    file.extend(shape.positions.iter().flatten().flat_map(|value| order(value.to_le_bytes())));
    for triangle in &shape.triangles {
        file.push(3);
        file.extend(triangle.iter().flat_map(|vertex| order(vertex.to_le_bytes())));
    }
    file
}

pub fn stl_ascii(shape: &Shape) -> String {
    let mut text = String::from("solid shape of a test\n");
    for corners in corners(shape) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for [x, y, z] in corners {
            let _ = writeln!(text, "      vertex {x:e} {y:e} {z:e}");
        }
        text += "    endloop\n  endfacet\n";
    }
    text + "endsolid shape of a test\n"
}

pub fn stl_binary(header: &[u8], shape: &Shape) -> Vec<u8> {
    let mut file = header.to_vec();
    file.resize(80, b' ');
    file.extend((shape.triangles.len() as u32).to_le_bytes());
    for corners in corners(shape) {
        file.extend([0; 12]);
        file.extend(corners.iter().flatten().flat_map(|value| value.to_le_bytes()));
        file.extend([0; 2]);
    }
    file
}

fn corners(shape: &Shape) -> impl Iterator<Item = [[f32; 3]; 3]> {
    shape.triangles.iter().map(|triangle| triangle.map(|vertex| shape.positions[vertex as usize]))
}

/// JSON with `URI` in the place of the buffer's address, and the buffer: positions, then 32-bit indices.
pub fn gltf(shape: &Shape) -> (String, Vec<u8>) {
    let mut data: Vec<u8> = shape.positions.iter().flatten().flat_map(|value| value.to_le_bytes()).collect();
    let positions = data.len();
    data.extend(shape.triangles.iter().flatten().flat_map(|vertex| vertex.to_le_bytes()));
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}},
{{"bufferView":1,"componentType":5125,"count":{},"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteLength":{positions}}},{{"buffer":0,"byteOffset":{positions},"byteLength":{}}}],
"buffers":[{{URI"byteLength":{}}}]}}"#,
        shape.positions.len(),
        3 * shape.triangles.len(),
        data.len() - positions,
        data.len()
    );
    (json, data)
}

pub fn glb(json: &str, data: &[u8]) -> Vec<u8> {
    let padded = |bytes: &[u8], fill: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), fill);
        bytes
    };
    let (json, data) = (padded(json.as_bytes(), b' '), padded(data, 0));
    let word = |value: usize| (value as u32).to_le_bytes();
    [
        &b"glTF"[..],
        &word(2),
        &word(28 + json.len() + data.len()),
        &word(json.len()),
        b"JSON",
        &json,
        &word(data.len()),
        b"BIN\0",
        &data,
    ]
    .concat()
}

/// The GLB file of a box after changes to its JSON.
pub fn changed_glb(changes: &[(&str, &str)]) -> Vec<u8> {
    let (mut json, data) = gltf(&cuboid([0.0; 3], [1.0; 3]));
    json = json.replace("URI", "");
    for (from, to) in changes {
        assert!(json.contains(from), "{from} is not in {json}");
        json = json.replace(from, to);
    }
    glb(&json, &data)
}

impl Folder {
    /// Writes and opens a mesh.
    pub fn open_mesh(&self, name: &str, content: impl AsRef<[u8]>) -> Result<Mesh, Error> {
        vitrum_io::open_mesh(&self.write(name, content), &OpenOptions::default())
    }

    /// Writes and opens a mesh that has to be read.
    pub fn mesh(&self, name: &str, content: impl AsRef<[u8]>) -> Mesh {
        self.open_mesh(name, content).unwrap_or_else(|error| panic!("{error}"))
    }
}

/// Opens each file under a name, and looks for the part of the message.
pub fn refuse(name: &str, cases: Vec<(Vec<u8>, &str)>) {
    let folder = Folder::new();
    let mut wrong = Vec::new();
    for (content, expected) in cases {
        match folder.open_mesh(name, content) {
            Err(error) => {
                let message = error.to_string();
                assert!(message.starts_with(&folder.shown(name)), "{message}");
                assert!(matches!(error, Error::Invalid { .. } | Error::Unsupported { .. }), "{error:?}");
                if !message.contains(expected) {
                    wrong.push(format!("expected: {expected}\nfound: {message}\n"));
                }
            }
            Ok(_) => wrong.push(format!("expected: {expected}\nfound no error\n")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.concat());
}

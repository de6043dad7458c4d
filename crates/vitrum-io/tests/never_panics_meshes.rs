//! Properties: whatever the bytes are, opening them as a mesh ends, in a mesh or an error.

mod common;
#[path = "readers/seeds.rs"]
mod seeds;
#[path = "readers/whole.rs"]
mod whole;

use common::mesh::{Shape, cuboid, files, globe, gltf, obj, ply};
use common::{Folder, gzip};
use proptest::collection::vec;
use proptest::prelude::*;
use vitrum_io::{OpenOptions, open_mesh};
use whole::Whole;

/// Largest memory that a file may ask for, in bytes.
const MOST: u64 = 1 << 20;

fn open(folder: &Folder, name: &str, content: &[u8]) {
    let path = folder.write(name, content);
    let Ok(mesh) = open_mesh(&path, &OpenOptions { max_bytes: Some(MOST), ..OpenOptions::default() }) else {
        return;
    };
    mesh.assert_whole(MOST);
    let fine = mesh.subdivide().expect("small enough");
    assert_eq!(fine.triangles.len(), 4 * mesh.triangles.len());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_meshes(
        changes in vec((any::<usize>(), any::<u8>()), 1..12),
        cut in prop_oneof![4 => Just(0_usize), 1 => any::<usize>()],
    ) {
        let folder = Folder::new();
        folder.write("a.mtl", "newmtl a\nKd 1 0 1\nd 0.5\n");
        let seeds = ["obj", "ply", "stl", "gltf"].map(|target| seeds::seeds(target).into_iter().map(move |file| (target, file)));
        for (target, mut file) in seeds.into_iter().flatten() {
            let name = &format!("b.{target}");
            for (position, value) in &changes {
                let position = position % file.len();
                file[position] = *value;
            }
            file.truncate(file.len() - cut % file.len());
            open(&folder, name, &file);
            open(&folder, name, &gzip(&file));
        }
    }

    /// Digits and signs for others, which leave the form of a text whole.
    #[test]
    fn texts_of_other_numbers(changes in vec((any::<usize>(), "[-0-9.e]"), 1..20)) {
        let folder = Folder::new();
        let shape = cuboid([0.0; 3], [1.0; 3]);
        let (json, _) = gltf(&shape);
        for (name, text) in [("a.obj", obj(&shape).into_bytes()), ("a.ply", ply("ascii", &shape)), ("a.gltf", json.into())] {
            let mut text = text;
            let digits: Vec<_> = (0..text.len()).filter(|&at| text[at].is_ascii_digit()).collect();
            for (position, digit) in &changes {
                text[digits[position % digits.len()]] = digit.as_bytes()[0];
            }
            open(&folder, name, &text);
        }
    }

    #[test]
    fn random_obj_statements(lines in vec("(v|vn|vt|f|l|o|g|s|usemtl|mtllib|x)[ \\\\]{1,2}[-0-9/. e]{0,20}", 0..30)) {
        let folder = Folder::new();
        open(&folder, "a.obj", format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{}\n", lines.join("\n")).as_bytes());
    }

    #[test]
    fn random_materials(lines in vec("(newmtl|Kd|Tf|d|Tr|Ni|Pr|map_Kd|Ks|illum) [-0-9. ea]{0,12}", 0..12)) {
        let folder = Folder::new();
        folder.write("a.mtl", lines.join("\n"));
        open(&folder, "a.obj", (String::from("mtllib a.mtl\nusemtl a\n") + &obj(&globe(1.0, 4, 3))).as_bytes());
    }

    #[test]
    fn random_ply_headers(lines in vec("(element (vertex|face|x)|property (float|uchar|int|double|list uchar int|list int float)) (x|y|z|nx|red|vertex_indices|[0-9]{1,10})", 0..12), data in vec(any::<u8>(), 0..99)) {
        let folder = Folder::new();
        for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
            let header = format!("ply\nformat {format} 1.0\n{}\nend_header\n", lines.join("\n"));
            open(&folder, "a.ply", &[header.as_bytes(), &data].concat());
            open(&folder, "a.ply", format!("{header}1 2 3 4 5 6 7 8 9 0 1 2 3 0 1 2 3 2 1 0").as_bytes());
        }
    }

    /// Polygons of any corners, on a grid, so that many coincide or are in line.
    #[test]
    fn polygons_keep_their_area(corners in vec((0..6_u8, 0..6_u8), 3..24)) {
        let positions: String = corners.iter().map(|(x, y)| format!("v {x} {y} 0\n")).collect();
        let face: String = (1..=corners.len()).map(|corner| format!(" {corner}")).collect();
        let folder = Folder::new();
        let mesh = folder.mesh("a.obj", format!("{positions}f{face}\n"));
        prop_assert_eq!(mesh.triangles.len(), corners.len() - 2);
        if mesh.source.assumptions.is_empty() {
            let doubled: i32 = (0..corners.len()).map(|index| {
                let ((x, y), (u, v)) = (corners[index], corners[(index + 1) % corners.len()]);
                i32::from(x) * i32::from(v) - i32::from(y) * i32::from(u)
            }).sum();
            // A polygon without area becomes a fan, which may have some.
            prop_assert!(doubled == 0 || mesh.surface_area() == f64::from(doubled.abs()) / 2.0);
        }
    }

    #[test]
    fn random_bytes(bytes in vec(any::<u8>(), 0..700), extension in "obj|ply|stl|gltf|glb|x", start in "|ply\n|solid |glTF|v 0 0 0\n|\\{\"asset\"") {
        let folder = Folder::new();
        open(&folder, &format!("a.{extension}"), &[start.as_bytes(), &bytes].concat());
    }

    #[test]
    fn any_triangles(triangles in vec([0..9_u32, 0..9, 0..9], 1..30)) {
        let folder = Folder::new();
        let shape = Shape { positions: globe(1.0, 3, 4).positions.into_iter().take(9).collect(), triangles };
        for (name, file) in files(&shape) {
            open(&folder, name, &file);
        }
    }
}

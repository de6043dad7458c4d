//! Real meshes: counts and edges as their descriptions state them, and as trimesh counts them (docs/peers.md).

use std::collections::HashMap;

use vitrum_conformance::data::shared;
use vitrum_io::{Mesh, OpenOptions, open_mesh};

/// The facts that are known about a file.
struct Stated {
    file: &'static str,
    format: &'static str,
    triangles: usize,
    /// Number of vertices in the file; `None` where its source does not state it. No vertex has several normals.
    vertices: Option<usize>,
    /// Number of edges of one triangle and of more than two, where each vertex is a point of its own; `None` where the file's source
    /// does not state it.
    by_index: Option<[usize; 2]>,
    /// Number of points, where vertices at equal positions are one point, and of edges of one triangle and of more than two.
    by_position: [usize; 3],
    closed: bool,
}

const fn stated(
    file: &'static str,
    format: &'static str,
    triangles: usize,
    vertices: Option<usize>,
    by_index: Option<[usize; 2]>,
    by_position: [usize; 3],
    closed: bool,
) -> Stated {
    Stated { file, format, triangles, vertices, by_index, by_position, closed }
}

const FILES: &[Stated] = &[
    stated("bunny_69451_ascii.ply", "PLY", 69451, Some(35947), None, [35947, 223, 0], false),
    stated("dragon_202520.ply", "PLY", 202520, Some(100250), Some([0, 2534]), [100250, 0, 2534], false),
    stated("buddha_100000.obj", "OBJ", 100000, Some(49950), Some([0, 50]), [49950, 0, 50], false),
    stated("horse_96966.ply", "PLY", 96966, Some(48485), Some([0, 0]), [48485, 0, 0], true),
    stated("hand_closed.obj", "OBJ", 15982, Some(7993), Some([0, 0]), [7993, 0, 0], true),
    stated("teapot.obj", "OBJ", 6320, Some(3644), Some([1036, 0]), [3241, 160, 0], false),
    // Its 415 vertices have several normals each.
    stated("tree.obj", "OBJ", 760, None, None, [406, 0, 0], true),
    stated("footbones_ascii.ply", "PLY", 4204, Some(2154), Some([0, 0]), [2154, 0, 0], true),
    stated("idgh_binary.stl", "STL", 11036, None, None, [5500, 0, 0], true),
    stated("slotted_disk_ascii.stl", "STL", 288, None, None, [149, 12, 0], false),
    // Its nodes move vertices, and the order of the products decides which fall together: trimesh has 60039, and 1
    // edge of three triangles.
    stated("2CylinderEngine.glb", "glTF", 121496, None, None, [60040, 13308, 0], false),
];

fn read(file: &str) -> Option<Mesh> {
    let path = shared(&format!("meshes/{file}"))?;
    Some(open_mesh(&path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}")))
}

/// Edges of one triangle and of more than two, by another way than the library's.
fn edges_by_index(mesh: &Mesh) -> [usize; 2] {
    let mut uses: HashMap<[u32; 2], usize> = HashMap::new();
    for &[a, b, c] in &mesh.triangles {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            *uses.entry([from.min(to), from.max(to)]).or_default() += 1;
        }
    }
    [uses.values().filter(|&&count| count == 1).count(), uses.values().filter(|&&count| count > 2).count()]
}

#[test]
fn real_meshes_open_as_they_are_described() {
    for Stated { file, format, triangles, vertices, by_index, by_position, closed } in FILES {
        let Some(mesh) = read(file) else { continue };
        assert_eq!((mesh.source.format, mesh.triangles.len()), (*format, *triangles), "{file}");
        assert_eq!(mesh.positions.len(), vertices.unwrap_or(mesh.positions.len()), "{file}");
        if let Some(by_index) = by_index {
            assert_eq!(edges_by_index(&mesh), *by_index, "{file}");
        }
        let topology = mesh.topology();
        let found = [topology.points, topology.boundary_edges, topology.non_manifold_edges];
        assert_eq!(found, *by_position, "{file}");
        assert_eq!(mesh.is_closed(), *closed, "{file}");
    }
}

#[test]
fn real_meshes_say_what_was_left_out() {
    for (file, expected) in [
        ("bunny_69451_ascii.ply", "of the element `vertex`, the properties were left out: `confidence`, `intensity`"),
        ("horse_96966.ply", "the colours were taken for sRGB, and decoded"),
        ("tree.obj", "vertices with several normals were doubled: 415 became "),
    ] {
        let Some(mesh) = read(file) else { continue };
        let found = &mesh.source.assumptions;
        assert!(found.iter().any(|assumption| assumption.fact.starts_with(expected)), "{file}: {found:?}");
    }
}

#[test]
fn an_engine_of_parts_in_their_places() {
    let Some(mesh) = read("2CylinderEngine.glb") else { return };
    let [low, high] = mesh.bounds();
    // As trimesh has them. Without its nodes every part would lie about the origin.
    for (found, expected) in [low, high].as_flattened().iter().zip([-371.692, -180.972, -140.0, 371.692, 92.042, 128.0])
    {
        assert!((found - expected).abs() < 1e-3, "{low:?} to {high:?}");
    }
    assert_eq!(mesh.materials.len(), 34);
    assert_eq!(mesh.triangle_materials.len(), mesh.triangles.len());
    assert!(mesh.normals.is_some() && mesh.source.assumptions.is_empty(), "{:?}", mesh.source.assumptions);
}

#[test]
fn a_dragon_of_810080_triangles() {
    let Some(mesh) = read("dragon_202520.ply") else { return };
    let fine = mesh.subdivide().unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(fine.triangles.len(), 810_080);
    // Middles are rounded to float32, of which the dragon's smallest edges have a few thousand steps.
    assert!((fine.surface_area() / mesh.surface_area() - 1.0).abs() < 1e-5);
    assert!((fine.signed_volume() / mesh.signed_volume() - 1.0).abs() < 1e-5);
}

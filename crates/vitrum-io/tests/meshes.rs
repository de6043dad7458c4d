//! Meshes of all formats: equal geometry, closed forms of area and volume, edges and parts.

mod common;

use common::mesh::{Shape, cuboid, files, globe, globe_measures, obj};
use common::{Folder, gzip};
use vitrum_io::{Error, Mesh, OpenOptions, Topology, is_mesh, mesh_readers, open_mesh};

fn mesh(shape: &Shape) -> Mesh {
    Mesh::new("shape", shape.positions.clone(), shape.triangles.clone()).unwrap_or_else(|error| panic!("{error}"))
}

fn joined(shapes: &[Shape]) -> Shape {
    let mut all = Shape { positions: Vec::new(), triangles: Vec::new() };
    for shape in shapes {
        let first = all.positions.len() as u32;
        all.positions.extend(&shape.positions);
        all.triangles.extend(shape.triangles.iter().map(|triangle| triangle.map(|vertex| vertex + first)));
    }
    all
}

/// The corners of all triangles, bit for bit.
fn corners(mesh: &Mesh) -> Vec<[[u32; 3]; 3]> {
    let bits = |vertex: u32| mesh.positions[vertex as usize].map(f32::to_bits);
    mesh.triangles.iter().map(|triangle| triangle.map(bits)).collect()
}

fn close(found: f64, expected: f64, bound: f64) {
    assert!((found - expected).abs() <= bound * expected.abs(), "{found} instead of {expected}");
}

#[test]
fn every_format_gives_the_same_triangles() {
    let folder = Folder::new();
    let shape = globe(1.5, 7, 5);
    let expected = corners(&mesh(&shape));
    let mut formats = Vec::new();
    for (name, content) in files(&shape) {
        let read = folder.mesh(name, &content);
        assert_eq!(corners(&read), expected, "{name}");
        assert_eq!(read.positions.len(), shape.positions.len(), "{name}");
        assert_eq!(read.name, folder.shown(name));
        assert!(read.is_closed(), "{name}");
        // Through gzip, and by the content alone.
        assert_eq!(corners(&folder.mesh(&format!("{name}.gz"), gzip(&content))), expected, "{name}");
        assert_eq!(corners(&folder.mesh("without_extension", &content)), expected, "{name}");
        assert!(is_mesh(&folder.path("without_extension")).unwrap());
        formats.push(read.source.format);
    }
    for reader in mesh_readers() {
        assert!(formats.contains(&reader.format().name), "no file is {}", reader.format().name);
    }
}

#[test]
fn area_and_volume_of_a_box_and_a_globe() {
    let folder = Folder::new();
    // Float64 sums of float32 positions: the box is exact, and the globe's vertices are off by 2^-24 of the radius.
    let (area, volume) = globe_measures(1.5, 24, 16);
    for (shape, area, volume, bound) in [
        (cuboid([-1.0, 2.0, 0.5], [1.0, 2.0, 4.0]), 28.0, 8.0, 1e-15),
        // Far from the origin, where coordinates have a digit or two behind the point.
        (cuboid([1e6, -2e6, 3e6], [1.0, 2.0, 4.0]), 28.0, 8.0, 1e-15),
        (globe(1.5, 24, 16), area, volume, 1e-6),
    ] {
        for (name, content) in files(&shape) {
            let read = folder.mesh(name, content);
            close(read.surface_area(), area, bound);
            close(read.signed_volume(), volume, bound);
            assert_eq!(read.degenerate_triangle_count(), 0, "{name}");
        }
    }
    let bounds = mesh(&cuboid([-1.0, 2.0, 0.5], [1.0, 2.0, 4.0])).bounds();
    assert_eq!(bounds, [[-1.0, 2.0, 0.5], [0.0, 4.0, 4.5]]);
    // And the globe is a ball up to the second order.
    let (area, volume) = globe_measures(1.5, 400, 400);
    close(area, 9.0 * std::f64::consts::PI, 1e-4);
    close(volume, 4.5 * std::f64::consts::PI, 1e-4);
}

#[test]
fn turned_inside_out_the_volume_is_negative() {
    let mut shape = cuboid([0.0; 3], [1.0, 2.0, 4.0]);
    shape.triangles.iter_mut().for_each(|triangle| triangle.reverse());
    assert_eq!(mesh(&shape).signed_volume(), -8.0);
    assert!(mesh(&shape).is_closed());
}

#[test]
fn edges_and_parts_are_counted() {
    let cube = cuboid([0.0; 3], [1.0; 3]);
    let closed =
        Topology { points: 8, edges: 18, boundary_edges: 0, non_manifold_edges: 0, unpaired_edges: 0, parts: 1 };
    assert_eq!(mesh(&cube).topology(), closed);
    assert!(closed.is_closed());
    let mut open = cube.clone();
    open.triangles.pop();
    assert_eq!(mesh(&open).topology(), Topology { boundary_edges: 3, unpaired_edges: 3, ..closed });
    let mut turned = cube.clone();
    turned.triangles[0].reverse();
    assert_eq!(mesh(&turned).topology(), Topology { unpaired_edges: 3, ..closed });
    assert!(!mesh(&turned).is_closed());
    // Two boxes that share an edge: four triangles meet there, and a volume is enclosed all the same.
    let joined_at_an_edge = joined(&[cube.clone(), cuboid([1.0, 1.0, 0.0], [1.0; 3])]);
    let topology = mesh(&joined_at_an_edge).topology();
    assert_eq!(topology, Topology { points: 14, edges: 35, non_manifold_edges: 1, ..closed });
    assert!(!topology.is_closed());
    assert_eq!(mesh(&joined_at_an_edge).signed_volume(), 2.0);
    let apart = joined(&[cube.clone(), cuboid([5.0; 3], [1.0; 3]), cuboid([9.0; 3], [1.0; 3])]);
    assert_eq!(mesh(&apart).topology(), Topology { points: 24, edges: 54, parts: 3, ..closed });
    // Each triangle with vertices of its own, one of them at -0.
    let soup = Shape {
        positions: cube.triangles.iter().flatten().map(|&vertex| cube.positions[vertex as usize]).collect(),
        triangles: (0..12).map(|triangle| [3 * triangle, 3 * triangle + 1, 3 * triangle + 2]).collect(),
    };
    let mut negative_zero = soup;
    negative_zero.positions[0][0] *= -1.0;
    assert_eq!(mesh(&negative_zero).topology(), closed);
}

#[test]
fn triangles_without_area_stay_and_are_counted() {
    let mut shape = cuboid([0.0; 3], [1.0; 3]);
    shape.triangles.extend([[0, 0, 1], [3, 3, 3]]);
    let folder = Folder::new();
    for (name, content) in files(&shape) {
        let read = folder.mesh(name, content);
        assert_eq!((read.triangles.len(), read.degenerate_triangle_count()), (14, 2), "{name}");
        assert!(read.is_closed(), "{name}");
        assert_eq!(read.signed_volume(), 1.0, "{name}");
    }
}

#[test]
fn subdivision_keeps_the_surface() {
    let folder = Folder::new();
    let text = "v 0 0 0 1 0 0\nv 2 0 0 0 0 0\nv 0 2 0 0 0 0\nvn 0 0 1\nvn 1 0 0\nf 1//1 2//2 3//1\n";
    let triangle = folder.mesh("a.obj", format!("usemtl a\n{text}")).subdivide().unwrap();
    assert_eq!(triangle.positions[3..], [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    let half = 0.5_f32.sqrt();
    assert_eq!(triangle.normals.as_ref().unwrap()[3], [half, 0.0, half]);
    assert_eq!(triangle.colors.as_ref().unwrap()[3], [0.5, 0.0, 0.0, 1.0]);
    assert_eq!(triangle.triangle_materials, [0; 4]);
    let globe = mesh(&globe(1.0, 9, 7));
    let fine = globe.subdivide().unwrap();
    assert_eq!(fine.triangles.len(), 4 * globe.triangles.len());
    let (topology, before) = (fine.topology(), globe.topology());
    assert!(topology.is_closed());
    assert_eq!(topology.points, before.points + before.edges);
    assert_eq!(topology.edges, 2 * before.edges + 3 * globe.triangles.len());
    // Middles are rounded to float32.
    close(fine.surface_area(), globe.surface_area(), 1e-6);
    close(fine.signed_volume(), globe.signed_volume(), 1e-6);
    assert_eq!(fine.bounds(), globe.bounds());
}

#[test]
fn meshes_that_contradict_themselves() {
    let triangle = vec![[0.0; 3], [1.0; 3], [2.0; 3]];
    for (positions, triangles, expected) in [
        (triangle.clone(), vec![], "shape: there are 3 vertices and no triangles"),
        (vec![], vec![], "shape: there are no triangles"),
        (triangle.clone(), vec![[0, 1, 2], [0, 1, 3]], "triangle 1: the triangle (0, 1, 3) names a vertex beyond"),
        (vec![[0.0; 3], [0.0, f32::NAN, 0.0], [0.0; 3]], vec![[0, 1, 2]], "vertex 1: (0, NaN, 0) is the first"),
        (vec![[0.0; 3], [0.0; 3], [1e30; 3]], vec![[0, 1, 2]], "vertex 2: (1e30, 1e30, 1e30) is beyond ±1e18"),
    ] {
        let message = Mesh::new("shape", positions, triangles).unwrap_err().to_string();
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
    }
}

#[test]
fn limits_hold_for_every_format() {
    let folder = Folder::new();
    for (name, content) in files(&globe(1.0, 20, 20)) {
        for (name, content) in [(name.to_owned(), content.clone()), (format!("{name}.gz"), gzip(&content))] {
            let path = folder.write(&name, content);
            // The globe takes 13716 bytes; the files are larger.
            for max_bytes in [0, 100, 13_000] {
                let error = open_mesh(&path, &OpenOptions { max_bytes: Some(max_bytes), ..OpenOptions::default() })
                    .unwrap_err();
                assert!(matches!(error, Error::TooLarge { .. }), "{error}");
            }
            open_mesh(&path, &OpenOptions { max_bytes: Some(1 << 20), ..OpenOptions::default() })
                .unwrap_or_else(|error| panic!("{error}"));
        }
    }
}

#[test]
fn volumes_are_no_meshes() {
    let folder = Folder::new();
    let volume = folder.write("a.stl", "NRRD0004\n");
    assert!(!is_mesh(&volume).unwrap(), "the content decides");
    assert!(is_mesh(&folder.write("a.ply", "")).unwrap(), "the extension helps");
    assert!(!is_mesh(&folder.path(".")).unwrap());
    assert!(is_mesh(&folder.path("missing.obj")).is_err());
    let message = folder.open_mesh("a.txt", "hello").unwrap_err().to_string();
    assert!(message.contains("PLY (.ply), glTF (.gltf, .glb), STL (.stl), OBJ (.obj)"), "{message}");
    let message = folder.open_mesh("a.obj", obj(&cuboid([0.0; 3], [1.0; 3])) + "f 1 2 9\n").unwrap_err().to_string();
    assert!(message.starts_with(&folder.shown("a.obj, line 23: ")), "{message}");
}

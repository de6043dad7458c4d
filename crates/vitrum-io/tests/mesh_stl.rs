//! STL: text and bytes, and telling the two apart.

mod common;

use common::Folder;
use common::mesh::{cuboid, stl_ascii, stl_binary};

#[test]
fn binary_files_may_start_with_solid() {
    let folder = Folder::new();
    let shape = cuboid([0.0; 3], [1.0; 3]);
    let plain = folder.mesh("a.stl", stl_binary(b"plain", &shape));
    for header in [&b"solid"[..], b"solid facet normal 0 0 0", b"solid\nfacet\n"] {
        let file = stl_binary(header, &shape);
        let mesh = folder.mesh("a.stl", &file);
        assert_eq!(mesh.triangles, plain.triangles);
        assert_eq!(mesh.source.encoding, "binary, little-endian");
        assert!(mesh.source.assumptions[0].fact.starts_with("the header starts like text, `solid"));
        let cut = folder.open_mesh("a.stl", &file[..file.len() - 1]).unwrap_err().to_string();
        assert!(
            cut.contains("byte 80: the header promises 12 triangles, which take 600 bytes, and 599 follow"),
            "{cut}"
        );
    }
    assert!(plain.source.assumptions.is_empty());
}

#[test]
fn corners_at_one_position_are_one_vertex() {
    let folder = Folder::new();
    let mut shape = cuboid([0.0; 3], [1.0; 3]);
    let text = stl_ascii(&shape).replacen("vertex 0e0", "vertex -0e0", 5);
    let mesh = folder.mesh("a.stl", text);
    assert_eq!(mesh.positions.len(), 8);
    assert!(mesh.is_closed());
    // Two solids in one file, in capitals, without names.
    let text = stl_ascii(&shape).replace(" shape of a test", "").to_uppercase();
    let twice = folder.mesh("a.stl", text.repeat(2));
    assert_eq!((twice.triangles.len(), twice.positions.len()), (24, 8));
    shape.positions[7][0] += f32::EPSILON;
    shape.triangles.push([7, 6, 5]);
    assert_eq!(folder.mesh("a.stl", stl_binary(b"", &shape)).positions.len(), 8);
}

#[test]
fn normals_against_the_order_of_corners_are_told() {
    let text = stl_ascii(&cuboid([0.0; 3], [1.0; 3]));
    let folder = Folder::new();
    // The first facet looks down, and so do the two that follow it, at right angles to the rest.
    let up = folder.mesh("a.stl", text.replace("normal 0 0 0", "normal 0 0 1"));
    assert_eq!(
        up.source.assumptions.facts(),
        ["2 normals point against the order of their triangles' corners, which was followed"]
    );
    assert!(folder.mesh("a.stl", text.replace("normal 0 0 0", "normal nan nan nan")).source.assumptions.is_empty());
}

#[test]
fn what_follows_and_attributes_are_told() {
    let mut file = stl_binary(b"", &cuboid([0.0; 3], [1.0; 3]));
    file[84 + 48] = 31;
    file.extend([1, 2, 3]);
    let mesh = Folder::new().mesh("a.stl", file);
    assert_eq!(
        mesh.source.assumptions.facts(),
        [
            "3 bytes behind the last triangle were left unread",
            "the attributes of 1 triangles, perhaps colours, were left out"
        ]
    );
}

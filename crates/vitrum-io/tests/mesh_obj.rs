//! OBJ and MTL: statements beyond vertices and triangles.

mod common;

use common::Folder;
use vitrum_io::{Material, srgb_to_linear};

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn corners_in_every_form() {
    let folder = Folder::new();
    let plain = folder.mesh("a.obj", format!("{SQUARE}f 1 2 3\nf 1 3 4\n"));
    for faces in [
        "f 1 2 3\nf -4 -2 -1\n",
        "vt 0 0\nf 1/1 2/1 3/-1\nf 1/1 3/1 4/1\n",
        "f 1 2 3 # a comment\r\nf 1 \\\n3 \\\r\n4\n",
        "f 1 2 3 4\n",
        "o x\ng y z\ns 1\nf 1 2 3\ns off\nf 1 3 4",
        "vn 0 0 1\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n",
        "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\n",
    ] {
        let mesh = folder.mesh("b.obj", format!("{SQUARE}{faces}"));
        assert_eq!((&mesh.positions, &mesh.triangles), (&plain.positions, &plain.triangles), "{faces}");
        assert_eq!(mesh.normals, faces.contains("vn").then(|| vec![[0.0, 0.0, 1.0]; 4]), "{faces}");
        assert!(mesh.source.assumptions.is_empty(), "{:?}", mesh.source.assumptions);
    }
    // Faces may stand before the vertices that they name.
    assert_eq!(folder.mesh("b.obj", format!("f 1 2 3\nf 1 3 4\n{SQUARE}")).triangles, plain.triangles);
}

#[test]
fn polygons_that_are_not_convex_keep_their_area() {
    // An L of area 3, its first corner the hardest for a fan.
    let corners = "v 1 1 5\nv 1 2 5\nv 0 2 5\nv 0 0 5\nv 2 0 5\nv 2 1 5\n";
    let mesh = Folder::new().mesh("a.obj", format!("{corners}f 1 2 3 4 5 6\n"));
    assert_eq!((mesh.triangles.len(), mesh.surface_area()), (4, 3.0));
    let crossing = Folder::new().mesh("a.obj", format!("{SQUARE}v 0 1.5 0\nf 1 3 2 5\n"));
    assert!(
        crossing.source.assumptions[0].fact.contains("1 polygons cross themselves"),
        "{:?}",
        crossing.source.assumptions
    );
}

#[test]
fn creases_double_vertices_and_leave_the_surface_whole() {
    // A tetrahedron, each face with a normal of its own.
    let mesh = Folder::new().mesh(
        "a.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 -2\nvn 0 -1 0\nvn -1 0 0\nvn 1 1 1\n\
         f 1//1 3//1 2//1\nf 1//2 2//2 4//2\nf 1//3 4//3 3//3\nf 2//4 3//4 4//4\n",
    );
    assert_eq!((mesh.positions.len(), mesh.topology().points), (12, 4));
    assert!(mesh.is_closed());
    assert_eq!(mesh.source.assumptions.facts(), ["vertices with several normals were doubled: 4 became 12"]);
    let normals = mesh.normals.unwrap();
    for (index, triangle) in mesh.triangles.iter().enumerate() {
        let expected = [[0.0, 0.0, -1.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [(1.0_f32 / 3.0).sqrt(); 3]][index];
        for vertex in triangle {
            assert_eq!(normals[*vertex as usize], expected);
        }
    }
}

#[test]
fn corners_without_a_normal_have_none() {
    let mesh = Folder::new().mesh("a.obj", format!("{SQUARE}vn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n"));
    assert_eq!(mesh.positions.len(), 6);
    assert_eq!(mesh.normals.unwrap()[3..], [[0.0; 3]; 3]);
}

#[test]
fn colours_of_vertices() {
    let mesh = Folder::new().mesh("a.obj", "v 0 0 0\nv 1 0 0 0.5 0 1\nv 1 1 0 1 1 1 0.25\nv 0 0 0 1\nf 1 2 3\n");
    let half = srgb_to_linear(0.5);
    assert_eq!(mesh.colors.unwrap(), [[1.0; 4], [half, 0.0, 1.0, 1.0], [1.0, 1.0, 1.0, 0.25], [1.0; 4]]);
    assert_eq!(mesh.source.assumptions.facts(), ["the colours of vertices were taken for sRGB, and decoded"]);
}

#[test]
fn materials_of_mtl() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("below")).unwrap();
    folder.write(
        "below/a b.mtl",
        "# a comment\r\nnewmtl glass\r\nKd 0.5 0.25 1\r\nNi 1.5\r\nd 0.1\r\nTr 0.3\r\nTf 0.9 1 0.8\r\nPr 0.2\r\n\
         illum 2\r\nmap_Kd a.png\r\nnewmtl stone wall\r\nKd 0.5\r\nTr 0.25\r\nNi -1\r\nKs spectral a.rfl\r\n",
    );
    let text = format!(
        "mtllib .\\below\\a b.mtl\n{SQUARE}f 1 2 3\nusemtl glass\nf 1 3 4\nf 2 3 4\nusemtl stone wall\nf 1 2 4\n\
         usemtl glass\nf 1 2 3\nusemtl ghost\nf 1 2 3\n"
    );
    let mesh = folder.mesh("a.obj", text);
    let named = |name: &str| Material { name: name.to_owned(), ..Material::default() };
    let glass = Material {
        base_color: Some([0.5, 0.25, 1.0]),
        opacity: Some(0.1),
        index_of_refraction: Some(1.5),
        attenuation_color: Some([0.9, 1.0, 0.8]),
        roughness: Some(0.2),
        ..named("glass")
    };
    let stone = Material { base_color: Some([0.5; 3]), opacity: Some(0.75), ..named("stone wall") };
    assert_eq!(mesh.materials, [named(""), glass, stone, named("ghost")]);
    assert_eq!(mesh.triangle_materials, [0, 1, 1, 2, 1, 3]);
    assert_eq!(
        mesh.source.assumptions.facts(),
        [
            "a b.mtl, line 14: `Ni -1` is out of range, and was left out",
            "the textures of a b.mtl were left out",
            "materials that no file describes: `ghost`",
        ]
    );
}

#[test]
fn a_missing_mtl_file_is_told() {
    let mesh = Folder::new().mesh("a.obj", format!("mtllib no.mtl\nmtllib no.mtl\n{SQUARE}usemtl x\nf 1 2 3\n"));
    assert_eq!(mesh.materials.len(), 1);
    assert_eq!(mesh.source.assumptions.facts(), ["the file `no.mtl` is missing: its materials have a name alone"]);
    let folder = Folder::new();
    folder.write("a.mtl", "newmtl x\nd 0.5\n");
    folder.write("b.mtl", "newmtl y\nd 0.25\n");
    let mesh = folder.mesh("a.obj", format!("mtllib a.mtl b.mtl\n{SQUARE}usemtl y\nf 1 2 3\n"));
    assert_eq!(mesh.materials[0].opacity, Some(0.25));
}

#[test]
fn what_makes_no_triangle_is_told() {
    let mesh = Folder::new().mesh("a.obj", format!("{SQUARE}v 9 9 9 0.5\nl 1 2\np 1\nvp 1 2\nf 1 2 3\n"));
    assert_eq!(
        mesh.source.assumptions.facts(),
        [
            "the weights of 1 vertices, which are for curves, were left out",
            "statements that make no triangles were left out: `l`, `p`, `vp`",
        ]
    );
    assert_eq!(mesh.bounds(), [[0.0; 3], [1.0, 1.0, 0.0]], "vertices that no triangle uses count for nothing");
}

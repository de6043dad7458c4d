//! glTF: nodes, primitives, accessors, buffers and materials.

mod common;

use common::Folder;
use common::mesh::{changed_glb, cuboid, glb, gltf};
use vitrum_io::{Material, Mesh};

fn changed(changes: &[(&str, &str)]) -> Mesh {
    Folder::new().mesh("a.glb", changed_glb(changes))
}

/// Replaces the only node.
fn nodes(nodes: &str) -> Mesh {
    changed(&[(r#""nodes":[{"mesh":0}]"#, &format!(r#""nodes":[{nodes}]"#))])
}

#[test]
fn nodes_place_meshes() {
    let plain = nodes(r#"{"mesh":0}"#);
    assert_eq!((plain.bounds(), plain.signed_volume()), ([[0.0; 3], [1.0; 3]], 1.0));
    for (node, low, high) in [
        (r#"{"mesh":0,"translation":[1,2,3]}"#, [1.0, 2.0, 3.0], [2.0, 3.0, 4.0]),
        (r#"{"mesh":0,"scale":[2,3,4],"translation":[1,0,0]}"#, [1.0, 0.0, 0.0], [3.0, 3.0, 4.0]),
        // A quarter turn about z, then the scale's axes: x becomes y.
        (
            r#"{"mesh":0,"rotation":[0,0,0.70710678118654752,0.70710678118654752],"scale":[2,1,1]}"#,
            [-1.0, 0.0, 0.0],
            [0.0, 2.0, 1.0],
        ),
        (r#"{"mesh":0,"matrix":[0,2,0,0, -1,0,0,0, 0,0,1,0, 5,0,0,1]}"#, [4.0, 0.0, 0.0], [5.0, 2.0, 1.0]),
        (r#"{"children":[1],"scale":[2,2,2]},{"mesh":0,"translation":[1,0,0]}"#, [2.0, 0.0, 0.0], [4.0, 2.0, 2.0]),
        // Mirrored, and still not inside out.
        (r#"{"mesh":0,"scale":[-1,1,1]}"#, [-1.0, 0.0, 0.0], [0.0, 1.0, 1.0]),
        (r#"{"mesh":0,"scale":[-1,-1,-1]}"#, [-1.0; 3], [0.0; 3]),
    ] {
        let mesh = nodes(node);
        let volume: f32 = (0..3).map(|axis| high[axis] - low[axis]).product();
        for (found, expected) in mesh.bounds().as_flattened().iter().zip([low, high].as_flattened()) {
            assert!((found - expected).abs() < 1e-6, "{node}: {:?}", mesh.bounds());
        }
        assert!((mesh.signed_volume() - f64::from(volume)).abs() < 1e-6, "{node}");
        assert!(mesh.is_closed(), "{node}");
    }
}

#[test]
fn a_mesh_may_stand_in_several_places() {
    let three =
        nodes(r#"{"children":[1,2,3]},{"mesh":0},{"mesh":0,"translation":[5,0,0]},{"mesh":0,"scale":[1,-2,1]}"#);
    assert_eq!((three.triangles.len(), three.topology().parts), (36, 2));
    assert!((three.signed_volume() - 4.0).abs() < 1e-12);
    // Nodes outside of the scene are not there.
    assert_eq!(nodes(r#"{"mesh":0},{"mesh":0,"translation":[5,0,0]}"#).triangles.len(), 12);
    let scenes = [
        (r#""scene":0,"#, r#""scene":1,"#),
        (r#""scenes":[{"nodes":[0]}]"#, r#""scenes":[{},{"nodes":[0,1]}]"#),
        (r#"{"mesh":0}"#, r#"{"mesh":0},{"mesh":0,"translation":[5,0,0]}"#),
    ];
    let second = changed(&scenes);
    assert_eq!(second.triangles.len(), 24);
    assert_eq!(second.source.assumptions.facts(), ["of 2 scenes, number 1, counted from 0, was read"]);
    let without = changed(&[(r#""scene":0,"scenes":[{"nodes":[0]}],"#, "")]);
    assert_eq!(without.source.assumptions.facts(), ["there are no scenes: all nodes were read"]);
    let bare = changed(&[(r#""scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"#, "")]);
    assert_eq!(bare.source.assumptions.facts(), ["there are no scenes and nodes: each mesh was read once"]);
    assert_eq!((without.triangles.len(), bare.triangles.len()), (12, 12));
}

/// A mesh of the corners (0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0) without indices.
fn ladder(mode: u32, count: usize) -> Mesh {
    let positions = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 2.0, 0.0]];
    let data: Vec<u8> = positions[..count].iter().flatten().flat_map(|value| value.to_le_bytes()).collect();
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"mode":{mode}}},{{"attributes":{{"POSITION":0}},"mode":1}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":{count},"type":"VEC3"}}],
"bufferViews":[{{"buffer":0,"byteLength":{0}}}],"buffers":[{{"byteLength":{0}}}]}}"#,
        data.len()
    );
    Folder::new().mesh("a.glb", glb(&json, &data))
}

#[test]
fn triangles_strips_and_fans() {
    assert_eq!(ladder(4, 3).triangles, [[0, 1, 2]]);
    assert_eq!(ladder(5, 5).triangles, [[0, 1, 2], [1, 3, 2], [2, 3, 4]]);
    assert_eq!(ladder(6, 5).triangles, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    let note = "1 primitives that are points, lines or without positions were left out";
    assert!(ladder(4, 3).source.assumptions.facts().contains(&note));
}

#[test]
fn sparse_accessors_change_single_elements() {
    let shape = cuboid([0.0; 3], [1.0; 3]);
    let (json, mut data) = gltf(&shape);
    let start = data.len();
    // Vertex 7, at (1, 1, 1), to (3, 3, 3).
    data.extend([7, 0, 0, 0]);
    data.extend([3.0_f32; 3].iter().flat_map(|value| value.to_le_bytes()));
    let sparse = r#""sparse":{"count":1,"indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3}},"#;
    let json = json.replace("URI", "").replace(r#""count":8"#, &format!(r#"{sparse}"count":8"#)).replace(
        r#"],
"buffers":[{"byteLength":240}"#,
        &format!(
            r#",{{"buffer":0,"byteOffset":{start},"byteLength":1}},{{"buffer":0,"byteOffset":{},"byteLength":12}}],
"buffers":[{{"byteLength":{}}}"#,
            start + 4,
            data.len()
        ),
    );
    let mesh = Folder::new().mesh("a.glb", glb(&json, &data));
    let mut expected = shape.positions;
    expected[7] = [3.0; 3];
    assert_eq!(mesh.positions, expected);
    // Without a view the rest is zeros.
    let zeros = json.replace(r#"{"bufferView":0,"componentType":5126"#, r#"{"componentType":5126"#);
    assert_eq!(Folder::new().mesh("a.glb", glb(&zeros, &data)).bounds(), [[0.0; 3], [3.0; 3]]);
}

#[test]
fn buffers_in_files_below() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("with space")).unwrap();
    let (json, data) = gltf(&cuboid([0.0; 3], [1.0; 3]));
    folder.write("with space/ä.bin", &data);
    let mesh = folder.mesh("a.gltf", json.replace("URI", r#""uri":"with%20space/%C3%A4.bin","#));
    assert_eq!(mesh.signed_volume(), 1.0);
    assert_eq!(mesh.source.encoding, "JSON and buffers, little-endian");
}

/// A triangle whose vertices have positions as 16-bit integers, a normal and a colour, at a stride of 20 bytes.
#[test]
fn attributes_of_every_type() {
    let mut data = Vec::new();
    for vertex in 0..3_i16 {
        for coordinate in [vertex % 2, vertex / 2, -vertex] {
            data.extend((16384 * coordinate.clamp(-1, 1)).to_le_bytes());
        }
        data.extend([0; 2]);
        data.extend([0, 0, 127, 0]);
        data.extend([255_u8, 51, 0, 102]);
        data.extend([0; 4]);
    }
    let json = r#"{"asset":{"version":"2.0"},"extensionsRequired":["KHR_mesh_quantization"],
"nodes":[{"mesh":0,"scale":[2,2,2],"rotation":[1,0,0,0]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"COLOR_0":2}}]}],
"accessors":[{"bufferView":0,"componentType":5122,"normalized":true,"count":3,"type":"VEC3"},
{"bufferView":0,"byteOffset":8,"componentType":5120,"normalized":true,"count":3,"type":"VEC3"},
{"bufferView":0,"byteOffset":12,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"}],
"bufferViews":[{"buffer":0,"byteLength":60,"byteStride":20}],"buffers":[{"byteLength":60}]}"#;
    let mesh = Folder::new().mesh("a.glb", glb(json, &data));
    // 16384 of 32767, twice; half a turn about x.
    let one = (16384.0_f32 / 32767.0) * 2.0;
    assert_eq!(mesh.positions, [[0.0; 3], [one, 0.0, one], [0.0, -one, one]]);
    assert_eq!(mesh.normals.unwrap(), [[0.0, 0.0, -1.0]; 3]);
    assert_eq!(mesh.colors.unwrap(), [[1.0, 0.2, 0.0, 0.4]; 3]);
}

#[test]
fn normals_under_uneven_scales_and_mirrors() {
    let mut data: Vec<u8> = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, -1.0], [0.0, 1.0, 0.0]]
        .as_flattened()
        .iter()
        .flat_map(|value| value.to_le_bytes())
        .collect();
    data.extend([1.0_f32, 0.0, 1.0].repeat(3).iter().flat_map(|value| value.to_le_bytes()));
    let json = r#"{"asset":{"version":"2.0"},"nodes":[{"mesh":0,"scale":[2,1,1]},{"mesh":0,"scale":[2,1,-1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":72}],"buffers":[{"byteLength":72}]}"#;
    let mesh = Folder::new().mesh("a.glb", glb(json, &data));
    // Still at a right angle to the triangle, and on the side that its corners turn left about.
    let length = 1.25_f32.sqrt();
    let expected = [[0.5 / length, 0.0, 1.0 / length], [0.5 / length, 0.0, -1.0 / length]];
    for (index, normal) in mesh.normals.unwrap().into_iter().enumerate() {
        for (found, expected) in normal.into_iter().zip(expected[index / 3]) {
            assert!((found - expected).abs() < 1e-6, "{normal:?}");
        }
    }
    assert_eq!(mesh.triangles, [[0, 1, 2], [3, 5, 4]]);
}

#[test]
fn materials_and_their_extensions() {
    let materials = r#""asset":{"version":"2.0"},"materials":[{"name":"glass","pbrMetallicRoughness":{
"baseColorFactor":[0.5,0.25,1,0.5],"roughnessFactor":0.1},"alphaMode":"BLEND","extensions":{
"KHR_materials_transmission":{"transmissionFactor":0.9},"KHR_materials_ior":{"ior":1.33},
"KHR_materials_volume":{"thicknessFactor":1,"attenuationDistance":2,"attenuationColor":[0.5,1,1]}}},{},
{"extensions":{"KHR_materials_ior":{},"KHR_materials_volume":{"attenuationColor":[0,1,1]}}}],
"textures":[{"source":0}],"skins":[{}]"#;
    let primitive = r#"{"attributes":{"POSITION":0},"indices":1"#;
    let primitives = format!(
        r#"{primitive},"material":0}},{primitive}}},{primitive},"material":2}},{primitive},"material":0,"targets":[{{}}]"#
    );
    let mesh = changed(&[(r#""asset":{"version":"2.0"}"#, materials), (primitive, &primitives)]);
    let glass = Material {
        name: "glass".to_owned(),
        base_color: Some([0.5, 0.25, 1.0]),
        opacity: Some(0.5),
        transmission: Some(0.9),
        index_of_refraction: Some(1.33),
        attenuation_color: Some([0.5, 1.0, 1.0]),
        attenuation_distance: Some(2.0),
        roughness: Some(0.1),
    };
    let default =
        Material { base_color: Some([1.0; 3]), opacity: Some(1.0), roughness: Some(1.0), ..Material::default() };
    let third = Material { index_of_refraction: Some(1.5), ..default.clone() };
    assert_eq!(mesh.materials, [glass, default, third]);
    let expected = [0, 1, 2, 0].iter().flat_map(|material| [*material; 12]).collect::<Vec<u32>>();
    assert_eq!(mesh.triangle_materials, expected);
    let notes = ["textures", "skins", "morph targets"]
        .map(|what| format!("{what} were left out: meshes are as they are stored"));
    assert_eq!(mesh.source.assumptions.facts(), notes);
}

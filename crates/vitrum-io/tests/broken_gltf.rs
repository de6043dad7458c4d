//! glTF files with one thing wrong each, and the part of the message that says so.

mod common;

use common::mesh::{changed_glb, cuboid, glb, gltf, refuse};

#[test]
fn broken_gltf_json() {
    let glb = |from: &str, to: &str| changed_glb(&[(from, to)]);
    let nodes = |nodes: &str| glb(r#""nodes":[{"mesh":0}]"#, &format!(r#""nodes":[{nodes}]"#));
    let deep = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
    refuse(
        "broken.glb",
        vec![
            (b"{\"asset\":".to_vec(), "this is not the JSON of glTF: EOF while parsing a value at line 1 column 9"),
            (format!("{{\"asset\":{deep}}}").into_bytes(), "this is not the JSON of glTF: "),
            (
                b"{\"asset\":{\"version\":\"\xff\"}}".to_vec(),
                "this is not the JSON of glTF: invalid unicode code point",
            ),
            (b"{}".to_vec(), "missing field `asset`"),
            (b"{\"asset\":{\"version\":\"2.0\"}}".to_vec(), "there are no triangles"),
            (glb(r#""version":"2.0""#, r#""version":"1.0""#), "glTF of version `1.0`, and only 2.0 is read"),
            (
                glb(r#""scene":0"#, r#""extensionsRequired":["KHR_draco_mesh_compression"]"#),
                "`KHR_draco_mesh_compression`",
            ),
            (glb(r#""scene":0"#, r#""scene":3"#), "scene is 3, and there are 1 scenes, counted from 0"),
            (glb(r#"{"nodes":[0]}"#, r#"{"nodes":[7]}"#), "a node of scenes[0] is 7, and there are 1 nodes"),
            (nodes(r#"{"mesh":5}"#), "nodes[0].mesh is 5, and there are 1 meshes"),
            (nodes(r#"{"mesh":-1}"#), "this is not the JSON of glTF: invalid value: integer `-1`"),
            (nodes(r#"{"children":[0]}"#), "nodes[0] is reached twice: it is its own ancestor"),
            (nodes(r#"{"children":[1]},{"children":[2]},{"children":[1]}"#), "nodes[1] is reached twice"),
            (nodes(r#"{"children":[1,2]},{"children":[3]},{"children":[3]},{"mesh":0}"#), "nodes[3] is reached twice"),
            (nodes(r#"{"children":[9]}"#), "a child of nodes[0] is 9, and there are 1 nodes"),
            (nodes(r#"{"mesh":0,"matrix":[1,2,3]}"#), "invalid length 3, expected an array of length 16"),
            (nodes(r#"{"mesh":0,"scale":[1e200,1,1]}"#), "vertex 1: (inf, 0, 0)"),
            (
                changed_glb(&[
                    (r#""scene":0,"scenes":[{"nodes":[0]}],"#, ""),
                    (r#"{"mesh":0}"#, r#"{"children":[0]}"#),
                ]),
                "each node is the child of another",
            ),
            (
                glb(r#""indices":1"#, r#""indices":9"#),
                "meshes[0].primitives[0].indices is 9, and there are 2 accessors",
            ),
            (glb(r#""indices":1"#, r#""indices":0"#), "accessors[0] is `VEC3`, not SCALAR"),
            (glb(r#""indices":1"#, r#""mode":9"#), "meshes[0].primitives[0].mode is 9, not 0 to 6"),
            (glb(r#""indices":1"#, r#""mode":4"#), "has 8 corners, which do not make triangles"),
            (glb(r#""POSITION":0"#, r#""NORMAL":0"#), "there are no triangles"),
            (glb(r#""scene":0"#, r#""materials":{}"#), "this is not the JSON of glTF: invalid type: map"),
        ],
    );
}

#[test]
fn broken_gltf_numbers() {
    let glb_of = |from: &str, to: &str| changed_glb(&[(from, to)]);
    let (json, data) = gltf(&cuboid([0.0; 3], [1.0; 3]));
    let whole = glb(&json.replace("URI", ""), &data);
    let mut index = data.clone();
    index[96] = 8;
    let mut nan = data.clone();
    nan[..4].copy_from_slice(&f32::NAN.to_le_bytes());
    let mut long = whole.clone();
    long[12..16].copy_from_slice(&u32::MAX.to_le_bytes());
    let uri = |uri: &str| json.replace("URI", &format!("\"uri\":\"{uri}\",")).into_bytes();
    let sparse = |sparse: &str| glb_of(r#""count":8,"#, &format!(r#""count":8,"sparse":{{{sparse}}},"#));
    let indices = r#""indices":{"bufferView":1,"componentType":5121}"#;
    refuse(
        "broken.glb",
        vec![
            (glb(&json.replace("URI", ""), &index), "names vertex 8, counted from 0, and there are 8"),
            (glb(&json.replace("URI", ""), &nan), "vertex 0: (NaN, NaN, NaN) is the first"),
            (glb_of(r#""count":8"#, r#""count":1000000000"#), "accessors[0] needs 12000000000 bytes of bufferViews[0]"),
            (glb_of(r#""count":8"#, r#""count":0"#), "accessors[0] has 0 elements, not 1 to 4294967295"),
            (glb_of(r#""count":8"#, r#""count":-8"#), "invalid value: integer `-8`"),
            (glb_of(r#""count":8"#, r#""byteOffset":18446744073709551615,"count":8"#), "bytes of bufferViews[0]"),
            (glb_of(r#""componentType":5125"#, r#""componentType":5124"#), "accessors[1] has the unknown type 5124"),
            (glb_of(r#""componentType":5125"#, r#""componentType":5122"#), "indices of no unsigned type"),
            (glb_of(r#"{"bufferView":0,"#, r#"{"bufferView":4,"#), "accessors[0].bufferView is 4, and there are 2"),
            (glb_of(r#"{"bufferView":0,"#, "{"), "accessors[0] has neither `bufferView` nor `sparse`"),
            (glb_of(r#"{"buffer":0,"byteLength":96"#, r#"{"buffer":3,"byteLength":96"#), "bufferViews[0].buffer is 3"),
            (
                glb_of(r#""byteOffset":96"#, r#""byteOffset":18446744073709551615"#),
                "bufferViews[1] ends at byte 18446744073709551615 of a buffer of 240 bytes",
            ),
            (glb_of(r#""byteLength":96}"#, r#""byteLength":96,"byteStride":4}"#), "bufferViews[0].byteStride is 4"),
            (glb_of(r#""byteLength":240"#, r#""byteLength":1000000000"#), "buffers[0] promises 1000000000 bytes, 240"),
            (
                sparse(&format!(r#""count":99,{indices},"values":{{"bufferView":0}}"#)),
                "promises 99 values, and 96 bytes",
            ),
            (sparse(&format!(r#""count":-1,{indices},"values":{{"bufferView":0}}"#)), "invalid value: integer `-1`"),
            (
                sparse(
                    r#""count":1,"indices":{"bufferView":0,"byteOffset":15,"componentType":5121},"values":{"bufferView":0}"#,
                ),
                "accessors[0].sparse names element 63 of 8",
            ),
            (
                sparse(r#""count":1,"indices":{"bufferView":1},"values":{"bufferView":0}"#),
                "indices of no unsigned type",
            ),
            (whole[..100].to_vec(), "byte 8: the header promises"),
            (whole[..7].to_vec(), "byte 8: the header promises 12 bytes, 7 are there"),
            (long, "byte 12: a chunk that ends behind the file's"),
            ([&whole[..4], &[1], &whole[5..]].concat(), "byte 4: GLB of version 1, and only 2 is read"),
            (uri("../a.bin"), "the data file `../a.bin` is not below the header"),
            (uri("%2e%2e/a.bin"), "the data file `../a.bin` is not below the header"),
            (uri("/etc/passwd"), "is not below the header"),
            (uri("a.bin"), "the data file `a.bin` cannot be read"),
            (uri("%ff"), "buffers[0].uri is `%ff`, not UTF-8"),
            (uri("https://example.org/a.bin"), "nothing is fetched from elsewhere"),
            (uri("data:text/plain,hello"), "embeds data that is not base64"),
            (uri("data:;base64,AA*A"), "holds damaged base64"),
            (uri("data:;base64,AAAA"), "buffers[0] promises 240 bytes, 3 are there"),
        ],
    );
}

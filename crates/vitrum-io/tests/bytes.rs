//! Bytes in memory are read as the file that holds them is, and pictures are encoded into memory as they are written.

mod common;
#[path = "readers/seeds.rs"]
mod seeds;

use std::fs;

use common::mesh::{files, globe};
use common::{Folder, NiftiHeader, attached, gzip, metaimage, nrrd};
use vitrum_io::{
    Error, OpenOptions, Picture, PictureFormat, WriteOptions, encode_picture, open, open_bytes, open_mesh,
    open_mesh_bytes, read_picture, read_picture_bytes, write_picture_with,
};

/// The words of the error about a file that lies beside the bytes.
const ALONE: &str = "the bytes of this one alone were given";

/// A file of each volume format, as its seeds for fuzzing have it, under a name of the format.
const VOLUMES: [(&str, &str); 9] = [
    ("nrrd", "a.nrrd"),
    ("nifti", "a.nii"),
    ("metaimage", "a.mha"),
    ("numpy", "a.npy"),
    ("npz", "a.npz"),
    ("vti", "a.vti"),
    ("vtk", "a.vtk"),
    ("stack", "a.tif"),
    ("dicom", "a.dcm"),
];

#[test]
fn volumes_are_those_of_their_files() {
    let options = OpenOptions::default();
    for (target, name) in VOLUMES {
        let mut read = 0;
        for content in seeds::seeds(target) {
            for (name, content) in [(name.to_owned(), content.clone()), (format!("{name}.gz"), gzip(&content))] {
                // A folder each: nothing lies beside the file.
                let folder = Folder::new();
                let path = folder.write(&name, &content);
                let shown = folder.shown(&name);
                match (open(&path, &options), open_bytes(&shown, &content, &options)) {
                    (Ok(of_file), Ok(of_bytes)) => {
                        assert_eq!(of_bytes, of_file, "{target}");
                        read += 1;
                    }
                    (of_file, of_bytes) => {
                        let [of_file, of_bytes] = [of_file, of_bytes].map(|outcome| outcome.unwrap_err().to_string());
                        assert!(of_bytes.contains(ALONE) || of_bytes == of_file, "{target}: {of_bytes}; {of_file}");
                    }
                }
            }
        }
        assert!(read >= 2, "{target}");
    }
    let voxels = open_bytes("a_3x2x2_uint8.raw", &[7; 12], &options).unwrap();
    assert_eq!((voxels.dimensions, voxels.range), ([3, 2, 2], [7.0; 2]));
}

#[test]
fn meshes_are_those_of_their_files() {
    let options = OpenOptions::default();
    for (name, content) in files(&globe(1.5, 7, 5)) {
        for (name, content) in [(name.to_owned(), content.clone()), (format!("{name}.gz"), gzip(&content))] {
            let folder = Folder::new();
            let of_file = open_mesh(&folder.write(&name, &content), &options).unwrap();
            assert_eq!(open_mesh_bytes(&folder.shown(&name), &content, &options).unwrap(), of_file);
        }
    }
}

#[test]
fn data_in_other_files_is_refused_by_name_even_where_they_are_there() {
    let folder = Folder::new();
    folder.write("data.raw", [1; 12]);
    folder.write("a.img", NiftiHeader::new(2, 1, false).with(&[1; 12]));
    let refused = |name: &str, content: &[u8]| match open_bytes(&folder.shown(name), content, &OpenOptions::default()) {
        Err(Error::Unsupported { problem, .. }) => assert!(problem.contains(ALONE), "{problem}"),
        other => panic!("{other:?}"),
    };
    refused("a.nhdr", nrrd("uint8", "raw", "data file: data.raw\n").as_bytes());
    refused("a.mhd", metaimage("MET_UCHAR", "", "data.raw").as_bytes());
    refused("a.hdr", &NiftiHeader::new(2, 1, false).pair().bytes);
    let gltf = r#"{"asset":{"version":"2.0"},"buffers":[{"byteLength":12,"uri":"data.raw"}],
        "bufferViews":[{"buffer":0,"byteLength":12}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"VEC3"}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]}"#;
    let error = open_mesh_bytes(&folder.shown("a.gltf"), gltf.as_bytes(), &OpenOptions::default()).unwrap_err();
    assert!(error.to_string().contains("`data.raw`") && error.to_string().contains(ALONE), "{error}");
    folder.write("a.mtl", "newmtl a\nKd 1 0 0\n");
    let obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    let mesh = open_mesh_bytes(&folder.shown("a.obj"), obj.as_bytes(), &OpenOptions::default()).unwrap();
    assert_eq!((mesh.materials[0].name.as_str(), mesh.materials[0].base_color), ("a", None));
    assert!(mesh.source.assumptions[0].fact.contains("lies beside the mesh"), "{:?}", mesh.source.assumptions);
}

#[test]
fn bytes_are_limited_as_files_are() {
    let content = gzip(&attached(&nrrd("uint8", "raw", ""), &[1; 12]));
    let options = OpenOptions { max_bytes: Some(20), ..OpenOptions::default() };
    assert!(matches!(open_bytes("a.nrrd.gz", &content, &options), Err(Error::TooLarge { limit: 20, .. })));
    // A name that is a folder's says nothing about bytes, not even about none.
    let folder = Folder::new();
    folder.write("a.tif", [0; 12]);
    let error = open_bytes(&folder.path("").to_string_lossy(), &[], &OpenOptions::default()).unwrap_err();
    assert!(error.to_string().contains("neither the content nor the extension"), "{error}");
}

#[test]
fn pictures_are_encoded_as_they_are_written_and_read_as_their_files_are() {
    let folder = Folder::new();
    let picture = Picture::rgb(2, 3, (0..6).map(|index| [index as f32 / 5.0, 0.5, 1.0]).collect());
    let metadata = [("Software".to_owned(), "a test".to_owned())];
    let options = WriteOptions { png_bits: 16, jpeg_quality: 50 };
    for format in PictureFormat::ALL {
        let name = format!("a{}", format.format().extensions[0]);
        let path = folder.path(&name);
        assert_eq!(PictureFormat::of_path(&path).unwrap(), format);
        write_picture_with(&path, &picture, &metadata, &options).unwrap();
        let bytes = encode_picture(&picture, format, &metadata, &options).unwrap();
        assert_eq!(bytes, fs::read(&path).unwrap(), "{name}");
        let read = read_picture_bytes(&name, &bytes, &OpenOptions::default()).unwrap();
        assert_eq!(read, read_picture(&path).unwrap(), "{name}");
    }
    let error = encode_picture(&Picture::rgb(0, 0, Vec::new()), PictureFormat::Png, &[], &options).unwrap_err();
    assert!(error.to_string().starts_with("PNG picture: cannot be written: 0 x 0 pixels"), "{error}");
    let error = read_picture_bytes("a.png", b"no picture", &OpenOptions::default()).unwrap_err();
    assert!(error.to_string().starts_with("a.png: "), "{error}");
}

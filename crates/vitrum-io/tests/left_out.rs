//! A file of a format that a build leaves out is told by the format's name and its feature. With all features there is none;
//! `cargo xtask features` runs this without any.

use std::fs;

use vitrum_io::{
    Error, Format, MESH_FORMATS, OpenOptions, PICTURE_FORMATS, Picture, PictureFormat, VOLUME_FORMATS, WriteOptions,
    check_writable, encode_picture, mesh_readers, open, open_bytes, open_mesh_bytes, read_picture_bytes, readers,
};

fn assert_left_out(error: &Error, expected: &Format) {
    let Error::LeftOut { format, feature, .. } = error else { panic!("{}: {error}", expected.name) };
    assert_eq!((*format, *feature), (expected.name, expected.feature));
    let message = error.to_string();
    assert!(message.contains(expected.name) && message.contains(&format!("`{}`", expected.feature)), "{message}");
}

#[test]
fn a_build_has_the_readers_of_its_features() {
    let included = |formats: &'static [&'static Format]| -> Vec<&'static Format> {
        formats.iter().copied().filter(|format| format.included).collect()
    };
    assert_eq!(readers().iter().map(|reader| reader.format()).collect::<Vec<_>>(), included(VOLUME_FORMATS));
    assert_eq!(mesh_readers().iter().map(|reader| reader.format()).collect::<Vec<_>>(), included(MESH_FORMATS));
}

#[test]
fn volumes_that_are_left_out_are_told() {
    let options = OpenOptions::default();
    for format in VOLUME_FORMATS.iter().filter(|format| !format.included) {
        for extension in format.extensions {
            let name = format!("a{extension}");
            assert_left_out(&open_bytes(&name, b"?", &options).unwrap_err(), format);
        }
    }
    if let Some(nrrd) = VOLUME_FORMATS.iter().find(|format| format.name == "NRRD" && !format.included) {
        // By the content, whatever the name.
        assert_left_out(&open_bytes("a.dat", b"NRRD0004\n", &options).unwrap_err(), nrrd);
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("a.nrrd");
        fs::write(&path, b"NRRD0004\n").expect("a written file");
        assert_left_out(&open(&path, &options).unwrap_err(), nrrd);
    }
    if let Some(raw) = VOLUME_FORMATS.iter().find(|format| format.feature == "raw" && !format.included) {
        let options = OpenOptions { raw: "1x1x1:u8".parse().ok(), ..OpenOptions::default() };
        assert_left_out(&open_bytes("a.dat", b"?", &options).unwrap_err(), raw);
    }
}

#[test]
fn meshes_that_are_left_out_are_told() {
    for format in MESH_FORMATS.iter().filter(|format| !format.included) {
        let name = format!("a{}", format.extensions[0]);
        assert_left_out(&open_mesh_bytes(&name, b"?", &OpenOptions::default()).unwrap_err(), format);
    }
}

#[test]
fn pictures_that_are_left_out_are_told() {
    let heads: [(&str, &[u8]); 5] = [
        ("PNG", b"\x89PNG\r\n\x1a\n"),
        ("OpenEXR", b"\x76\x2f\x31\x01"),
        ("Radiance HDR", b"#?RADIANCE\n"),
        ("JPEG", b"\xff\xd8\xff"),
        ("TIFF", b"II*\0"),
    ];
    let folder = tempfile::tempdir().expect("a temporary folder");
    for format in PictureFormat::ALL {
        let Format { name, extensions, included, .. } = format.format();
        if *included {
            continue;
        }
        let picture = Picture::gray(1, 1, vec![0.5]);
        let error = encode_picture(&picture, format, &[], &WriteOptions::default()).unwrap_err();
        assert_left_out(&error, format.format());
        let path = folder.path().join(format!("a{}", extensions[0]));
        assert_left_out(&check_writable(&path).unwrap_err(), format.format());
        let (_, head) = heads.iter().find(|(head, _)| head == name).expect("the first bytes of each format");
        assert_left_out(&read_picture_bytes("a", head, &OpenOptions::default()).unwrap_err(), format.format());
    }
    assert_eq!(PICTURE_FORMATS.len(), PictureFormat::ALL.len());
}

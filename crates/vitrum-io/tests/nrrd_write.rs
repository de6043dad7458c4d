//! Written NRRD files are read again.

use std::fs;
use std::io::Read;

use vitrum_io::{Lattice, OpenOptions, Samples, Voxels, check_nrrd_writable, open, write_nrrd};

fn lattice() -> Lattice {
    Lattice::of_cubes([3, 2, 2], 0.1, [-1.5, 2.0, 1e-3])
}

#[test]
fn bytes_and_floats_come_back_in_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.nrrd");
    let bytes: Vec<u8> = (0..12).map(|n| n * 20).collect();
    write_nrrd(&path, &lattice(), Samples::U8(&bytes), &[("content", "a test".to_owned())]).unwrap();
    let volume = open(&path, &OpenOptions::default()).unwrap();
    assert_eq!((volume.dimensions, volume.voxels), ([3, 2, 2], Voxels::from(bytes)));
    assert_eq!((volume.spacing, volume.origin), ([0.1; 3], [-1.5, 2.0, 1e-3]));
    assert_eq!(volume.axes, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let floats: Vec<f32> = (0..12).map(|n| n as f32 / 7.0 - 0.5).collect();
    write_nrrd(&path, &lattice(), Samples::F32(&floats), &[]).unwrap();
    assert_eq!(open(&path, &OpenOptions::default()).unwrap().voxels, Voxels::from(floats));
}

#[test]
fn vectors_have_an_axis_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.NRRD");
    let vectors: Vec<[f32; 3]> = (0..12).map(|n| [n as f32, -0.5, 1e-9]).collect();
    write_nrrd(&path, &lattice(), Samples::Vectors(&vectors), &[]).unwrap();
    let file = fs::read(&path).unwrap();
    let end = file.windows(2).position(|pair| pair == b"\n\n").unwrap() + 2;
    let header = String::from_utf8(file[..end].to_vec()).unwrap();
    for line in [
        "sizes: 3 3 2 2",
        "kinds: 3-vector domain domain domain",
        "space directions: none (0.1,0,0) (0,0.1,0) (0,0,0.1)",
    ] {
        assert!(header.lines().any(|found| found == line), "{header}");
    }
    let mut bytes = Vec::new();
    flate2::read::GzDecoder::new(&file[end..]).read_to_end(&mut bytes).unwrap();
    let expected: Vec<u8> = vectors.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect();
    assert_eq!(bytes, expected);
}

#[test]
fn what_cannot_be_written_is_refused_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |name: &str, samples: &[u8], fields: &[(&str, String)], words: &str| {
        let error =
            write_nrrd(&folder.path().join(name), &lattice(), Samples::U8(samples), fields).unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    };
    refused("a.png", &[0; 12], &[], "use the extension .nrrd");
    refused("a.nrrd", &[0; 11], &[], "11 samples for 12 voxels");
    refused("a.nrrd", &[0; 12], &[("content", "a\nb".to_owned())], "line break");
    refused("missing/a.nrrd", &[0; 12], &[], "there is no folder");
    assert!(check_nrrd_writable(&folder.path().join("a.raw")).is_err());
    assert!(check_nrrd_writable(&folder.path().join("a.nrrd")).is_ok());
}

//! NumPy: every type, byte order, index order and version comes back.

mod common;

use common::{Folder, check, npy, npy_with, samples, values};
use vitrum_io::{Error, OpenOptions, Volume, Voxels};

const BYTES: [u8; 12] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11];

fn open(file: Vec<u8>) -> Volume {
    Folder::new().open("a.npy", file).unwrap()
}

#[test]
fn every_type_and_endian_comes_back() {
    let folder = Folder::new();
    for sample in samples() {
        for (order, data) in [('<', &sample.little), ('>', &sample.big)] {
            check(&folder.open("a.npy", npy(&format!("{order}{}", sample.numpy), data)).unwrap(), &sample);
        }
        if sample.size == 1 {
            check(&folder.open("a.npy", npy(&format!("|{}", sample.numpy), &sample.little)).unwrap(), &sample);
        }
    }
}

#[test]
fn halves_of_floats_are_widened() {
    // 1, -2, the largest, the smallest above 0, and the nearest to a third, by their bits.
    let words: [u16; 12] = [0x3c00, 0xc000, 0x7bff, 0x0001, 0x3555, 0, 0, 0, 0, 0, 0, 0x8000];
    let expected = [1.0, -2.0, 65504.0, 1.0 / 16_777_216.0, 1365.0 / 4096.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    for (descr, bytes) in [("<f2", words.map(u16::to_le_bytes)), (">f2", words.map(u16::to_be_bytes))] {
        let volume = open(npy(descr, bytes.as_flattened()));
        assert_eq!(values(&volume), expected);
        assert_eq!((volume.source.sample_type.as_str(), volume.bytes()), ("float16", 48));
    }
}

#[test]
fn truth_is_1() {
    let volume = open(npy("|b1", &[0, 1, 1, 0, 0, 0, 1, 1, 1, 0, 1, 0]));
    assert_eq!(values(&volume), [0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 1.0, 0.0]);
    assert_eq!(volume.source.sample_type, "bool");
}

#[test]
fn every_version_is_read() {
    for version in [(1, 0), (2, 0), (3, 0)] {
        let dictionary = "{'shape': (2, 2, 3), 'fortran_order': False, 'descr': '|u1', 'µ': 'other'}";
        let volume = open(npy_with(version, dictionary, &BYTES));
        assert_eq!(volume.dimensions, [3, 2, 2]);
        assert_eq!(volume.voxels, Voxels::from(BYTES.to_vec()));
    }
}

#[test]
fn the_index_that_changes_fastest_is_x() {
    let file = |order: &str| {
        npy_with((1, 0), &format!("{{'descr': '|u1', 'fortran_order': {order}, 'shape': (4, 3, 1), }}"), &BYTES)
    };
    for (order, dimensions, expected) in [("False", [1, 3, 4], "the last was taken"), ("True", [4, 3, 1], "Fortran")] {
        let volume = open(file(order));
        assert_eq!(volume.dimensions, dimensions);
        assert_eq!(volume.voxels, Voxels::from(BYTES.to_vec()));
        let notes = &volume.source.assumptions;
        assert!(notes.iter().any(|note| note.fact.contains(expected)), "{notes:?}");
    }
}

#[test]
fn an_array_is_centred_with_spacings_of_1() {
    let folder = Folder::new();
    let volume = folder.open("no extension", npy(">u2", &[BYTES, BYTES].concat())).unwrap();
    assert_eq!(volume.spacing, [1.0; 3]);
    assert_eq!(volume.origin, [-1.0, -0.5, -0.5]);
    assert_eq!((volume.source.format, volume.source.encoding.as_str()), ("NumPy", "raw, big-endian"));
    let surplus = open([npy("|u1", &BYTES), vec![0; 5]].concat());
    assert!(surplus.source.assumptions.iter().any(|note| note.fact.contains("5 bytes behind")));
}

#[test]
fn the_limit_is_on_decoded_bytes() {
    let folder = Folder::new();
    let path = folder.write("a.npy", npy("<f8", &[0; 96]));
    let open =
        |max_bytes| vitrum_io::open(&path, &OpenOptions { max_bytes: Some(max_bytes), ..OpenOptions::default() });
    assert_eq!(values(&open(48).unwrap()), [0.0; 12]);
    assert!(matches!(open(47), Err(Error::TooLarge { needed: 48, limit: 47, .. })));
}

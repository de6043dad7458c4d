//! NumPy files with one thing wrong each, and the part of the message that says so.

mod common;

use common::{Folder, npy, npy_with};
use vitrum_io::Error;

const DATA: [u8; 12] = [1; 12];

fn shaped(shape: &str) -> Vec<u8> {
    dictionary(&format!("{{'descr': '|u1', 'fortran_order': False, 'shape': {shape}, }}"))
}

fn dictionary(text: &str) -> Vec<u8> {
    npy_with((1, 0), text, &DATA)
}

#[test]
fn broken_files() {
    let nan: Vec<u8> = [f64::INFINITY; 12].iter().flat_map(|value| value.to_le_bytes()).collect();
    let cases: Vec<(Vec<u8>, &str)> = vec![
        (npy_with((4, 0), "{}", &DATA), "byte 6: format version 4.0 is not one of 1.0, 2.0, 3.0"),
        (npy("|u1", &DATA)[..9].to_vec(), "byte 8: the header is"),
        (npy("|u1", &DATA)[..60].to_vec(), "get the whole file, or write the array anew by numpy.save"),
        (
            b"\x93NUMPY\x02\x00\xff\xff\xff\xff{}".to_vec(),
            "byte 8: the header is 4294967295 bytes long, where 2 are there",
        ),
        (b"\x93NUMPY".to_vec(), "format version 0.0"),
        (dictionary("nothing"), "byte 10: `nothing` is not a dictionary"),
        (dictionary("{'descr': '|u1'"), "is not a dictionary"),
        (dictionary("{'descr': '|u1', 'shape': (2, 2, 3)}"), "the header has no `fortran_order`"),
        (dictionary("{'fortran_order': False, 'shape': (2, 2, 3)}"), "byte 10: the header has no `descr`"),
        (dictionary("{'descr': '|u1', 'fortran_order': False}"), "the header has no `shape`"),
        (
            dictionary("{'descr': '|u1', 'fortran_order': 'no', 'shape': (2, 2, 3)}"),
            "`fortran_order` is neither True nor False",
        ),
        (dictionary("{'descr': '|u1', 'fortran_order': True, 'shape': '3'}"), "`shape` is not a tuple of sizes"),
        (
            dictionary("{'descr': [('a', '<f4')], 'fortran_order': True, 'shape': (2, 2, 3)}"),
            "the samples are records of several fields",
        ),
        (shaped("(4, 3)"), "the array has 2 dimensions, and a scalar volume has 3, or 4 with time; save"),
        (shaped("(12,)"), "the array has 1 dimensions"),
        (shaped("()"), "the array has 0 dimensions"),
        (shaped("(2, 0, 3)"), "the shape [2, 0, 3] has the size 0, not one from 1"),
        (shaped("(2, 99999999999, 3)"), "has the size 99999999999"),
        (shaped("(2, -2, 3)"), "is not a dictionary"),
        (shaped("(3, 2, 3)"), "the header promises 18 bytes of data from here, 12 are there"),
        (shaped("(4294967295, 4294967295, 4294967295)"), "more than any file holds"),
        (
            shaped("(10000, 10000, 10000)"),
            "byte 128: the header promises 1000000000000 bytes of data from here, 12 are",
        ),
        (npy("<f2", &DATA), "byte 128: the header promises 24 bytes of data from here, 12 are there"),
        (npy("<f16", &DATA), "byte 10: the samples are `<f16`, not bool, or integers or floats"),
        (npy("<c8", &DATA), "the samples are `<c8`"),
        (npy("|S1", &DATA), "the samples are `|S1`"),
        (npy("|O", &DATA), "the samples are `|O`"),
        (npy("<µ4", &DATA), "the samples are `<µ4`"),
        (npy("µu1", &DATA), "`µu1` names no byte order"),
        (npy("", &DATA), "the samples are ``"),
        (npy("|u2", &[DATA, DATA].concat()), "`|u2` names no byte order; use < for little-endian"),
        (npy("=u2", &[DATA, DATA].concat()), "`=u2` names no byte order"),
        (npy("<f8", &nan), "all of the 12 voxels are NaN, infinite"),
        (b"PK\x03\x04".to_vec(), "byte 0: this does not start with `\\x93NUMPY`"),
        (b"".to_vec(), "byte 0: this does not start with"),
    ];
    let folder = Folder::new();
    for (content, expected) in cases {
        let error = folder.open("broken.npy", content).expect_err(expected);
        let message = error.to_string();
        assert!(message.starts_with(&folder.shown("broken.npy")), "{message}");
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
        assert!(matches!(error, Error::Invalid { .. } | Error::Unsupported { .. }), "{error:?}");
    }
}

//! Files with one thing wrong each, and the part of the message that says so.

mod common;

use common::{Folder, NiftiHeader, attached, gzip, hex, nifti_u8, nrrd};
use vitrum_io::{Error, OpenOptions, Place};

const DATA: [u8; 12] = [1; 12];

/// A valid uint8 file with one replacement in its header.
fn changed(from: &str, to: &str) -> Vec<u8> {
    let header = nrrd("uint8", "raw", "");
    assert!(header.contains(from), "{from}");
    attached(&header.replace(from, to), &DATA)
}

/// A uint8 header with more lines.
fn with(more: &str) -> Vec<u8> {
    attached(&nrrd("uint8", "raw", more), &DATA)
}

fn encoded(encoding: &str, data: &[u8]) -> Vec<u8> {
    attached(&nrrd("uint8", encoding, ""), data)
}

#[test]
fn broken_nrrd_files() {
    let mut damaged = gzip(&DATA);
    let end = damaged.len() - 6;
    damaged[end] ^= 0xff;
    let huge: Vec<u8> = [1e300_f64; 12].iter().flat_map(|value| value.to_le_bytes()).collect();
    let cases: Vec<(Vec<u8>, &str)> = vec![
        (changed("NRRD0004", "NRRD0009"), "line 1: NRRD version `0009` is not one of 0001 to 0005"),
        (changed("type: uint8\n", ""), "the header has no `type`; add a line such as `type: uint8`"),
        (changed("type: uint8", "type: uint9"), "line 2: `uint9` is not a sample type"),
        (changed("type: uint8", "type: block"), "line 2: `block` samples have no number"),
        (changed("type: uint8", "type uint8"), "line 2: `type uint8` is neither `field: value`"),
        (changed("dimension: 3", "dimension: 5"), "line 3: the data has 5 dimensions"),
        (changed("dimension: 3", "dimension: many"), "line 3: `many` is not a whole number in range"),
        (changed("3 2 2", "3 2"), "line 4: `3 2` is not 3 whole numbers in range"),
        (changed("3 2 2", "3 -2 2"), "line 4: `3 -2 2` is not 3"),
        (changed("3 2 2", "3 0 2"), "line 4: `sizes: 3 0 2` has no voxels"),
        (changed("3 2 2", "3 2 3"), "the header promises 18 bytes of data from here, 12 are there"),
        (changed("3 2 2", "10000 10000 10000"), "promises 1000000000000 bytes of data from here, 12 are there"),
        (changed("3 2 2", "4294967295 4294967295 4294967295"), "more than any file holds"),
        (changed("encoding: raw", "encoding: bzip2"), "line 5: the encoding `bzip2` is not raw, gzip, text or hex"),
        (changed("encoding: raw", "encoding: rar"), "line 5: `rar` is not an encoding"),
        (changed("uint8", "int16"), "the header has no `endian`, which int16 samples in raw need"),
        (
            attached(&nrrd("int16", "raw", "endian: middle\n"), &[0; 24]),
            "line 6: `endian: middle` is neither little nor big",
        ),
        (with("type: int8\n"), "line 6: `type` was given in line 2 already"),
        (with("spacings: 1 1\n"), "line 6: `1 1` is not 3 numbers"),
        (with("space dimension: 2\n"), "a space of 2 dimensions, not 3"),
        (with("space directions: (1,0,0) (0,1,0) (1,1,0)\n"), "do not span space"),
        (with("space directions: (1,0) (0,1) (0,0)\n"), "is not 3 vector(s) of 3 numbers"),
        (with("space directions: none (0,1,0) (0,0,1)\n"), "`none` is an axis without extent in space"),
        (with("spacings: 1 1 1e38\n"), "the volume is 2e38 long, and 1e18 is the most"),
        (with("kinds: RGB-color domain domain\n"), "`rgb-color` is an axis without extent in space"),
        (with("byte skip: 5\n"), "promises 12 bytes of data from here, 7 are there"),
        (with("byte skip: -2\n"), "line 6: `byte skip: -2` with raw encoding"),
        (with("line skip: 9\n"), "the header skips 9 lines of data, 1 are there"),
        (attached(&nrrd("uint8", "gzip", "byte skip: 20\n"), &gzip(&DATA)), "skips 20 bytes of data, 12 are there"),
        (encoded("gzip", &DATA), "the data is damaged after 0 of 12 bytes"),
        (encoded("gzip", &gzip(&DATA[..11])), "the header promises 12 bytes of data, 11 were found"),
        (encoded("gzip", &gzip(&[1; 20])), "the header promises 12 bytes of data, 20 were found"),
        (encoded("gzip", &gzip(&[1; 1 << 20])), "12 bytes of data, at least 65548 were found"),
        (encoded("gzip", &damaged), "the data is damaged after 12 of 12 bytes"),
        (encoded("hex", b"01020304050607080910zz12"), "character 21 of the data, `z`, is not a hexadecimal digit"),
        (encoded("hex", b"0102030405060708091011  "), "the header promises 12 bytes of data, 11 were found"),
        (encoded("hex", &hex(&[1; 13])), "the header promises 12 bytes of data, 13 were found"),
        (encoded("text", b"1 2 3 4 5 6 7 8 9 10      "), "the header promises 12 numbers, 10 were found"),
        (encoded("text", b"1 2 3 4 5 6 7 8 9 10 11 12 13"), "`13` follows the 12 numbers"),
        (encoded("text", b"1 2 3 256 5 6 7 8 9 10 11 12"), "number 4 of the data, `256`, is not a uint8"),
        (encoded("text", b"1 2 3 four 5 6 7 8 9 10 11 12"), "number 4 of the data, `four`, is not a uint8"),
        (
            attached(&nrrd("double", "raw", "endian: little\n"), &huge),
            "all of the 12 voxels are NaN, infinite or beyond float32",
        ),
        (
            b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 1 1 1\nencoding: raw\n".to_vec(),
            "neither a `data file` nor a blank line",
        ),
        (b"NRRD?".to_vec(), "line 1: NRRD version `?` is not"),
        (b"not a nrrd\n".to_vec(), "line 1: `not a nrrd` is not `NRRD` and a version"),
        (b"".to_vec(), "line 1: `` is not `NRRD` and a version"),
    ];
    let folder = Folder::new();
    for (content, expected) in cases {
        let error = folder.open("broken.nrrd", content).expect_err(expected);
        let message = error.to_string();
        assert!(message.starts_with(&folder.shown("broken.nrrd")), "{message}");
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
        assert!(matches!(error, Error::Invalid { .. } | Error::Unsupported { .. }), "{error:?}");
    }
}

#[test]
fn broken_data_files() {
    let folder = Folder::new();
    let below = folder.path("below");
    std::fs::create_dir(&below).unwrap();
    folder.write("data", DATA);
    folder.write("slice1", &DATA[..6]);
    folder.write("slice2", &DATA[..5]);
    let absolute = folder.path("data");
    let absolute = format!("data file: {}", absolute.display());
    let cases = [
        ("data file: missing", "line 6: the data file `missing` cannot be read"),
        ("data file: ../data", "the data file `../data` is not below the header"),
        ("data file: x/../../data", "the data file `x/../../data` is not below the header"),
        (absolute.as_str(), "is not below the header"),
        ("data file:", "the data file `` is not below the header"),
        ("data file: below", "the data file `below` is not a regular file"),
        ("data file: slice%d 1 2 1", "slice2, byte 0: the header promises 6 bytes of data from here, 5 are there"),
        ("data file: slice%d 1 3 1", "3 data files for 2 slices"),
        ("data file: slice%d 1 2 0", "0 data files for 2 slices"),
        ("data file: slice%d 2 1 1", "0 data files for 2 slices"),
        ("data file: slice%d 0 2147483647 1", "2147483648 data files for 2 slices"),
        ("data file: slice%d 1 2 1 1", "2 data files for 4 rows"),
        ("data file: slice%d 1 2 1 7", "`7` is not the dimension of a file's data"),
        ("data file: slice%s 1 2 1", "`slice%s` is not a name with one number"),
        ("data file: slice%d%d 1 2 1", "`slice%d%d` is not a name with one number"),
        ("data file: slice%999d 1 2 1", "is not a name with one number"),
        ("data file: LIST\nslice1", "1 data files for 2 slices"),
        ("data file: LIST 3", "0 data files for equal slabs of 2 slices"),
        ("data file: LIST\nslice1\n../slice1", "`../slice1` is not below the header"),
    ];
    for (field, expected) in cases {
        let header = nrrd("uint8", "raw", &format!("{field}\n"));
        let message = folder.open("broken.nhdr", header.trim_end()).expect_err(field).to_string();
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_is_refused_rather_than_waited_for() {
    let folder = Folder::new();
    let pipe = folder.path("pipe");
    if !std::process::Command::new("mkfifo").arg(&pipe).status().is_ok_and(|status| status.success()) {
        return;
    }
    let header = nrrd("uint8", "raw", "data file: pipe\n");
    let message = folder.open("a.nhdr", header).unwrap_err().to_string();
    assert!(message.contains("`pipe` is not a regular file"), "{message}");
    let message = vitrum_io::open(&pipe, &OpenOptions::default()).unwrap_err().to_string();
    assert!(message.contains("this is a pipe or a device"), "{message}");
}

#[test]
fn broken_nifti_files() {
    let mut sheared = NiftiHeader::new(2, 1, false);
    sheared.i16(254, 1).f32(280, 1.0).f32(300, 1.0);
    let cases: Vec<(Vec<u8>, &str)> = vec![
        (nifti_u8(|header| header.put(345, b"x")), "this does not start with a NIfTI header"),
        (nifti_u8(|header| header.put(344, b"ni1")), "byte 344: this is the header of a NIfTI pair"),
        (nifti_u8(|header| header.put(0, &[0])), "this does not start with a NIfTI header"),
        (b"short".to_vec(), "this does not start with a NIfTI header"),
        (nifti_u8(|header| header.i16(40, 9)), "byte 40: dim[0] is 9, not a number of dimensions from 1 to 7"),
        (nifti_u8(|header| header.i16(40, 2)), "byte 40: the data has 2 dimensions"),
        (
            nifti_u8(|header| header.i16(40, 5).i16(50, 30)),
            "the header promises 360 bytes of data from here, 12 are there",
        ),
        (
            nifti_u8(|header| header.i16(40, 5).i16(50, 3)),
            "the header promises 36 bytes of data from here, 12 are there",
        ),
        (nifti_u8(|header| header.i16(44, 0)), "byte 44: dim[2] is 0, not a size of at least 1"),
        (nifti_u8(|header| header.i16(46, -5)), "byte 46: dim[3] is -5"),
        (
            nifti_u8(|header| header.i16(46, 3)),
            "byte 352: the header promises 18 bytes of data from here, 12 are there",
        ),
        (gzip(&nifti_u8(|header| header.i16(46, 3))), "the header promises 18 bytes of data, 12 were found"),
        (gzip(&nifti_u8(|header| header.i16(46, 1))), "the header promises 6 bytes of data, 12 were found"),
        (gzip(&nifti_u8(|header| header.i16(42, 32767).i16(44, 32767))), "bytes can hold"),
        (nifti_u8(|header| header.i16(70, 128)), "the header promises 36 bytes of data from here, 12 are there"),
        (nifti_u8(|header| header.i16(70, 32)), "byte 70: the samples are complex numbers"),
        (nifti_u8(|header| header.i16(70, 77)), "byte 70: the samples are of the unknown type 77"),
        (nifti_u8(|header| header.f32(108, 100.0)), "byte 108: vox_offset is 100"),
        (nifti_u8(|header| header.f32(108, f32::INFINITY)), "byte 108: vox_offset is inf"),
        (
            nifti_u8(|header| header.f32(108, 1e9)),
            "byte 1000000000: the header promises 12 bytes of data from here, 0 are there",
        ),
        (nifti_u8(|header| header.f32(112, f32::INFINITY)), "byte 112: scl_slope is inf and scl_inter 0"),
        (gzip(&nifti_u8(|header| header))[..40].to_vec(), "this does not start with a NIfTI header"),
    ];
    let folder = Folder::new();
    for (content, expected) in cases {
        let message = folder.open("broken.nii", content).expect_err(expected).to_string();
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
    }
}

#[test]
fn files_of_no_known_kind() {
    let folder = Folder::new();
    let message = folder.open("a.txt", "hello").unwrap_err().to_string();
    assert!(message.contains("NRRD (.nrrd, .nhdr), NIfTI (.nii, .nii.gz, "), "{message}");
    let missing = vitrum_io::open(&folder.path("missing.nrrd"), &OpenOptions::default());
    assert!(matches!(missing, Err(Error::Unreadable { .. })));
    let here = vitrum_io::open(&folder.path("."), &OpenOptions::default());
    assert!(here.unwrap_err().to_string().contains("this is a folder"));
}

#[test]
fn places_are_there_for_programs_too() {
    let error = Folder::new().open("a.nrrd", with("spacings: 1 1\n")).unwrap_err();
    assert!(matches!(error, Error::Invalid { place: Place::Line(6), .. }));
}
